#include "expression/minibex_expression.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/nearest_name.h"
#include "expression/parser.h"

namespace gcslab::minibex {
namespace {

/// What expanding loops, sums and functions may cost, in numbers and names that are read.
constexpr std::size_t kMaximumSteps = 4'000'000;
constexpr long kMaximumRounds = 1'000'000;

/// Functions of Minibex and the like that we have no operation for.
constexpr std::array<std::string_view, 16> kUnsupported = {
    "diff",  "atan2", "sign", "cosh",    "sinh", "tanh", "acosh", "asinh",
    "atanh", "floor", "ceil", "integer", "chi",  "inf",  "mid",   "sup"};

/// The operation of a function of one argument.
std::optional<Operation> function_of_one_argument(std::string_view name) {
  if (name == "ln") return Operation::log;
  const std::optional<Operation> operation = function_named(name);
  if (!operation || info(*operation).operands != 1 || *operation == Operation::cbrt) return std::nullopt;
  return operation;
}

}  // namespace

void ExpressionReader::charge(std::size_t steps) {
  steps_ += steps;
  if (steps_ > kMaximumSteps) {
    tokens_.fail(tokens_.peek().line, "takes more than " + std::to_string(kMaximumSteps) +
                                          " steps to write out its loops, sums and functions");
  }
}

Token ExpressionReader::new_name(const std::string& what) {
  const Token token = tokens_.peek();
  if (token.kind != Token::Kind::name || is_reserved(token.text)) tokens_.fail_expected(what);
  return tokens_.next();
}

void ExpressionReader::define(Scope& scope, const Token& name, Symbol&& symbol) {
  if (!scope.define(name.text, std::move(symbol))) {
    tokens_.fail(name.line, described(name) + " is defined twice; expected a new name");
  }
}

long ExpressionReader::integer(const Scope& scope, const std::string& what) {
  const int line = tokens_.peek().line;
  const Expression value = expression(scope);
  constexpr long kLargest = 1'000'000'000;
  const bool fits =
      value.is_constant() && value.constant().get_den() == 1 && abs(value.constant()) <= kLargest;
  if (!fits) tokens_.fail(line, "expected an integer constant as " + what);
  return value.constant().get_num().get_si();
}

ExpressionReader::Rounds ExpressionReader::rounds(const Scope& scope) {
  const int line = tokens_.peek().line;
  const long first = integer(scope, "the first value");
  tokens_.expect(":", "between the first and the last value");
  const long last = integer(scope, "the last value");
  if (last - first >= kMaximumRounds) {
    tokens_.fail(line, "goes from " + std::to_string(first) + " to " + std::to_string(last) +
                           "; expected at most " + std::to_string(kMaximumRounds) + " values");
  }
  return {first, last};
}

Expression ExpressionReader::expression(const Scope& scope) {
  const TokenStream::Nesting guard(tokens_);
  Expression result = product(scope);
  while (true) {
    const int line = tokens_.peek().line;
    if (tokens_.accept("+")) {
      const Expression next = product(scope);
      result = tokens_.at_line(line, [&] { return result + next; });
    } else if (tokens_.accept("-")) {
      const Expression next = product(scope);
      result = tokens_.at_line(line, [&] { return result - next; });
    } else {
      return result;
    }
  }
}

Expression ExpressionReader::product(const Scope& scope) {
  Expression result = unary(scope);
  while (true) {
    const int line = tokens_.peek().line;
    if (tokens_.accept("*")) {
      const Expression next = unary(scope);
      result = tokens_.at_line(line, [&] { return result * next; });
    } else if (tokens_.accept("/")) {
      if (tokens_.peek().is("-")) tokens_.fail_expected("a divisor; write a negative one in parentheses");
      const Expression next = unary(scope);
      result = tokens_.at_line(line, [&] { return result / next; });
    } else {
      return result;
    }
  }
}

Expression ExpressionReader::unary(const Scope& scope) {
  bool is_negative = false;
  while (tokens_.peek().is("-") || tokens_.peek().is("+")) is_negative ^= tokens_.next().is("-");
  const Expression operand = power(scope);
  return is_negative ? -operand : operand;
}

Expression ExpressionReader::power(const Scope& scope) {
  const Expression base = primary(scope);
  const int line = tokens_.peek().line;
  if (!tokens_.accept("^")) return base;
  if (tokens_.peek().is("-")) tokens_.fail_expected("an exponent; write a negative one in parentheses");
  const Expression exponent = primary(scope);
  if (!exponent.is_constant()) {
    tokens_.fail(line, "expected a rational constant as exponent; write exp(y*ln(x)) for x^y");
  }
  if (tokens_.peek().is("^")) tokens_.fail_expected("one exponent; write (x^2)^3 or x^(2^3)");
  return tokens_.at_line(line, [&] { return real_power(base, exponent.constant()); });
}

/// IBEX takes powers with fractional exponents by logarithms: they have nonnegative bases only. Our odd roots
/// are defined for negative numbers too; a square root keeps those out: x^(1/3) = sqrt(x)^(2/3) for x >= 0.
Expression ExpressionReader::real_power(Expression base, const Rational& exponent) {
  const bool is_odd_root = exponent.get_den() != 1 && mpz_odd_p(exponent.get_den_mpz_t()) != 0;
  if (!is_odd_root || is_visibly_nonnegative(base)) return graph_.power(base, exponent);
  return graph_.power(graph_.apply(Operation::sqrt, base), 2 * exponent);
}

Expression ExpressionReader::primary(const Scope& scope) {
  charge(1);
  const Token token = tokens_.peek();
  if (token.kind == Token::Kind::number) {
    tokens_.next();
    return graph_.constant(tokens_.at_line(token.line, [&] { return value_of(token); }));
  }
  if (token.kind == Token::Kind::name) return name(scope);
  if (token.is("[")) return interval(scope);
  if (!tokens_.accept("(")) tokens_.fail_expected("a number, a name or '('");
  const Expression inner = expression(scope);
  if (tokens_.peek().is(",") || tokens_.peek().is(";")) {
    tokens_.fail_expected("')' (vectors are read as constants and domains only)");
  }
  tokens_.expect(")", "after the expression in parentheses");
  return inner;
}

/// [a, b] as a number: a and b must be equal.
Expression ExpressionReader::interval(const Scope& scope) {
  const int line = tokens_.next().line;
  const Expression lower = expression(scope);
  tokens_.expect(",", "between the ends of the interval");
  const Expression upper = expression(scope);
  tokens_.expect("]", "after the interval");
  if (lower != upper) tokens_.fail(line, "expected a number, not an interval: coefficients must be exact");
  return lower;
}

Expression ExpressionReader::name(const Scope& scope) {
  const Token token = tokens_.next();
  const Symbol* symbol = scope.find(token.text);
  if (symbol == nullptr) return builtin(token, scope);
  if (const auto* constants = std::get_if<ConstantArray>(symbol)) return entry(token, *constants, scope);
  if (const auto* variables = std::get_if<ExpressionArray>(symbol)) return entry(token, *variables, scope);
  if (const auto* function = std::get_if<Function>(symbol)) return call(token, *function, scope);
  refuse_index(token);
  if (const auto* counter = std::get_if<Counter>(symbol)) return graph_.constant(counter->value);
  const auto& abbreviation = std::get<Abbreviation>(*symbol);
  abbreviation.is_used = true;
  return abbreviation.value;
}

Expression ExpressionReader::builtin(const Token& name, const Scope& scope) {
  if (name.text == "pi") return graph_.pi();
  if (std::ranges::find(kUnsupported, name.text) != kUnsupported.end()) {
    tokens_.fail(name.line, "the function " + described(name) +
                                " is not supported; expected exp, ln, sqr, sqrt, sin, cos, tan, asin, acos, "
                                "atan, abs, min, max or sum");
  }
  if (name.text == "oo" || name.text == "infinity") {
    tokens_.fail(name.line, described(name) + " is no number; expected it as an end of an interval only");
  }
  const bool is_call = tokens_.peek().is("(");
  if (name.text == "sum" && is_call) return sum(scope);
  if (name.text == "min" && is_call) return extremum(Operation::min, scope);
  if (name.text == "max" && is_call) return extremum(Operation::max, scope);
  const std::optional<Operation> operation = function_of_one_argument(name.text);
  if (!operation || !is_call) {
    tokens_.fail(name.line, is_reserved(name.text)
                                ? "expected an expression, not " + described(name)
                                : unknown_name_message("name", std::string(name.text), scope.known_names()));
  }
  tokens_.expect("(", "after the function");
  const Expression argument = expression(scope);
  tokens_.expect(")", "after the argument of " + std::string(name.text));
  return tokens_.at_line(name.line, [&] { return graph_.apply(*operation, argument); });
}

Expression ExpressionReader::extremum(Operation operation, const Scope& scope) {
  tokens_.expect("(", "after the function");
  Expression result = expression(scope);
  if (!tokens_.peek().is(",")) tokens_.fail_expected("',' and a second argument");
  while (tokens_.accept(",")) result = graph_.apply(operation, result, expression(scope));
  tokens_.expect(")", "after the arguments");
  return result;
}

/// sum(i=1:n, term)
Expression ExpressionReader::sum(const Scope& scope) {
  tokens_.expect("(", "after sum");
  const Token counter = new_name("a new name to count with");
  tokens_.expect("=", "after the name");
  const Rounds range = rounds(scope);
  if (range.last < range.first) tokens_.fail(counter.line, "the sum has no term; expected first <= last");
  tokens_.expect(",", "before the term of the sum");
  const std::size_t start = tokens_.position();
  Expression result = graph_.constant(0);
  for (long i = range.first; i <= range.last; ++i) {
    tokens_.return_to(start);
    Scope inner(&scope);
    define(inner, counter, Counter{i});
    const Expression term = expression(inner);
    result = tokens_.at_line(counter.line, [&] { return result + term; });
  }
  tokens_.expect(")", "after the term of the sum");
  return result;
}

void ExpressionReader::refuse_index(const Token& name) {
  if (tokens_.peek().is("(") || tokens_.peek().is("[")) {
    tokens_.fail(name.line, described(name) + " is a number, no array; expected no index");
  }
}

std::size_t ExpressionReader::place(const Token& name, const Shape& shape, const Scope& scope) {
  std::vector<Index> indices;
  while (tokens_.peek().is("(") || tokens_.peek().is("[")) {
    const bool is_bracket = tokens_.next().is("[");
    do {
      if (tokens_.peek().is(":")) tokens_.fail_expected("one index; parts of arrays are not supported");
      const long value = integer(scope, "an index of " + std::string(name.text));
      indices.push_back({value, is_bracket ? IndexStyle::brackets : IndexStyle::parentheses});
    } while (tokens_.accept(","));
    tokens_.expect(is_bracket ? "]" : ")", "after the index");
  }
  if (tokens_.peek().is("'")) tokens_.fail_expected("an entry; transposition is not supported");
  if (indices.empty() && !shape.empty()) {
    tokens_.fail(name.line, described(name) + " is an array; expected one of its entries, as in x(1)");
  }
  if (!indices.empty() && shape.empty()) {
    tokens_.fail(name.line, described(name) + " is a number, no array; expected no index");
  }
  return tokens_.at_line(name.line, [&] { return place_of(shape, indices); });
}

Expression ExpressionReader::entry(const Token& name, const ConstantArray& array, const Scope& scope) {
  const Range& value = array.entries[place(name, array.shape, scope)];
  if (!value.is_point()) {
    tokens_.fail(name.line,
                 described(name) + " is an interval; expected a number, since coefficients must be exact");
  }
  return *value.lower;
}

Expression ExpressionReader::entry(const Token& name, const ExpressionArray& array, const Scope& scope) {
  return array.entries[place(name, array.shape, scope)];
}

Expression ExpressionReader::call(const Token& name, const Function& function, const Scope& scope) {
  const TokenStream::Nesting guard(tokens_);
  tokens_.expect("(", "after the function " + std::string(name.text));
  Scope inner(function.surroundings);
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    if (i > 0) tokens_.expect(",", "before the next argument of " + std::string(name.text));
    inner.define(function.parameters[i].name, argument(function.parameters[i], scope));
  }
  tokens_.expect(")", "after the arguments of " + std::string(name.text));
  const std::size_t end = tokens_.position();
  tokens_.return_to(function.body);
  const Expression result = body(inner);
  tokens_.return_to(end);
  return result;
}

ExpressionArray ExpressionReader::argument(const Function::Parameter& parameter, const Scope& scope) {
  if (parameter.shape.empty()) return {{}, {expression(scope)}};
  const Token name = tokens_.peek();
  const Symbol* symbol = scope.find(name.text);
  const auto* array = symbol == nullptr ? nullptr : std::get_if<ExpressionArray>(symbol);
  const auto same_size = [](const Dimension& a, const Dimension& b) { return a.size == b.size; };
  if (array == nullptr || !std::ranges::equal(array->shape, parameter.shape, same_size)) {
    tokens_.fail_expected("the name of an array as large as the parameter " + parameter.name);
  }
  tokens_.next();
  charge(array->entries.size());
  return {parameter.shape, array->entries};
}

/// (name = expression;)* return expression [;] end
Expression ExpressionReader::body(Scope& scope) {
  while (!is_keyword(tokens_.peek(), "return")) {
    const Token abbreviation = new_name("an assignment or 'return'");
    tokens_.expect("=", "after the name");
    const Expression value = expression(scope);
    tokens_.expect(";", "after the assignment");
    define(scope, abbreviation, Abbreviation{value, abbreviation.line});
  }
  tokens_.next();
  const Expression result = expression(scope);
  tokens_.accept(";");
  if (!is_keyword(tokens_.peek(), "end")) tokens_.fail_expected("'end' after the result");
  return result;
}

}  // namespace gcslab::minibex
