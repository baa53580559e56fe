#include "expression/notation.h"

#include <algorithm>

#include "base/check.h"
#include "base/error.h"

namespace gcslab {
namespace {

constexpr std::size_t kMaximumLength = std::size_t{1} << 24;

/// Text that grows piece by piece.
class Writer {
 public:
  explicit Writer(const Notation& notation) : notation_(notation) {}

  std::string write(Expression expression) {
    waiting_.push_back(Piece::of(expression, Binding::sum));
    while (!waiting_.empty()) {
      Piece next = std::move(waiting_.back());
      waiting_.pop_back();
      take(next);
    }
    return std::move(result_);
  }

 private:
  void take(Piece& piece) {
    switch (piece.kind) {
      case Piece::Kind::text:
        append(piece.text);
        break;
      case Piece::Kind::operand:
        unfold(*piece.operand, piece.needed);
        break;
      case Piece::Kind::product_sign:
        sign_is_due_ = true;
        break;
    }
  }

  void append(const std::string& text) {
    GCSLAB_CHECK(!text.empty());
    if (sign_is_due_) result_ += notation_.product_sign(text.front());
    sign_is_due_ = false;
    result_ += text;
    if (result_.size() > kMaximumLength) {
      throw NotApplicable("an expression has more than " + std::to_string(kMaximumLength) +
                          " characters when its shared parts are written out");
    }
  }

  /// Puts the pieces of a node on the stack, last one deepest.
  void unfold(Expression e, Binding needed) {
    Form form = notation_.form(e);
    const bool enclose = form.binding < needed;
    if (enclose) waiting_.push_back(Piece::of(notation_.closing()));
    std::move(form.pieces.rbegin(), form.pieces.rend(), std::back_inserter(waiting_));
    if (enclose) waiting_.push_back(Piece::of(notation_.opening()));
  }

  const Notation& notation_;
  std::vector<Piece> waiting_;
  std::string result_;
  bool sign_is_due_ = false;
};

}  // namespace

std::string written(Expression expression, const Notation& notation) {
  return Writer(notation).write(expression);
}

std::string Notation::product_sign(char /*next*/) const { return "*"; }

Binding Notation::binding_of(const Rational& value, Binding of_fraction) {
  if (value < 0) return Binding::sum;
  return value.get_den() == 1 ? Binding::atom : of_fraction;
}

Form Notation::call_of(const std::string& name, Expression e) {
  Form form{{Piece::of(name + "("), Piece::of(e.operand(0), Binding::sum)}, Binding::atom};
  if (info(e.operation()).operands == 2) {
    form.pieces.push_back(Piece::of(", "));
    form.pieces.push_back(Piece::of(e.operand(1), Binding::sum));
  }
  form.pieces.push_back(Piece::of(")"));
  return form;
}

Form Notation::variable(int number) const {
  return {{Piece::of(variables_[static_cast<std::size_t>(number)])}, Binding::atom};
}

Form Notation::sum(Expression e, const char* sign, Binding right) const {
  return {
      {Piece::of(e.operand(0), Binding::sum), Piece::of(std::string(sign)), Piece::of(e.operand(1), right)},
      Binding::sum};
}

Form Notation::negation(Expression e) const {
  return {{Piece::of("-"), Piece::of(e.operand(0), Binding::unary)}, Binding::sum};
}

Form Notation::product(Expression e) const {
  return {{Piece::of(e.operand(0), Binding::product), Piece::product_sign(),
           Piece::of(e.operand(1), Binding::unary)},
          Binding::product};
}

Form Notation::quotient(Expression e) const {
  return {
      {Piece::of(e.operand(0), Binding::product), Piece::of("/"), Piece::of(e.operand(1), Binding::unary)},
      Binding::product};
}

Form Notation::form(Expression e) const {
  switch (e.operation()) {
    case Operation::constant:
      return constant(e.constant());
    case Operation::pi:
      return pi();
    case Operation::variable:
      return variable(e.variable());
    // A sum may stand on the right of +, but it must keep its own node: a + (b + c) is not (a + b) + c.
    case Operation::add:
      return sum(e, " + ", Binding::product);
    case Operation::subtract:
      return sum(e, " - ", Binding::product);
    case Operation::negate:
      return negation(e);
    case Operation::multiply:
      return product(e);
    case Operation::divide:
      return quotient(e);
    case Operation::power_integer:
    case Operation::power_rational:
      return power(e, e.exponent());
    case Operation::sqr:
      return power(e, 2);
    default:
      return call(e);
  }
}

}  // namespace gcslab
