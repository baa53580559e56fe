#pragma once

// How expressions are written in a language: text, LaTeX, or the input of another program.
//
// A notation says of one node how it is written, in pieces: text, and operands in turn. `written` puts the
// pieces together without recursion, so that a sum of a million terms costs no stack. Parentheses appear
// where an operand binds less tightly than its place asks for, and only there.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "expression/expression.h"

namespace gcslab {

/// How tightly a written form binds. No form is `enclosed`: a place that asks for it always gets parentheses.
enum class Binding { sum = 0, product = 1, unary = 2, power = 3, atom = 4, enclosed = 5 };

/// A part of a written form: a text, an operand, or the sign of a product.
struct Piece {
  enum class Kind { text, operand, product_sign };

  static Piece of(std::string text) { return {Kind::text, std::move(text), std::nullopt, Binding::sum}; }
  static Piece of(Expression operand, Binding needed) { return {Kind::operand, {}, operand, needed}; }
  static Piece product_sign() { return {Kind::product_sign, {}, std::nullopt, Binding::sum}; }

  Kind kind;
  std::string text;                   ///< of a text; not empty
  std::optional<Expression> operand;  ///< of an operand
  Binding needed;                     ///< by the place of an operand
};

/// A node as it is written.
struct Form {
  std::vector<Piece> pieces;
  Binding binding;
};

class Notation {
 public:
  /// Variables are written by these names; they must outlive the notation.
  explicit Notation(std::span<const std::string> variables) : variables_(variables) {}
  virtual ~Notation() = default;

  virtual Form form(Expression e) const;
  virtual std::string opening() const { return "("; }
  virtual std::string closing() const { return ")"; }
  /// The sign between two factors, the second of which begins with `next`.
  virtual std::string product_sign(char next) const;

 protected:
  virtual Form constant(const Rational& value) const = 0;
  virtual Form pi() const = 0;
  virtual Form variable(int number) const;
  virtual Form sum(Expression e, const char* sign, Binding right) const;
  virtual Form negation(Expression e) const;
  virtual Form product(Expression e) const;
  virtual Form quotient(Expression e) const;
  virtual Form power(Expression e, const Rational& exponent) const = 0;
  virtual Form call(Expression e) const = 0;

  /// name(a) or name(a, b).
  static Form call_of(const std::string& name, Expression e);
  /// How a number binds: negative ones like sums, fractions as told.
  static Binding binding_of(const Rational& value, Binding of_fraction);

 private:
  std::span<const std::string> variables_;
};

/// The whole expression. Throws NotApplicable when it takes more than 2^24 characters, which happens when a
/// small graph shares its parts many times.
std::string written(Expression expression, const Notation& notation);

}  // namespace gcslab
