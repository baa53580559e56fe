#include "expression/phc_writer.h"

#include <algorithm>
#include <fmt/format.h>

#include "base/check.h"
#include "base/error.h"
#include "expression/notation.h"
#include "expression/polynomial_form.h"
#include "expression/token_stream.h"
#include "expression/variable_names.h"

namespace gcslab {
namespace {

/// Natural numbers up to this many digits are written as they are.
constexpr std::size_t kMaximumDigits = 17;
/// PHCpack computes with exponents of doubles, whatever its precision.
constexpr std::size_t kMaximumExponent = 300;
/// Longer names would be cut off.
constexpr std::size_t kMaximumNameLength = 80;

std::string natural_text(const mpz_class& value) {
  std::string digits = value.get_str();
  if (digits.size() <= kMaximumDigits) return digits;
  if (digits.size() > kMaximumExponent) {
    throw NotApplicable("PHCpack has no number of " + std::to_string(digits.size()) + " digits");
  }
  std::string fraction = digits.substr(1);
  fraction.erase(fraction.find_last_not_of('0') + 1);
  if (fraction.empty()) fraction = "0";
  return fmt::format("{}.{}E+{}", digits.front(), fraction, digits.size() - 1);
}

class PhcNotation final : public Notation {
 public:
  using Notation::Notation;

 private:
  Form constant(const Rational& value) const override {
    const std::string sign = value < 0 ? "-" : "";
    const std::string numerator = sign + natural_text(abs(value.get_num()));
    if (value.get_den() != 1) {
      return {{Piece::of("(" + numerator + "/" + natural_text(value.get_den()) + ")")}, Binding::atom};
    }
    return {{Piece::of(value < 0 ? "(" + numerator + ")" : numerator)}, Binding::atom};
  }

  Form pi() const override { GCSLAB_CHECK(false); }
  Form call(Expression /*e*/) const override { GCSLAB_CHECK(false); }

  /// PHCpack does not read a bare number behind a closing parenthesis: (x + y)*3.
  Form product(Expression e) const override {
    Form form = Notation::product(e);
    const Expression factor = e.operand(1);
    if (factor.is_constant() && factor.constant() >= 0 && factor.constant().get_den() == 1) {
      form.pieces.back() = Piece::of(factor, Binding::enclosed);
    }
    return form;
  }

  Form quotient(Expression e) const override {
    Form form = constant(1 / e.operand(1).constant());
    form.pieces.push_back(Piece::product_sign());
    form.pieces.push_back(Piece::of(e.operand(0), Binding::unary));
    form.binding = Binding::product;
    return form;
  }

  Form power(Expression e, const Rational& exponent) const override {
    return {{Piece::of(e.operand(0), Binding::atom), Piece::of("^" + exponent.get_str())}, Binding::power};
  }
};

/// 'e' and 'i' begin numbers. Underscores are read at the beginning too, but no manual says so.
bool is_allowed(const std::string& name) {
  return std::string_view("eEiI_").find(name.front()) == std::string_view::npos;
}

/// The names in the order in which PHCpack meets them.
std::vector<std::string> names_in_order(const std::vector<std::string>& polynomials) {
  std::vector<std::string> names;
  for (const std::string& polynomial : polynomials) {
    TokenStream tokens(polynomial, "", {});
    for (Token token = tokens.next(); token.kind != Token::Kind::end; token = tokens.next()) {
      if (token.kind != Token::Kind::name) continue;
      if (std::ranges::find(names, token.text) == names.end()) names.emplace_back(token.text);
    }
  }
  return names;
}

/// PHCpack numbers variables as it meets them: x - x + y - y in front sets their order and adds nothing.
std::string with_order(const std::vector<std::string>& names, const std::string& polynomial) {
  std::string result;
  for (const std::string& name : names) result += fmt::format("{0}{1}-{1}", result.empty() ? "" : "+", name);
  return result + (polynomial.front() == '-' ? " " : " + ") + polynomial;
}

std::string note(const EquationSystem& system, const ForeignNames& names) {
  std::string text = "\nTITLE : written by gcslab\n\nNOTE :\n";
  for (const auto& [changed, original] : names.renamed) {
    text += fmt::format("  {} stands for {}\n", changed, original);
  }
  text += "  The box is not written: PHCpack looks for all complex solutions.\n";
  if (!system.inequalities.empty()) {
    text += fmt::format("  {} inequalities are not written; solutions may violate them.\n",
                        system.inequalities.size());
  }
  return text;
}

}  // namespace

std::string write_phc(const EquationSystem& system) {
  require_polynomial_form(system, Constants::rational, "PHCpack");
  const ForeignNames names = foreign_names(system.variables, is_allowed);
  for (const std::string& name : names.names) {
    if (name.size() > kMaximumNameLength) throw NotApplicable("PHCpack has no name as long as " + name);
  }
  const PhcNotation notation(names.names);
  std::vector<std::string> polynomials;
  for (const Expression& equation : system.equations) polynomials.push_back(written(equation, notation));
  if (names_in_order(polynomials) != names.names) {
    polynomials.front() = with_order(names.names, polynomials.front());
  }
  std::string text = std::to_string(system.equations.size());
  if (system.variables.size() != system.equations.size()) text += fmt::format(" {}", system.variables.size());
  for (const std::string& polynomial : polynomials) text += "\n " + polynomial + ";";
  return text + "\n" + note(system, names);
}

}  // namespace gcslab
