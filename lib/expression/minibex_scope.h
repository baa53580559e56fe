#pragma once

// What the names of a Minibex file stand for (minibex_reader.h describes the language).

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "expression/expression.h"
#include "expression/token_stream.h"
#include "interval/interval.h"

namespace gcslab::minibex {

/// One direction of an array: x[12] has the indices 1 .. 12, x[0..5] says which.
struct Dimension {
  long size;
  std::optional<long> first = std::nullopt;  ///< the least index, if the file says it
};

/// The directions of an array; none for a scalar.
using Shape = std::vector<Dimension>;

std::size_t number_of_entries(const Shape& shape);

/// How an index is written: x(1) counts from 1, x[0] from 0, as IBEX does. An array that says its least index
/// counts from there both ways.
enum class IndexStyle { parentheses, brackets };

struct Index {
  long value;
  IndexStyle style;
};

/// The place of an entry, row by row. A row vector x[1][n] may be indexed like a vector. Throws InputError,
/// without a place, when the number of indices or one of them does not fit.
std::size_t place_of(const Shape& shape, std::span<const Index> indices);

/// A closed interval with exact ends; an end that is not there is infinite.
struct Range {
  std::optional<Expression> lower;
  std::optional<Expression> upper;

  /// True when both ends are one expression: equal numbers are.
  bool is_point() const { return lower && upper && *lower == *upper; }
};

/// The tightest doubles around a range. Throws InputError, without a place, when it is empty or undefined.
Interval enclosure(const Range& range);

struct ConstantArray {
  Shape shape;
  std::vector<Range> entries;
};

/// Variables, or arguments of a function that is being expanded.
struct ExpressionArray {
  Shape shape;
  std::vector<Expression> entries;
};

/// A name for a part of a function or constraint.
struct Abbreviation {
  Expression value;
  int line;
  mutable bool is_used = false;
};

/// The variable of a loop or sum.
struct Counter {
  long value;
};

class Scope;

/// A function is expanded where it is called: its text is read again with the arguments in place.
struct Function {
  struct Parameter {
    std::string name;
    Shape shape;
  };
  std::vector<Parameter> parameters;
  std::size_t body;           ///< position of the first word after the parameters
  const Scope* surroundings;  ///< what the body sees besides its parameters
};

using Symbol = std::variant<ConstantArray, ExpressionArray, Abbreviation, Counter, Function>;

/// Names, with those of the surroundings. Inner names hide outer ones.
class Scope {
 public:
  explicit Scope(const Scope* surroundings = nullptr) : surroundings_(surroundings) {}
  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;

  /// The meaning of a name, or nullptr.
  const Symbol* find(std::string_view name) const;
  /// False when this very scope has the name already.
  bool define(std::string_view name, Symbol&& symbol);
  const std::map<std::string, Symbol, std::less<>>& own() const { return symbols_; }
  std::vector<std::string> known_names() const;

 private:
  const Scope* surroundings_;
  std::map<std::string, Symbol, std::less<>> symbols_;
};

/// True when the form of the expression shows that its values, where it has any, are nonnegative. Only such
/// bases have all their powers with fractional exponents in Minibex.
bool is_visibly_nonnegative(Expression e);

/// How the words of the language look.
LexicalRules words();

/// True for the keyword in one of the three forms that are allowed: end, End, END.
bool is_keyword(const Token& token, std::string_view lower_case);

/// Words that no user may give a meaning to: keywords, functions, pi, oo.
bool is_reserved(std::string_view name);

}  // namespace gcslab::minibex
