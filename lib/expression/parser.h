#pragma once

// The expression language of problem files.
//
//   sum      = product (("+" | "-") product)*
//   product  = unary (("*" | "/") unary)*
//   unary    = ("-" | "+") unary | power
//   power    = atom ["^" unary]              right associative; binds tighter than unary minus: -x^2 = -(x^2)
//   atom     = number | variable | "pi" | function "(" sum ["," sum] ")" | "(" sum ")"
//
// A decimal literal is the exact rational that it spells; an exponent is a rational constant.

#include <span>
#include <string>
#include <string_view>

#include "expression/expression.h"

namespace gcslab {

/// Deeper nesting is refused by every reader of expressions, so that hostile input cannot exhaust the stack.
inline constexpr int kMaximumNesting = 400;

/// Parses an expression in the named variables into `graph`. Throws InputError that quotes the text and tells
/// the column (from 1) and what was expected.
Expression parse_expression(ExpressionGraph& graph, std::string_view text,
                            std::span<const std::string> variables);

/// Parses "lhs = rhs" into lhs - rhs, or an expression that is to vanish.
Expression parse_equation(ExpressionGraph& graph, std::string_view text,
                          std::span<const std::string> variables);

/// Parses "lhs <= rhs" or "lhs >= rhs" into an expression that is to be <= 0.
Expression parse_inequality(ExpressionGraph& graph, std::string_view text,
                            std::span<const std::string> variables);

/// True for a letter or underscore followed by letters, digits, underscores; not a function's name and not
/// pi.
bool is_variable_name(std::string_view name);

}  // namespace gcslab
