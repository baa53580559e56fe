#pragma once

// Terms of a system as further variables, and the system as polynomials where that makes it so.
//
// Terms are expressions inside the functions of the system, t_0, t_1, .., in an order in which each comes
// after those inside it; they get the variables after x_0 .. x_{n-1} and stand for their expression wherever
// it occurs. The equations of the lifted system are those of the system, then what is true of each term in
// turn: t = e for sums, products and powers, t d = e for e / d, t^2 = e for sqrt(e), t e^k = 1 for e^-k,
// nothing for others. So whatever expressions are named: where x solves the system, x followed by the values
// of the terms at x solves the lifted one.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "verifier/judged_system.h"

namespace gcslab::verifier {

class LiftedTerms {
 public:
  /// `system` must outlive it.
  explicit LiftedTerms(JudgedSystem& system);

  /// Names the next term: an expression inside a function, found by the numbers of operands from the root.
  /// False when there is none there, or it is named twice.
  [[nodiscard]] bool add(bool is_equation, std::size_t function, const std::vector<std::size_t>& operands);

  std::size_t size() const { return terms_.size(); }
  /// The number of variables before them.
  std::size_t size_before() const { return original_->variables(); }
  /// With the terms named so far; none may follow.
  JudgedSystem& system();

  /// Whether the value of each term lies in its side for every point of the box.
  bool lie_within(const Box& sides, const Box& box);

  /// The variable of which a term is a function of one argument.
  std::optional<std::size_t> argument(std::size_t term) const;
  /// Encloses t - slope x over an interval of the argument x. The term has one.
  Range strip(std::size_t term, double slope, const Interval& x);

 private:
  struct NamedTerm {
    Expression expression;
    Program program;
    std::unique_ptr<ExpressionGraph> graph;  ///< of one variable
    std::optional<Program> function;         ///< of its argument, in that graph
    Interval side{};                         ///< of the argument, of
    std::map<double, Range> strips{};        ///< what is known of strips over it, by slope
  };

  Expression lifted(Expression e);
  Expression rebuilt(Expression e);
  std::optional<Expression> relation(Expression e);
  static void make_function(NamedTerm& term);
  static Range strip_over(Program& function, double slope, const Interval& x);

  JudgedSystem* original_;
  std::vector<NamedTerm> terms_;
  EquationSystem system_;                     ///< the lifted one
  std::map<std::uint32_t, Expression> done_;  ///< in its graph, by number of the node
  std::optional<JudgedSystem> judged_;
};

}  // namespace gcslab::verifier
