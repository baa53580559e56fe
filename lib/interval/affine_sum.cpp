#include "interval/affine_sum.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "interval/fast_interval.h"

namespace gcslab {
namespace {

constexpr std::size_t kLanes = 4;

thread_local std::size_t next_symbol = 0;

std::size_t padded(std::size_t size) { return (size + kLanes - 1) / kLanes * kLanes; }

__m256d load(const std::vector<double>& values, std::size_t i) { return _mm256_loadu_pd(values.data() + i); }
__m256d broadcast(double value) { return opaque(_mm256_set1_pd(value)); }
__m256d magnitude(__m256d x) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), x); }

/// Sum of the lanes, rounded upward.
double sum_of(__m256d x) {
  const __m128d pairs = opaque(_mm_add_pd(_mm256_castpd256_pd128(opaque(x)), _mm256_extractf128_pd(x, 1)));
  return rounded_add(_mm_cvtsd_f64(pairs), _mm_cvtsd_f64(_mm_unpackhi_pd(pairs, pairs)));
}

double sum_of_magnitudes(const std::vector<double>& values) {
  __m256d sum = _mm256_setzero_pd();
  for (std::size_t i = 0; i < values.size(); i += kLanes) {
    sum = opaque(_mm256_add_pd(sum, magnitude(opaque(load(values, i)))));
  }
  return sum_of(sum);
}

/// Bounds of the sums of x_i y_i and of |x_i y_i|.
struct Products {
  FastInterval sum;
  double magnitudes_from_below;
};

Products products_of(const std::vector<double>& x, const std::vector<double>& y) {
  __m256d upper = _mm256_setzero_pd();
  __m256d minus_lower = _mm256_setzero_pd();
  __m256d minus_magnitudes = _mm256_setzero_pd();
  const __m256d sign = broadcast(-0.0);
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); i += kLanes) {
    const __m256d xs = opaque(load(x, i));
    const __m256d ys = opaque(load(y, i));
    const __m256d minus_xs = opaque(_mm256_xor_pd(xs, sign));
    const __m256d minus_sizes = opaque(_mm256_or_pd(xs, sign));
    upper = opaque(_mm256_fmadd_pd(xs, ys, upper));
    minus_lower = opaque(_mm256_fmadd_pd(minus_xs, ys, minus_lower));
    minus_magnitudes = opaque(_mm256_fmadd_pd(minus_sizes, magnitude(ys), minus_magnitudes));
  }
  return {FastInterval(-sum_of(minus_lower), sum_of(upper)), -sum_of(minus_magnitudes)};
}

}  // namespace

NoiseScope::NoiseScope() : saved_(next_symbol) { next_symbol = 0; }
NoiseScope::~NoiseScope() { next_symbol = saved_; }

AffineSum AffineSum::constant(const Interval& x) {
  AffineSum result;
  result.shift(x);
  return result;
}

AffineSum AffineSum::variable(const Interval& x) {
  GCSLAB_CHECK(is_bounded(x));
  AffineSum result;
  result.centre_ = midpoint(x);
  if (!is_singleton(x)) result.add_new_symbol(gcslab::radius(x));
  return result;
}

bool AffineSum::is_finite() const { return std::isfinite(centre_) && std::isfinite(radius()); }

double AffineSum::radius() const { return rounded_add(sum_of_magnitudes(coefficients_), error_); }

Interval AffineSum::range() const {
  const double r = radius();
  return (FastInterval(centre_) + FastInterval(-r, r)).interval();
}

AffineSum AffineSum::operator-() const {
  AffineSum result = *this;
  result.centre_ = 0.0 - centre_;
  for (double& coefficient : result.coefficients_) coefficient = -coefficient;
  return result;
}

AffineSum AffineSum::combined(double alpha, const AffineSum& x, double beta, const AffineSum& y) {
  AffineSum result;
  result.coefficients_.resize(std::max(x.coefficients_.size(), y.coefficients_.size()));
  const __m256d alphas = broadcast(alpha);
  const __m256d minus_alphas = broadcast(-alpha);
  const __m256d betas = broadcast(beta);
  const __m256d minus_betas = broadcast(-beta);
  __m256d errors = _mm256_setzero_pd();
  for (std::size_t i = 0; i < result.coefficients_.size(); i += kLanes) {
    const __m256d zero = _mm256_setzero_pd();
    const __m256d xs = opaque(i < x.coefficients_.size() ? load(x.coefficients_, i) : zero);
    const __m256d ys = opaque(i < y.coefficients_.size() ? load(y.coefficients_, i) : zero);
    const __m256d upper = opaque(_mm256_fmadd_pd(betas, ys, opaque(_mm256_mul_pd(alphas, xs))));
    const __m256d minus_lower =
        opaque(_mm256_fmadd_pd(minus_betas, ys, opaque(_mm256_mul_pd(minus_alphas, xs))));
    errors = opaque(_mm256_add_pd(errors, opaque(_mm256_add_pd(upper, minus_lower))));
    _mm256_storeu_pd(result.coefficients_.data() + i, upper);
  }
  const double inherited =
      rounded_add(rounded_multiply(std::fabs(alpha), x.error_), rounded_multiply(std::fabs(beta), y.error_));
  result.error_ = rounded_add(sum_of(errors), inherited);
  return result;
}

void AffineSum::shift(const Interval& amount) {
  const Interval moved = (FastInterval(centre_) + FastInterval(amount)).interval();
  centre_ = midpoint(moved);
  error_ = rounded_add(error_, gcslab::radius(moved));
}

void AffineSum::add_new_symbol(double radius) {
  if (radius == 0) return;
  const std::size_t index = next_symbol++;
  coefficients_.resize(padded(index + 1));
  coefficients_[index] = radius;
}

AffineSum AffineSum::linear(double slope, const AffineSum& x, const Interval& offset) {
  AffineSum result = combined(slope, x, 0, {});
  result.shift((FastInterval(slope) * FastInterval(x.centre_)).interval());
  if (x.is_constant()) {
    result.shift(offset);
  } else {
    result.shift(midpoint(offset));
    result.add_new_symbol(gcslab::radius(offset));
  }
  return result;
}

AffineSum AffineSum::sum(const AffineSum& x, const AffineSum& y) {
  AffineSum result = combined(1, x, 1, y);
  result.shift((FastInterval(x.centre_) + FastInterval(y.centre_)).interval());
  return result;
}

AffineSum AffineSum::difference(const AffineSum& x, const AffineSum& y) {
  AffineSum result = combined(1, x, -1, y);
  result.shift((FastInterval(x.centre_) - FastInterval(y.centre_)).interval());
  return result;
}

AffineSum AffineSum::product(const AffineSum& x, const AffineSum& y) {
  AffineSum result = combined(y.centre_, x, x.centre_, y);
  const Products products = products_of(x.coefficients_, y.coefficients_);
  const FastInterval half_sum = FastInterval(0.5) * products.sum;
  result.shift((FastInterval(x.centre_) * FastInterval(y.centre_) + half_sum).interval());
  const FastInterval bound = FastInterval(x.radius()) * FastInterval(y.radius());
  const double remainder = rounded_subtract(bound.upper(), 0.5 * products.magnitudes_from_below);
  if (x.is_constant() || y.is_constant()) {
    result.error_ = rounded_add(result.error_, remainder);
  } else {
    result.add_new_symbol(remainder);
  }
  return result;
}

}  // namespace gcslab
