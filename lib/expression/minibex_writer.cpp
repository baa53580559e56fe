#include "expression/minibex_writer.h"

#include <cmath>
#include <fmt/format.h>

#include "expression/minibex_scope.h"
#include "expression/notation.h"
#include "expression/variable_names.h"
#include "interval/rational.h"

namespace gcslab {
namespace {

class MinibexNotation final : public Notation {
 public:
  using Notation::Notation;

 private:
  Form constant(const Rational& value) const override {
    return {{Piece::of(value.get_str())}, binding_of(value, Binding::product)};
  }
  Form pi() const override { return {{Piece::of("pi")}, Binding::atom}; }

  Form power(Expression e, const Rational& exponent) const override {
    const bool is_odd_root = exponent.get_den() != 1 && mpz_odd_p(exponent.get_den_mpz_t()) != 0;
    if (is_odd_root && !minibex::is_visibly_nonnegative(e.operand(0))) return odd_root(e, exponent);
    const bool is_natural = exponent.get_den() == 1 && exponent >= 0;
    const std::string text = is_natural ? exponent.get_str() : "(" + exponent.get_str() + ")";
    return {{Piece::of(e.operand(0), Binding::atom), Piece::of("^" + text)}, Binding::power};
  }

  /// x^(p/q), q odd, for all real x.
  static Form odd_root(Expression e, const Rational& exponent) {
    const Rational size = abs(exponent);
    const Expression base = e.operand(0);
    if (mpz_even_p(exponent.get_num_mpz_t()) != 0) {
      return {{Piece::of("abs("), Piece::of(base, Binding::sum), Piece::of(")^(" + exponent.get_str() + ")")},
              Binding::power};
    }
    const std::string power = ", 0)^(" + size.get_str() + ")";
    const bool is_reciprocal = exponent < 0;
    return {{Piece::of(is_reciprocal ? "(1/(max(" : "(max("), Piece::of(base, Binding::sum),
             Piece::of(power + " - max(-"), Piece::of(base, Binding::unary),
             Piece::of(power + (is_reciprocal ? "))" : ")"))},
            Binding::atom};
  }

  Form call(Expression e) const override {
    if (e.operation() == Operation::cbrt) return power(e, Rational(1, 3));
    if (e.operation() == Operation::log) return call_of("ln", e);
    return call_of(std::string(info(e.operation()).name), e);
  }
};

/// 2^k in factors that doubles can hold.
std::string power_of_two(char sign, unsigned long exponent) {
  constexpr unsigned long kLargest = 1000;
  std::string text;
  for (; exponent > kLargest; exponent -= kLargest) text += fmt::format("{}2^{}", sign, kLargest);
  return text + fmt::format("{}2^{}", sign, exponent);
}

/// A double, exactly.
std::string exact_text(double value) {
  if (std::isinf(value)) return value < 0 ? "-oo" : "+oo";
  const Rational exact = rational_from_double(value);
  std::string shortest = fmt::format("{}", value);
  if (rational_from_text(shortest) == exact) return shortest;
  const unsigned long halvings = mpz_scan1(exact.get_den_mpz_t(), 0);
  if (halvings > 0) return exact.get_num().get_str() + power_of_two('/', halvings);
  const unsigned long doublings = mpz_scan1(exact.get_num_mpz_t(), 0);
  mpz_class odd;
  mpz_fdiv_q_2exp(odd.get_mpz_t(), exact.get_num_mpz_t(), doublings);
  return odd.get_str() + power_of_two('*', doublings);
}

bool is_allowed(const std::string& name) { return !minibex::is_reserved(name); }

}  // namespace

std::string write_minibex(const EquationSystem& system) {
  const ForeignNames names = foreign_names(system.variables, is_allowed);
  const MinibexNotation notation(names.names);
  std::string text = "// written by gcslab\n";
  for (const auto& [changed, original] : names.renamed) {
    text += fmt::format("// {} stands for {}\n", changed, original);
  }
  text += "\nVariables\n";
  for (std::size_t i = 0; i < names.names.size(); ++i) {
    text += fmt::format("  {} in [{}, {}];\n", names.names[i], exact_text(system.box[i].lower),
                        exact_text(system.box[i].upper));
  }
  text += "\nConstraints\n";
  for (const Expression& equation : system.equations) text += "  " + written(equation, notation) + " = 0;\n";
  for (const Expression& inequality : system.inequalities) {
    text += "  " + written(inequality, notation) + " <= 0;\n";
  }
  return text + "end\n";
}

}  // namespace gcslab
