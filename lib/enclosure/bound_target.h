#pragma once

// What a range bound is made for: a function of n variables, and its polynomial where it is one.

#include <memory>
#include <optional>
#include <string>

#include "expression/expression.h"
#include "polynomial/polynomial.h"

namespace gcslab {

class BoundTarget {
 public:
  /// Recognises the polynomial of `function` if it is one. The target shares the graph.
  BoundTarget(std::shared_ptr<ExpressionGraph> graph, Expression function, int variables);

  ExpressionGraph& graph() const { return *graph_; }
  Expression function() const { return function_; }
  int variables() const { return variables_; }

  bool is_polynomial() const { return polynomial_ != nullptr; }
  /// The exact polynomial. Throws NotApplicable, with what makes it none, when there is none.
  const Polynomial& polynomial() const;

 private:
  std::shared_ptr<ExpressionGraph> graph_;
  Expression function_;
  int variables_;
  std::shared_ptr<const Polynomial> polynomial_;
  std::string why_no_polynomial_;
};

}  // namespace gcslab
