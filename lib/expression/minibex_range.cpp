#include "expression/minibex_range.h"

#include <algorithm>
#include <string>

namespace gcslab::minibex {
namespace {

constexpr std::size_t kMaximumEntries = 100'000;

bool ends_value(const Token& token) {
  return token.is(";") || token.is(",") || token.is(")") || token.kind == Token::Kind::end;
}

bool is_infinity(const Token& token) {
  return token.kind == Token::Kind::name &&
         (token.text == "oo" || token.text == "infinity" || token.text == "inf");
}

}  // namespace

Dimension RangeReader::dimension(const Scope& scope) {
  const int line = tokens_.peek().line;
  const long number = expressions_.integer(scope, "the size of an array");
  Dimension result{number};
  if (tokens_.accept("..")) {
    const long last = expressions_.integer(scope, "the last index of an array");
    result = {last - number + 1, number};
  }
  if (result.size < 1) tokens_.fail(line, "an array has no entry; expected a size of at least 1");
  return result;
}

Shape RangeReader::shape(const Scope& scope) {
  Shape result;
  std::size_t entries = 1;
  while (tokens_.accept("[")) {
    result.push_back(dimension(scope));
    tokens_.expect("]", "after the size");
    entries *= static_cast<std::size_t>(result.back().size);
    if (entries > kMaximumEntries) {
      tokens_.fail(tokens_.peek().line,
                   "an array has more than " + std::to_string(kMaximumEntries) + " entries");
    }
  }
  expressions_.charge(entries);
  return result;
}

/// The constant whose name is the whole value that comes next.
const ConstantArray* RangeReader::whole_constant(const Scope& scope) {
  if (tokens_.peek().kind != Token::Kind::name || !ends_value(tokens_.peek(1))) return nullptr;
  const Symbol* symbol = scope.find(tokens_.peek().text);
  return symbol == nullptr ? nullptr : std::get_if<ConstantArray>(symbol);
}

/// True at a parenthesis that holds a comma or semicolon of its own.
bool RangeReader::begins_tuple() {
  if (!tokens_.peek().is("(")) return false;
  int depth = 0;
  for (std::size_t ahead = 0; tokens_.peek(ahead).kind != Token::Kind::end; ++ahead) {
    const Token& token = tokens_.peek(ahead);
    if (token.is("(") || token.is("[")) ++depth;
    if (token.is(")") || token.is("]")) --depth;
    if (depth == 0) return false;
    if (depth == 1 && (token.is(",") || token.is(";"))) return true;
  }
  return false;
}

std::vector<Range> RangeReader::ranges(const Shape& shape, const Scope& scope) {
  const std::size_t entries = number_of_entries(shape);
  expressions_.charge(entries);
  if (const ConstantArray* constant = whole_constant(scope);
      constant != nullptr && !constant->shape.empty()) {
    const auto same_size = [](const Dimension& a, const Dimension& b) { return a.size == b.size; };
    if (!std::ranges::equal(constant->shape, shape, same_size)) {
      tokens_.fail_expected("a value with as many entries as the array");
    }
    tokens_.next();
    return constant->entries;
  }
  if (!shape.empty() && begins_tuple()) {
    std::vector<Range> result;
    result.reserve(entries);
    const bool is_row = shape.size() == 2 && shape.front().size == 1;
    read_tuple(std::span(shape).subspan(is_row ? 1 : 0), scope, result);
    return result;
  }
  return std::vector<Range>(entries, range(scope));
}

/// (a; b; c), or (a, b, c); matrices are vectors of rows: ((a, b); (c, d)).
void RangeReader::read_tuple(std::span<const Dimension> shape, const Scope& scope,
                             std::vector<Range>& result) {
  tokens_.expect("(", "before the entries");
  const std::span<const Dimension> inner = shape.subspan(1);
  for (long i = 0; i < shape.front().size; ++i) {
    if (i > 0 && !tokens_.accept(";") && !(inner.empty() && tokens_.accept(","))) {
      tokens_.fail_expected("';' and entry " + std::to_string(i + 1) + " of " +
                            std::to_string(shape.front().size));
    }
    if (inner.empty()) {
      result.push_back(range(scope));
    } else {
      read_tuple(inner, scope, result);
    }
  }
  tokens_.expect(")", "after the " + std::to_string(shape.front().size) + " entries");
}

Range RangeReader::range(const Scope& scope) {
  if (const ConstantArray* constant = whole_constant(scope); constant != nullptr && constant->shape.empty()) {
    tokens_.next();
    return constant->entries.front();
  }
  if (!tokens_.accept("[")) {
    const Expression value = expressions_.expression(scope);
    return {value, value};
  }
  const std::optional<Expression> lower = end(scope, true);
  tokens_.expect(",", "between the ends of the interval");
  const std::optional<Expression> upper = end(scope, false);
  tokens_.expect("]", "after the interval");
  return {lower, upper};
}

/// An end of an interval; none where it is infinite.
std::optional<Expression> RangeReader::end(const Scope& scope, bool is_lower) {
  const bool has_sign = tokens_.peek().is("+") || tokens_.peek().is("-");
  const Token& word = tokens_.peek(has_sign ? 1 : 0);
  if (!is_infinity(word) || scope.find(word.text) != nullptr) return expressions_.expression(scope);
  const bool is_minus = tokens_.peek().is("-");
  if (is_minus != is_lower) {
    tokens_.fail_expected(is_lower ? "a number or -oo as the lower end" : "a number or +oo as the upper end");
  }
  if (has_sign) tokens_.next();
  tokens_.next();
  return std::nullopt;
}

}  // namespace gcslab::minibex
