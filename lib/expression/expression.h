#pragma once

// Expressions as nodes of a hash-consed graph: equal subexpressions are one node, constants are exact
// rationals.
//
// Nodes are only ever appended, and a node comes after its operands, so a pass over the graph is a loop over
// indices. The graph simplifies what is exact and cannot enlarge the domain of definition: constants are
// folded, x+0, x*1, x^1 and -(-x) vanish, and 0*e becomes 0 when e is defined everywhere. x*x stays a product
// and is not turned into sqr(x): over intervals the two differ.

#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "expression/operation.h"
#include "interval/rational.h"

namespace gcslab {

class ExpressionGraph;

/// A node of a graph. Cheap to copy; equal handles are equal expressions. The graph must outlive it.
class Expression {
 public:
  Expression(ExpressionGraph* graph, std::uint32_t index) : graph_(graph), index_(index) {}

  ExpressionGraph& graph() const { return *graph_; }
  std::uint32_t index() const { return index_; }

  Operation operation() const;
  /// The operand with that number; it must exist.
  Expression operand(int number) const;
  /// The value of a constant.
  const Rational& constant() const;
  /// The number of a variable.
  int variable() const;
  /// The exponent of power_integer or power_rational.
  const Rational& exponent() const;

  bool is_constant() const { return operation() == Operation::constant; }
  bool is_constant(long value) const { return is_constant() && constant() == value; }
  /// Defined and continuous for all real values of the variables, as the form of the expression shows.
  bool is_total() const;

  friend bool operator==(const Expression&, const Expression&) = default;

 private:
  ExpressionGraph* graph_;
  std::uint32_t index_;
};

class ExpressionGraph {
 public:
  ExpressionGraph() = default;
  ExpressionGraph(const ExpressionGraph&) = delete;
  ExpressionGraph& operator=(const ExpressionGraph&) = delete;

  Expression constant(const Rational& value);
  Expression pi();
  /// The variable with that number, counted from 0.
  Expression variable(int number);
  /// Applies an operation without exponent to one or two operands of this graph.
  Expression apply(Operation operation, Expression a);
  Expression apply(Operation operation, Expression a, Expression b);
  /// base^exponent. Throws InputError when a constant power is undefined or has too many digits.
  Expression power(Expression base, const Rational& exponent);

  std::size_t size() const { return nodes_.size(); }
  Expression node(std::uint32_t index) { return {this, index}; }

 private:
  friend class Expression;
  struct Node {
    Operation operation;
    std::uint32_t a = 0;  ///< operand, or variable number, or index of a constant
    std::uint32_t b = 0;  ///< operand, or index of the constant exponent
    bool operator==(const Node&) const = default;
  };
  struct NodeHash {
    std::size_t operator()(const Node& node) const;
  };

  Expression intern(const Node& node);
  std::uint32_t intern_constant(const Rational& value);
  Expression fold(Operation operation, const Rational& a, const Rational& b);

  std::vector<Node> nodes_;
  std::vector<bool> total_;
  std::deque<Rational> constants_;
  std::unordered_map<Node, std::uint32_t, NodeHash> index_of_node_;
  std::unordered_map<std::string, std::uint32_t> index_of_constant_;
};

/// Which nodes of the graph the roots, all of one graph and at least one, are built from, themselves
/// included: a flag a node, up to the last root.
std::vector<bool> reachable_from(std::span<const Expression> roots);

Expression operator+(Expression a, Expression b);
Expression operator-(Expression a, Expression b);
Expression operator*(Expression a, Expression b);
Expression operator/(Expression a, Expression b);
Expression operator-(Expression a);
Expression sqr(Expression a);
Expression pow(Expression a, int exponent);

}  // namespace gcslab
