#include "expression/printer.h"

#include <cctype>

#include "expression/notation.h"

namespace gcslab {
namespace {

class TextNotation final : public Notation {
 public:
  using Notation::Notation;

 private:
  Form constant(const Rational& value) const override {
    return {{Piece::of(value.get_str())}, binding_of(value, Binding::product)};
  }
  Form pi() const override { return {{Piece::of("pi")}, Binding::atom}; }
  Form power(Expression e, const Rational& exponent) const override {
    const bool simple = exponent.get_den() == 1 && exponent >= 0;
    const std::string text = simple ? exponent.get_str() : "(" + exponent.get_str() + ")";
    return {{Piece::of(e.operand(0), Binding::atom), Piece::of("^" + text)}, Binding::power};
  }
  Form call(Expression e) const override { return call_of(std::string(info(e.operation()).name), e); }
};

class LatexNotation final : public Notation {
 public:
  using Notation::Notation;
  std::string opening() const override { return "\\left("; }
  std::string closing() const override { return "\\right)"; }
  std::string product_sign(char next) const override {
    return std::isdigit(static_cast<unsigned char>(next)) != 0 ? " \\cdot " : " ";
  }

 private:
  Form constant(const Rational& value) const override {
    if (value.get_den() == 1) return {{Piece::of(value.get_str())}, binding_of(value, Binding::atom)};
    const std::string sign = value < 0 ? "-" : "";
    const Rational size = abs(value);
    return {{Piece::of(sign + "\\frac{" + size.get_num().get_str() + "}{" + size.get_den().get_str() + "}")},
            binding_of(value, Binding::product)};
  }
  Form pi() const override { return {{Piece::of("\\pi")}, Binding::atom}; }
  Form quotient(Expression e) const override {
    return {{Piece::of("\\frac{"), Piece::of(e.operand(0), Binding::sum), Piece::of("}{"),
             Piece::of(e.operand(1), Binding::sum), Piece::of("}")},
            Binding::product};
  }
  Form power(Expression e, const Rational& exponent) const override {
    return {{Piece::of(e.operand(0), Binding::atom), Piece::of("^{" + exponent.get_str() + "}")},
            Binding::power};
  }
  Form call(Expression e) const override {
    const Operation function = e.operation();
    const std::string name(info(function).latex);
    Form form = call_of(name, e);
    const bool is_root = function == Operation::sqrt || function == Operation::cbrt;
    const bool is_abs = function == Operation::abs;
    form.pieces.front() = Piece::of(is_root ? name + "{" : is_abs ? "\\left|" : name + "\\left(");
    form.pieces.back() = Piece::of(is_root ? "}" : is_abs ? "\\right|" : "\\right)");
    return form;
  }
};

}  // namespace

std::string to_text(Expression expression, std::span<const std::string> variables) {
  return written(expression, TextNotation(variables));
}

std::string to_latex(Expression expression, std::span<const std::string> variables) {
  return written(expression, LatexNotation(variables));
}

}  // namespace gcslab
