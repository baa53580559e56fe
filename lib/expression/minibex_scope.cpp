#include "expression/minibex_scope.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "base/error.h"
#include "expression/constant_enclosure.h"

namespace gcslab::minibex {
namespace {

std::string capitalised(std::string_view lower_case) {
  std::string result(lower_case);
  result.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(result.front())));
  return result;
}

std::string upper_case(std::string_view lower_case) {
  std::string result(lower_case);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

bool is_one_of_three_forms(std::string_view name, std::string_view lower_case) {
  return name == lower_case || name == capitalised(lower_case) || name == upper_case(lower_case);
}

bool has_variables(Expression e) {
  const std::vector<bool> reached = reachable_from(std::span(&e, 1));
  for (std::uint32_t i = 0; i < reached.size(); ++i) {
    if (reached[i] && e.graph().node(i).operation() == Operation::variable) return true;
  }
  return false;
}

Interval enclosure_of_end(const std::optional<Expression>& end) {
  if (!end) return Interval::entire();
  if (end->is_constant()) return constant_enclosure(*end);
  if (has_variables(*end)) throw InputError("the interval has variables in it; expected constant ends");
  const Interval result = constant_enclosure(*end);
  if (is_empty(result)) throw InputError("an end of the interval is not defined");
  return result;
}

long place_along(const Dimension& dimension, const Index& index) {
  const long least = dimension.first.value_or(index.style == IndexStyle::parentheses ? 1 : 0);
  const long place = index.value - least;
  if (place < 0 || place >= dimension.size) {
    const bool counts_from_0 = index.style == IndexStyle::brackets && !dimension.first;
    throw InputError("the index " + std::to_string(index.value) + " is outside " + std::to_string(least) +
                     " .. " + std::to_string(least + dimension.size - 1) +
                     (counts_from_0 ? "; x[i] counts from 0, write x(i) to count from 1" : ""));
  }
  return place;
}

}  // namespace

std::size_t number_of_entries(const Shape& shape) {
  std::size_t count = 1;
  for (const Dimension& dimension : shape) count *= static_cast<std::size_t>(dimension.size);
  return count;
}

std::size_t place_of(const Shape& shape, std::span<const Index> indices) {
  std::span<const Dimension> directions = shape;
  if (directions.size() == 2 && indices.size() == 1 && directions.front().size == 1) {
    directions = directions.subspan(1);
  }
  if (directions.size() != indices.size()) {
    throw InputError("has " + std::to_string(indices.size()) + " indices where " +
                     std::to_string(directions.size()) + " were expected");
  }
  std::size_t place = 0;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    place = place * static_cast<std::size_t>(directions[k].size) +
            static_cast<std::size_t>(place_along(directions[k], indices[k]));
  }
  return place;
}

Interval enclosure(const Range& range) {
  const Interval low = enclosure_of_end(range.lower);
  const Interval high = enclosure_of_end(range.upper);
  const bool both_exact =
      range.lower && range.upper && range.lower->is_constant() && range.upper->is_constant();
  const bool is_disordered =
      both_exact ? range.lower->constant() > range.upper->constant() : low.lower > high.upper;
  if (is_disordered) throw InputError("the lower end of the interval is greater than the upper end");
  return {low.lower, high.upper};
}

const Symbol* Scope::find(std::string_view name) const {
  for (const Scope* scope = this; scope != nullptr; scope = scope->surroundings_) {
    const auto found = scope->symbols_.find(name);
    if (found != scope->symbols_.end()) return &found->second;
  }
  return nullptr;
}

bool Scope::define(std::string_view name, Symbol&& symbol) {
  return symbols_.try_emplace(std::string(name), std::move(symbol)).second;
}

std::vector<std::string> Scope::known_names() const {
  std::vector<std::string> names;
  for (const Scope* scope = this; scope != nullptr; scope = scope->surroundings_) {
    for (const auto& [name, symbol] : scope->symbols_) names.push_back(name);
  }
  return names;
}

bool is_visibly_nonnegative(Expression e) {
  switch (e.operation()) {
    case Operation::constant:
      return e.constant() >= 0;
    case Operation::sqrt:
    case Operation::sqr:
    case Operation::abs:
    case Operation::exp:
      return true;
    case Operation::power_integer:
      return mpz_even_p(e.exponent().get_num_mpz_t()) != 0;
    case Operation::max:
      return e.operand(0).is_constant(0) || e.operand(1).is_constant(0);
    default:
      return false;
  }
}

LexicalRules words() {
  return {.line_comment = "//",
          .comment_opening = "/*",
          .comment_closing = "*/",
          .long_signs = {"<=", ">=", ":=", ".."},
          .hexadecimal_doubles = true};
}

bool is_keyword(const Token& token, std::string_view lower_case) {
  return token.kind == Token::Kind::name && is_one_of_three_forms(token.text, lower_case);
}

bool is_reserved(std::string_view name) {
  constexpr std::array<std::string_view, 10> kKeywords = {"constants", "variables",  "parameters", "function",
                                                          "minimize",  "return",     "begin",      "end",
                                                          "for",       "constraints"};
  constexpr std::array<std::string_view, 32> kWords = {
      "diff", "max",     "min",  "atan2", "sign", "abs",  "exp",  "ln",    "sqrt",  "cos",   "sin",
      "tan",  "acos",    "asin", "atan",  "cosh", "sinh", "tanh", "acosh", "asinh", "atanh", "floor",
      "ceil", "integer", "chi",  "in",    "inf",  "mid",  "sup",  "sum",   "pi",    "oo"};
  return std::ranges::any_of(kKeywords,
                             [name](std::string_view word) { return is_one_of_three_forms(name, word); }) ||
         std::ranges::find(kWords, name) != kWords.end();
}

}  // namespace gcslab::minibex
