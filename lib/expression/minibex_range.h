#pragma once

// Domains and values of constants in Minibex files: intervals, vectors of them, sizes of arrays
// (minibex_reader.h describes the language).

#include <optional>
#include <span>
#include <vector>

#include "expression/minibex_expression.h"
#include "expression/minibex_scope.h"
#include "expression/token_stream.h"

namespace gcslab::minibex {

class RangeReader {
 public:
  /// Both must outlive the reader.
  RangeReader(TokenStream& tokens, ExpressionReader& expressions)
      : tokens_(tokens), expressions_(expressions) {}

  /// The sizes behind a name: nothing, [n], [m][n], [0..n], ...
  Shape shape(const Scope& scope);
  /// One range an entry: [a, b], a number, the name of a constant, or (r; r; ...). One range stands for all
  /// entries. Sizes must agree.
  std::vector<Range> ranges(const Shape& shape, const Scope& scope);

 private:
  Dimension dimension(const Scope& scope);
  Range range(const Scope& scope);
  std::optional<Expression> end(const Scope& scope, bool is_lower);
  void read_tuple(std::span<const Dimension> shape, const Scope& scope, std::vector<Range>& result);
  bool begins_tuple();
  const ConstantArray* whole_constant(const Scope& scope);

  TokenStream& tokens_;
  ExpressionReader& expressions_;
};

}  // namespace gcslab::minibex
