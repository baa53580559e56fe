#pragma once

// Expressions of Minibex files (minibex_reader.h describes the language).

#include <cstddef>
#include <string>

#include "expression/expression.h"
#include "expression/minibex_scope.h"
#include "expression/token_stream.h"

namespace gcslab::minibex {

/// Reads expressions from a stream of words into a graph. Functions and sums are expanded: their words are
/// read again for each call and each term. Throws InputError with file and line.
class ExpressionReader {
 public:
  /// Both must outlive the reader.
  ExpressionReader(TokenStream& tokens, ExpressionGraph& graph) : tokens_(tokens), graph_(graph) {}

  /// sum = product (("+" | "-") product)*; product, powers and signs as usual, -x^2 = -(x^2).
  Expression expression(const Scope& scope);
  /// An expression whose value is an integer. `what` names it in errors.
  long integer(const Scope& scope, const std::string& what);
  /// The range first : last of a loop or sum.
  struct Rounds {
    long first, last;
  };
  Rounds rounds(const Scope& scope);

  /// Counts work that is done again and again when loops are expanded; fails when it is too much.
  void charge(std::size_t steps);

  /// A new name in a scope; fails for reserved words and for names that the scope has.
  void define(Scope& scope, const Token& name, Symbol&& symbol);
  /// Takes the next word, which must be a name that the user may choose.
  Token new_name(const std::string& what);

 private:
  Expression product(const Scope& scope);
  Expression unary(const Scope& scope);
  Expression power(const Scope& scope);
  Expression primary(const Scope& scope);
  Expression name(const Scope& scope);
  Expression builtin(const Token& name, const Scope& scope);
  Expression extremum(Operation operation, const Scope& scope);
  Expression sum(const Scope& scope);
  Expression interval(const Scope& scope);
  Expression call(const Token& name, const Function& function, const Scope& scope);
  Expression body(Scope& scope);
  ExpressionArray argument(const Function::Parameter& parameter, const Scope& scope);
  Expression entry(const Token& name, const ConstantArray& array, const Scope& scope);
  Expression entry(const Token& name, const ExpressionArray& array, const Scope& scope);
  std::size_t place(const Token& name, const Shape& shape, const Scope& scope);
  Expression real_power(Expression base, const Rational& exponent);
  void refuse_index(const Token& name);

  TokenStream& tokens_;
  ExpressionGraph& graph_;
  std::size_t steps_ = 0;
};

}  // namespace gcslab::minibex
