#pragma once

// One function of a system as the list of the nodes of its expression, operands first.
//
// Three promises about a box: `evaluate` encloses the values of the function; `gradient` encloses its slopes,
// so that for p, q in the box there are s_i in it with f(p) - f(q) = sum s_i (p_i - q_i), where the function
// is defined and continuous everywhere in the box; `propagate` keeps every point at which the function has a
// value in the target (HC4-revise, Benhamou, Goualard, Granvilliers, Puget 1999). Sweeps visit the nodes in
// the order of the graph, as the solvers' do, so that enclosures are at least as tight as theirs.

#include <cstdint>
#include <span>
#include <vector>

#include "expression/expression.h"
#include "verifier/range.h"

namespace gcslab::verifier {

class Program {
 public:
  /// `variables` is the number of variables of the system.
  Program(Expression expression, std::size_t variables);

  /// The variables that occur, ascending.
  const std::vector<std::size_t>& variables() const { return variables_; }

  const Range& evaluate(std::span<const Range> box);

  /// After evaluate: every operation is defined and continuous on all of its operands.
  bool is_defined_everywhere() const;

  /// After evaluate, where is_defined_everywhere. One range a variable of the system.
  const std::vector<Range>& gradient();
  /// After gradient: an upper bound of the rounding error of evaluating the function in doubles at the point
  /// of the last evaluation, to first order and generously: 16 units in the last place an operation.
  double double_rounding_error() const;

  /// False: no point of the box has a value in the target. True: what `narrowed` says is left of the box.
  bool propagate(std::span<const Range> box, const Range& target);
  const Range& narrowed(std::size_t variable) const { return values_[place_of_variable_[variable]]; }

 private:
  struct Node {
    Operation operation;
    std::uint32_t a = 0, b = 0;  ///< places of operands
    Rational exponent;
  };
  static constexpr std::uint32_t kNowhere = ~std::uint32_t{0};

  void forward(std::span<const Range> box);
  Range value_of(const Node& node) const;
  bool is_defined(const Node& node, const Range& value) const;
  bool is_constant(std::uint32_t place) const;
  Range outer_derivative(const Node& node, const Range& value) const;
  void add_adjoint(std::uint32_t place, const Range& contribution);
  void add_adjoints(const Node& node, const Range& value, const Range& adjoint);
  bool replace(std::uint32_t place, const Range& value);
  bool narrow_operands(const Node& node, const Range& z);
  Range narrowed_operand(const Node& node, const Range& z) const;
  Range narrowed_first(const Node& node, const Range& z) const;
  Range narrowed_second(const Node& node, const Range& z) const;

  std::vector<Node> nodes_;  ///< the last one is the function
  std::vector<std::uint32_t> place_of_variable_;
  std::vector<std::size_t> variables_;
  std::vector<Range> values_;
  std::vector<Range> adjoints_;
  std::vector<bool> has_adjoint_;
  std::vector<Range> gradient_;
};

}  // namespace gcslab::verifier
