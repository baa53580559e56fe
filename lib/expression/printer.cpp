#include "expression/printer.h"

#include <vector>

#include "base/check.h"

namespace gcslab {
namespace {

/// How tightly a printed form binds; an operand that binds less than its place needs parentheses.
enum class Binding { sum = 0, product = 1, unary = 2, power = 3, atom = 4 };

struct Printed {
  std::string text;
  Binding binding;
};

/// The two notations differ only in these pieces.
class Notation {
 public:
  virtual ~Notation() = default;
  virtual Printed constant(const Rational& value) const = 0;
  virtual std::string pi() const = 0;
  virtual std::string product(const std::string& a, const std::string& b) const = 0;
  virtual Printed quotient(const Printed& a, const Printed& b) const = 0;
  virtual std::string power(const std::string& base, const Rational& exponent) const = 0;
  virtual std::string call(Operation function, const std::string& arguments) const = 0;
  virtual std::string parenthesised(const std::string& text) const = 0;

  std::string wrap(const Printed& operand, Binding needed) const {
    return operand.binding < needed ? parenthesised(operand.text) : operand.text;
  }
};

Binding binding_of(const Rational& value, Binding of_fraction) {
  if (value < 0) return Binding::sum;
  return value.get_den() == 1 ? Binding::atom : of_fraction;
}

class TextNotation final : public Notation {
 public:
  Printed constant(const Rational& value) const override {
    return {value.get_str(), binding_of(value, Binding::product)};
  }
  std::string pi() const override { return "pi"; }
  std::string product(const std::string& a, const std::string& b) const override { return a + "*" + b; }
  Printed quotient(const Printed& a, const Printed& b) const override {
    return {wrap(a, Binding::product) + "/" + wrap(b, Binding::unary), Binding::product};
  }
  std::string power(const std::string& base, const Rational& exponent) const override {
    const bool simple = exponent.get_den() == 1 && exponent >= 0;
    return base + "^" + (simple ? exponent.get_str() : "(" + exponent.get_str() + ")");
  }
  std::string call(Operation function, const std::string& arguments) const override {
    return std::string(info(function).name) + "(" + arguments + ")";
  }
  std::string parenthesised(const std::string& text) const override { return "(" + text + ")"; }
};

class LatexNotation final : public Notation {
 public:
  Printed constant(const Rational& value) const override {
    if (value.get_den() == 1) return {value.get_str(), binding_of(value, Binding::atom)};
    const std::string sign = value < 0 ? "-" : "";
    const Rational size = abs(value);
    return {sign + "\\frac{" + size.get_num().get_str() + "}{" + size.get_den().get_str() + "}",
            binding_of(value, Binding::product)};
  }
  std::string pi() const override { return "\\pi"; }
  std::string product(const std::string& a, const std::string& b) const override {
    const bool digits_meet = std::isdigit(static_cast<unsigned char>(b.front())) != 0;
    return a + (digits_meet ? " \\cdot " : " ") + b;
  }
  Printed quotient(const Printed& a, const Printed& b) const override {
    return {"\\frac{" + a.text + "}{" + b.text + "}", Binding::product};
  }
  std::string power(const std::string& base, const Rational& exponent) const override {
    return base + "^{" + exponent.get_str() + "}";
  }
  std::string call(Operation function, const std::string& arguments) const override {
    const std::string name(info(function).latex);
    if (function == Operation::sqrt || function == Operation::cbrt) return name + "{" + arguments + "}";
    if (function == Operation::abs) return "\\left|" + arguments + "\\right|";
    return name + "\\left(" + arguments + "\\right)";
  }
  std::string parenthesised(const std::string& text) const override { return "\\left(" + text + "\\right)"; }
};

class Printer {
 public:
  Printer(const Notation& notation, std::span<const std::string> variables)
      : notation_(notation), variables_(variables) {}

  Printed print(Expression e) const {
    switch (e.operation()) {
      case Operation::constant:
        return notation_.constant(e.constant());
      case Operation::pi:
        return {notation_.pi(), Binding::atom};
      case Operation::variable:
        return {variables_[static_cast<std::size_t>(e.variable())], Binding::atom};
      case Operation::add:
        return sum(e, " + ", Binding::sum);
      case Operation::subtract:
        return sum(e, " - ", Binding::product);
      case Operation::negate:
        return {"-" + notation_.wrap(print(e.operand(0)), Binding::unary), Binding::sum};
      case Operation::multiply:
        return product(e);
      case Operation::divide:
        return notation_.quotient(print(e.operand(0)), print(e.operand(1)));
      case Operation::power_integer:
      case Operation::power_rational:
        return power(e, e.exponent());
      case Operation::sqr:
        return power(e, 2);
      default:
        return {notation_.call(e.operation(), arguments(e)), Binding::atom};
    }
  }

 private:
  Printed sum(Expression e, const char* sign, Binding right) const {
    // A sum may stand on the right of +, but it must keep its own node: a + (b + c) is not (a + b) + c.
    const Binding needed = right == Binding::sum ? Binding::product : right;
    return {notation_.wrap(print(e.operand(0)), Binding::sum) + sign +
                notation_.wrap(print(e.operand(1)), needed),
            Binding::sum};
  }

  Printed product(Expression e) const {
    return {notation_.product(notation_.wrap(print(e.operand(0)), Binding::product),
                              notation_.wrap(print(e.operand(1)), Binding::unary)),
            Binding::product};
  }

  Printed power(Expression e, const Rational& exponent) const {
    return {notation_.power(notation_.wrap(print(e.operand(0)), Binding::atom), exponent), Binding::power};
  }

  std::string arguments(Expression e) const {
    std::string result = print(e.operand(0)).text;
    if (info(e.operation()).operands == 2) result += ", " + print(e.operand(1)).text;
    return result;
  }

  const Notation& notation_;
  std::span<const std::string> variables_;
};

}  // namespace

std::string to_text(Expression expression, std::span<const std::string> variables) {
  return Printer(TextNotation(), variables).print(expression).text;
}

std::string to_latex(Expression expression, std::span<const std::string> variables) {
  return Printer(LatexNotation(), variables).print(expression).text;
}

}  // namespace gcslab
