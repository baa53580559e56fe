// The slopes of a program: one backward sweep (Griewank, Walther, Evaluating Derivatives, 2008, section 3.2).

#include <limits>

#include "base/check.h"
#include "verifier/program.h"

namespace gcslab::verifier {
namespace {

/// Where a function is defined but its derivative nowhere (sqrt on {0}), the operand has one value, so that
/// any slope will do.
Range nonempty_slope(const Range& slope) { return slope.is_empty() ? Range::entire() : slope; }

/// The slopes of |a|.
Range sign_of(const Range& a) {
  if (mpfr_sgn(a.lower()) > 0) return 1.0;
  if (mpfr_sgn(a.upper()) < 0) return -1.0;
  return Range(Interval(-1, 1));
}

/// The truth of a < b: 1, 0, or [0, 1] where both occur.
Range is_less(const Range& a, const Range& b) {
  if (mpfr_less_p(a.upper(), b.lower()) != 0) return 1.0;
  if (mpfr_lessequal_p(b.upper(), a.lower()) != 0) return 0.0;
  return Range(Interval(0, 1));
}

}  // namespace

/// The slopes of an operation of one operand. It is continuous on the operand, so that its derivatives,
/// infinite ones included, enclose them.
Range Program::outer_derivative(const Node& node, const Range& value) const {
  const Range& a = values_[node.a];
  const Range one(1.0);
  switch (node.operation) {
    case Operation::negate:
      return -one;
    case Operation::sqr:
      return a + a;
    case Operation::power_integer:
    case Operation::power_rational:
      return nonempty_slope(Range(node.exponent) * power(a, node.exponent - 1));
    case Operation::sqrt:
      return nonempty_slope(one / (value + value));
    case Operation::cbrt:
      return nonempty_slope(one / (scaled(3, sqr(value))));
    case Operation::exp:
      return value;
    case Operation::log:
      return nonempty_slope(one / a);
    case Operation::sin:
      return cos(a);
    case Operation::cos:
      return -sin(a);
    case Operation::tan:
      return one + sqr(value);
    case Operation::asin:
      return nonempty_slope(one / sqrt(one - sqr(a)));
    case Operation::acos:
      return nonempty_slope(-(one / sqrt(one - sqr(a))));
    case Operation::atan:
      return one / (one + sqr(a));
    case Operation::abs:
      return sign_of(a);
    default:
      GCSLAB_CHECK(false);
  }
}

void Program::add_adjoint(std::uint32_t place, const Range& contribution) {
  adjoints_[place] = has_adjoint_[place] ? adjoints_[place] + contribution : contribution;
  has_adjoint_[place] = true;
}

void Program::add_adjoints(const Node& node, const Range& value, const Range& adjoint) {
  const Range& a = values_[node.a];
  const Range& b = values_[node.b];
  switch (node.operation) {
    case Operation::constant:
    case Operation::pi:
    case Operation::variable:
      return;
    case Operation::add:
      add_adjoint(node.a, adjoint);
      return add_adjoint(node.b, adjoint);
    case Operation::subtract:
      add_adjoint(node.a, adjoint);
      return add_adjoint(node.b, -adjoint);
    case Operation::multiply:
      add_adjoint(node.a, adjoint * b);
      return add_adjoint(node.b, adjoint * a);
    case Operation::divide: {
      const Range quotient = adjoint / b;
      add_adjoint(node.a, quotient);
      return add_adjoint(node.b, -(quotient * value));
    }
    case Operation::min:
    case Operation::max: {
      const Range first = node.operation == Operation::min ? is_less(a, b) : is_less(b, a);
      add_adjoint(node.a, adjoint * first);
      return add_adjoint(node.b, adjoint * (Range(1.0) - first));
    }
    default:
      add_adjoint(node.a, adjoint * outer_derivative(node, value));
  }
}

const std::vector<Range>& Program::gradient() {
  has_adjoint_.assign(nodes_.size(), false);
  add_adjoint(static_cast<std::uint32_t>(nodes_.size() - 1), 1.0);
  for (std::size_t place = nodes_.size(); place-- > 0;) {
    if (has_adjoint_[place]) {
      const Range adjoint = adjoints_[place];
      add_adjoints(nodes_[place], values_[place], adjoint);
    }
  }
  for (const std::size_t i : variables_) gradient_[i] = adjoints_[place_of_variable_[i]];
  return gradient_;
}

double Program::double_rounding_error() const {
  Real sum;
  Real product;
  for (std::size_t place = 0; place < nodes_.size(); ++place) {
    if (!has_adjoint_[place]) continue;
    mpfr_mul(product.get(), magnitude(values_[place]).get(), magnitude(adjoints_[place]).get(), MPFR_RNDU);
    mpfr_add(sum.get(), sum.get(), product.get(), MPFR_RNDU);
  }
  mpfr_mul_d(sum.get(), sum.get(), 0x1p-48, MPFR_RNDU);
  return mpfr_nan_p(sum.get()) != 0 ? std::numeric_limits<double>::infinity()
                                    : mpfr_get_d(sum.get(), MPFR_RNDU);
}

}  // namespace gcslab::verifier
