#include "expression/phc_reader.h"

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/error.h"
#include "expression/parser.h"
#include "expression/token_stream.h"
#include "expression/variable_names.h"

namespace gcslab {
namespace {

/// Complex numbers are raised to small powers only: there is no other way than to multiply.
constexpr int kMaximumComplexPower = 64;

LexicalRules phc_words() {
  return {
      .comment_opening = "{", .comment_closing = "}", .long_signs = {"**"}, .more_name_characters = "[].'"};
}

/// real + i*imaginary; most values have no imaginary part.
struct Complex {
  Expression real;
  std::optional<Expression> imaginary = std::nullopt;
};

Complex without_zero(Complex value) {
  if (value.imaginary && value.imaginary->is_constant(0)) value.imaginary.reset();
  return value;
}

Complex operator-(const Complex& a) {
  if (!a.imaginary) return {-a.real};
  return {-a.real, -*a.imaginary};
}

Complex operator+(const Complex& a, const Complex& b) {
  if (!b.imaginary) return {a.real + b.real, a.imaginary};
  if (!a.imaginary) return {a.real + b.real, b.imaginary};
  return without_zero({a.real + b.real, *a.imaginary + *b.imaginary});
}

Complex operator*(const Complex& a, const Complex& b) {
  if (!a.imaginary && !b.imaginary) return {a.real * b.real};
  const Expression zero = a.real.graph().constant(0);
  const Expression a_imaginary = a.imaginary.value_or(zero);
  const Expression b_imaginary = b.imaginary.value_or(zero);
  return without_zero(
      {a.real * b.real - a_imaginary * b_imaginary, a.real * b_imaginary + a_imaginary * b.real});
}

class PhcReader {
 public:
  PhcReader(std::string_view text, const std::string& file) : tokens_(text, file, phc_words()) {}

  EquationSystem read() {
    read_numbers();
    for (long i = 1; i <= equations_; ++i) read_polynomial(i);
    if (static_cast<long>(system_.variables.size()) < variables_) {
      tokens_.fail(1, "announces " + std::to_string(variables_) + " variables, but only " +
                          std::to_string(system_.variables.size()) + " appear in the polynomials");
    }
    system_.box.assign(system_.variables.size(), Interval::entire());
    return std::move(system_);
  }

 private:
  /// The first line: "n" or "n m".
  void read_numbers() {
    const int line = tokens_.peek().line;
    equations_ = variables_ = read_count("the number of equations");
    const Token& second = tokens_.peek();
    if (second.line == line && second.kind != Token::Kind::end) {
      variables_ = read_count("the number of variables, or a new line");
      if (tokens_.peek().line == line) tokens_.fail_expected("a new line after the number of variables");
    }
  }

  long read_count(const std::string& what) {
    const Token token = tokens_.peek();
    if (token.kind != Token::Kind::number) tokens_.fail_expected(what);
    const Rational value = tokens_.at_line(token.line, [&] { return value_of(token); });
    constexpr long kMost = 1'000'000;
    if (value.get_den() != 1 || value < 1 || value > kMost) tokens_.fail_expected(what);
    tokens_.next();
    return value.get_num().get_si();
  }

  void read_polynomial(long number) {
    if (tokens_.peek().kind == Token::Kind::end) {
      tokens_.fail_expected("polynomial " + std::to_string(number) + " of " + std::to_string(equations_));
    }
    const int line = tokens_.peek().line;
    line_of_unit_.reset();
    const Complex value = sum();
    tokens_.expect(";", "after polynomial " + std::to_string(number));
    if (value.imaginary) {
      tokens_.fail(line_of_unit_.value_or(line), "polynomial " + std::to_string(number) +
                                                     " has an imaginary part; expected real coefficients");
    }
    system_.equations.push_back(value.real);
  }

  struct Term {
    bool is_negative;
    Complex value;
  };

  Complex sum() {
    const TokenStream::Nesting guard(tokens_);
    std::vector<Term> terms;
    do {
      const bool is_negative = tokens_.peek().is("-");
      if (is_negative || tokens_.peek().is("+")) tokens_.next();
      if (tokens_.peek().is("-") || tokens_.peek().is("+")) {
        tokens_.fail_expected("one sign (PHCpack misreads two in a row; write x - (-2))");
      }
      terms.push_back({is_negative, product()});
    } while (tokens_.peek().is("+") || tokens_.peek().is("-"));
    return total(without_cancelled(std::move(terms)));
  }

  /// x - x sets the order of the variables. Its value is 0 wherever x is defined, but interval arithmetic
  /// would not find that.
  static std::vector<Term> without_cancelled(std::vector<Term> terms) {
    std::map<std::pair<std::uint32_t, bool>, std::vector<std::size_t>> waiting;
    std::vector<bool> cancelled(terms.size(), false);
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const Complex& value = terms[i].value;
      if (value.imaginary || !value.real.is_total()) continue;
      std::vector<std::size_t>& opposite = waiting[{value.real.index(), !terms[i].is_negative}];
      if (opposite.empty()) {
        waiting[{value.real.index(), terms[i].is_negative}].push_back(i);
      } else {
        cancelled[i] = cancelled[opposite.back()] = true;
        opposite.pop_back();
      }
    }
    std::vector<Term> result;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      if (!cancelled[i]) result.push_back(terms[i]);
    }
    return result;
  }

  Complex total(const std::vector<Term>& terms) {
    if (terms.empty()) return {graph().constant(0)};
    Complex result = terms.front().is_negative ? -terms.front().value : terms.front().value;
    for (std::size_t i = 1; i < terms.size(); ++i) {
      const Complex& next = terms[i].value;
      const bool is_real = !result.imaginary && !next.imaginary;
      if (terms[i].is_negative && is_real) {
        result = {result.real - next.real};
      } else {
        result = result + (terms[i].is_negative ? -next : next);
      }
    }
    return result;
  }

  Complex product() {
    Complex result = factor();
    while (true) {
      const int line = tokens_.peek().line;
      if (tokens_.accept("*")) {
        const Complex next = factor();
        result = tokens_.at_line(line, [&] { return result * next; });
      } else if (tokens_.accept("/")) {
        const Expression divisor = graph().constant(signed_number());
        result = tokens_.at_line(line, [&] { return quotient(result, divisor); });
      } else {
        return result;
      }
    }
  }

  static Complex quotient(const Complex& a, Expression divisor) {
    if (!a.imaginary) return {a.real / divisor};
    return {a.real / divisor, *a.imaginary / divisor};
  }

  /// What may follow a division: 1E9/-8.E-6.
  Rational signed_number() {
    const bool is_negative = tokens_.accept("-");
    if (tokens_.peek().kind != Token::Kind::number) {
      tokens_.fail_expected("a number to divide by (polynomials have no other quotients)");
    }
    const Token token = tokens_.next();
    const Rational value = tokens_.at_line(token.line, [&] { return value_of(token); });
    return is_negative ? Rational(-value) : value;
  }

  Complex factor() {
    const Complex base = atom();
    if (!accept_power()) return base;
    const int line = tokens_.peek().line;
    const int exponent = read_exponent();
    const Complex result = tokens_.at_line(line, [&] { return power(base, exponent); });
    if (tokens_.peek().is("^") || tokens_.peek().is("**")) {
      tokens_.fail_expected("one exponent; write (x^2)^3 with parentheses");
    }
    return result;
  }

  bool accept_power() { return tokens_.accept("^") || tokens_.accept("**"); }

  int read_exponent() {
    const bool has_parenthesis = tokens_.accept("(");
    const bool is_negative = tokens_.accept("-");
    const Token token = tokens_.peek();
    if (token.kind != Token::Kind::number) tokens_.fail_expected("an integer exponent");
    const Rational value = tokens_.at_line(token.line, [&] { return value_of(token); });
    constexpr int kMost = 1'000'000;
    if (value.get_den() != 1 || value > kMost) {
      tokens_.fail_expected("an integer exponent of at most " + std::to_string(kMost));
    }
    tokens_.next();
    if (has_parenthesis) tokens_.expect(")", "after the exponent");
    const int exponent = static_cast<int>(value.get_num().get_si());
    return is_negative ? -exponent : exponent;
  }

  Complex power(const Complex& base, int exponent) {
    if (!base.imaginary) return {graph().power(base.real, exponent)};
    if (exponent < 0 || exponent > kMaximumComplexPower) {
      throw InputError("an imaginary number to the power " + std::to_string(exponent) +
                       "; expected real coefficients");
    }
    Complex result{graph().constant(1)};
    for (int i = 0; i < exponent; ++i) result = result * base;
    return result;
  }

  Complex atom() {
    if (tokens_.accept("(")) {
      const Complex inner = sum();
      tokens_.expect(")", "after the sum in parentheses");
      return inner;
    }
    const Token token = tokens_.peek();
    if (token.kind == Token::Kind::name) return name(tokens_.next());
    if (token.kind != Token::Kind::number) tokens_.fail_expected("a number, a variable or '('");
    tokens_.next();
    return {graph().constant(tokens_.at_line(token.line, [&] { return value_of(token); }))};
  }

  Complex name(const Token& token) {
    if (token.text == "i" || token.text == "I") {
      if (!line_of_unit_) line_of_unit_ = token.line;
      return {graph().constant(0), graph().constant(1)};
    }
    if (token.text == "e" || token.text == "E") {
      tokens_.fail(token.line, described(token) + " belongs to numbers (1.0E-2); expected another name");
    }
    const auto [place, is_new] = number_of_.try_emplace(std::string(token.text), system_.variables.size());
    if (is_new) add_variable(token);
    return {graph().variable(static_cast<int>(place->second))};
  }

  void add_variable(const Token& token) {
    if (static_cast<long>(system_.variables.size()) == variables_) {
      tokens_.fail(token.line, described(token) + " is one variable more than the " +
                                   std::to_string(variables_) + " that the first line announces");
    }
    system_.variables.push_back(free_variable_name(token.text, names_));
  }

  ExpressionGraph& graph() { return *system_.graph; }

  TokenStream tokens_;
  EquationSystem system_;
  long equations_ = 0;
  long variables_ = 0;
  std::map<std::string, std::size_t> number_of_;
  std::set<std::string> names_;
  std::optional<int> line_of_unit_;  ///< where the polynomial first names the imaginary unit
};

}  // namespace

EquationSystem read_phc(std::string_view text, const std::string& file) {
  return PhcReader(text, file).read();
}

}  // namespace gcslab
