#include "verifier/bernstein_forms.h"

#include <algorithm>

namespace gcslab::verifier {
namespace {

constexpr std::size_t kMaximumSize = std::size_t{1} << 20;

using Layers = std::vector<Range>;

Rational binomial(int n, int k) {
  Rational result = 0;
  if (k >= 0 && k <= n)
    mpz_bin_uiui(result.get_num_mpz_t(), static_cast<unsigned long>(n), static_cast<unsigned long>(k));
  return result;
}

/// 1, x, x^2, ...
std::vector<Range> powers_of(double x, int degree) {
  std::vector<Range> result = {Range(1.0)};
  for (int i = 0; i < degree; ++i) result.push_back(result.back() * Range(x));
  return result;
}

/// Encloses the t between points (a, above) and (b, below), above > 0 >= below, where their segment is 0.
Range crossing(int a, mpfr_srcptr above, int b, mpfr_srcptr below, int degree) {
  Range top, bottom;
  mpfr_set(top.lower(), above, MPFR_RNDN);
  mpfr_set(top.upper(), above, MPFR_RNDN);
  mpfr_set(bottom.lower(), below, MPFR_RNDN);
  mpfr_set(bottom.upper(), below, MPFR_RNDN);
  const Range part = top / (top - bottom);
  return (Range(a) + Range(b - a) * part) / Range(degree);
}

/// Encloses the t of the points of the convex hull that are not above the axis: the hull's ends there are
/// points, or lie on segments between two.
Range not_above(const std::vector<Real>& values) {
  const int degree = static_cast<int>(values.size()) - 1;
  Range result = Range::empty();
  for (int b = 0; b <= degree; ++b) {
    const mpfr_srcptr below = values[static_cast<std::size_t>(b)].get();
    if (mpfr_sgn(below) > 0) continue;
    result = hull(result, Range(b) / Range(degree));
    for (int a = 0; a <= degree; ++a) {
      const mpfr_srcptr above = values[static_cast<std::size_t>(a)].get();
      if (mpfr_sgn(above) > 0) result = hull(result, crossing(a, above, b, below, degree));
    }
  }
  return intersection(result, Range(Interval(0, 1)));
}

/// Encloses the t in [0, 1] where a polynomial with coefficients in the layers can vanish, by convex hulls.
Range hull_zeros(const Layers& layers) {
  if (!std::ranges::all_of(layers, &Range::is_bounded)) return Range(Interval(0, 1));
  if (layers.size() == 1) return layers[0].contains_zero() ? Range(Interval(0, 1)) : Range::empty();
  std::vector<Real> lower, minus_upper;
  for (const Range& layer : layers) {
    lower.push_back(layer.lower_end());
    minus_upper.push_back((-layer).lower_end());
  }
  return intersection(not_above(lower), not_above(minus_upper));
}

/// The coefficients on [t, 1], by de Casteljau.
Layers rest_after(Layers layers, const Range& t) {
  const Range before = Range(1.0) - t;
  for (std::size_t level = layers.size() - 1; level > 0; --level) {
    for (std::size_t j = 0; j < level; ++j) layers[j] = before * layers[j] + t * layers[j + 1];
  }
  return layers;
}

/// A number that no zero lies below; above 1 where there is none at all.
Range first_zero(const Layers& layers) {
  constexpr int kMaximumSteps = 200;
  Range start(0.0);
  for (int step = 0; step < kMaximumSteps; ++step) {
    const Range found = hull_zeros(rest_after(layers, start));
    if (found.is_empty()) return Range(2.0);
    const Range least(found.lower_end());
    const Range next(Range(start + (Range(1.0) - start) * least).lower_end());
    const bool is_settled = mpfr_cmp_d(found.lower(), 0x1p-60) < 0;
    if (mpfr_greater_p(next.lower(), start.lower()) != 0) start = next;
    if (is_settled) break;
  }
  return start;
}

/// The same by parts: the hulls of what is left at either end.
Range zeros_in_parts(Layers layers) {
  if (!std::ranges::all_of(layers, &Range::is_bounded)) return Range(Interval(0, 1));
  const Range first = first_zero(layers);
  std::ranges::reverse(layers);
  const Range last = Range(1.0) - first_zero(layers);
  if (mpfr_greater_p(first.lower(), last.upper()) != 0) return Range::empty();
  return hull(first, last);
}

}  // namespace

BernsteinForms::BernsteinForms(JudgedSystem& system) : system_(&system), degrees_(system.variables(), 0) {
  for (const JudgedFunction& equation : system.equations()) {
    applies_ = applies_ && equation.polynomial.has_value();
    if (!applies_) return;
    for (const auto& [exponents, coefficient] : *equation.polynomial) {
      for (std::size_t i = 0; i < degrees_.size(); ++i) degrees_[i] = std::max(degrees_[i], exponents[i]);
    }
  }
  for (const int degree : degrees_) {
    strides_.push_back(size_);
    size_ = std::min(size_ * (static_cast<std::size_t>(degree) + 1), kMaximumSize + 1);
  }
  applies_ = size_ * std::max<std::size_t>(system.equations().size(), 1) <= kMaximumSize;
}

/// Row j, column m: coefficient j of x^m on the side of the box.
std::vector<RangeBox> BernsteinForms::matrix_of(std::size_t variable) const {
  const int degree = degrees_[variable];
  const std::vector<Range> lower = powers_of(box_[variable].lower, degree);
  const std::vector<Range> upper = powers_of(box_[variable].upper, degree);
  std::vector<RangeBox> matrix;
  for (int j = 0; j <= degree; ++j) {
    matrix.emplace_back();
    for (int m = 0; m <= degree; ++m) {
      Range sum;
      for (int k = std::max(0, m - (degree - j)); k <= std::min(j, m); ++k) {
        const Rational weight = binomial(j, k) * binomial(degree - j, m - k) / binomial(degree, m);
        sum =
            sum + Range(weight) * upper[static_cast<std::size_t>(k)] * lower[static_cast<std::size_t>(m - k)];
      }
      matrix.back().push_back(sum);
    }
  }
  return matrix;
}

/// From powers of the variable to its Bernstein basis.
void BernsteinForms::transform(std::size_t variable, std::vector<Range>& tensor) const {
  const std::vector<RangeBox> matrix = matrix_of(variable);
  const std::size_t stride = strides_[variable];
  const std::size_t count = matrix.size();
  std::vector<Range> line(count);
  for (std::size_t place = 0; place < tensor.size(); ++place) {
    if (place / stride % count != 0) continue;
    for (std::size_t m = 0; m < count; ++m) line[m] = tensor[place + m * stride];
    for (std::size_t j = 0; j < count; ++j) {
      Range sum;
      for (std::size_t m = 0; m < count; ++m) {
        if (!line[m].is_zero()) sum = sum + matrix[j][m] * line[m];
      }
      tensor[place + j * stride] = sum;
    }
  }
}

void BernsteinForms::convert(const Box& box) {
  box_ = box;
  tensors_.clear();
  for (const JudgedFunction& equation : system_->equations()) {
    std::vector<Range>& tensor = tensors_.emplace_back(size_);
    for (const auto& [exponents, coefficient] : *equation.polynomial) {
      std::size_t place = 0;
      for (std::size_t i = 0; i < exponents.size(); ++i)
        place += strides_[i] * static_cast<std::size_t>(exponents[i]);
      tensor[place] = Range(coefficient);
    }
    for (std::size_t i = 0; i < degrees_.size(); ++i) transform(i, tensor);
  }
}

BernsteinForms::Layers BernsteinForms::layers_along(std::size_t variable,
                                                    const std::vector<double>& multipliers) const {
  const std::size_t count = static_cast<std::size_t>(degrees_[variable]) + 1;
  Layers layers(count, Range::empty());
  for (std::size_t place = 0; place < size_; ++place) {
    Range sum;
    for (std::size_t k = 0; k < tensors_.size(); ++k) {
      if (multipliers[k] != 0) sum = sum + scaled(multipliers[k], tensors_[k][place]);
    }
    Range& layer = layers[place / strides_[variable] % count];
    layer = hull(layer, sum);
  }
  return layers;
}

Range BernsteinForms::on_side(std::size_t variable, const Range& t) const {
  const Range lower(box_[variable].lower);
  return intersection(lower + (Range(box_[variable].upper) - lower) * t, Range(box_[variable]));
}

Range BernsteinForms::zeros(std::size_t variable, const std::vector<double>& multipliers,
                            const Interval& claim) const {
  const Layers layers = layers_along(variable, multipliers);
  Range t = hull_zeros(layers);
  if (t.is_empty()) return t;
  Range whole = on_side(variable, t);
  if (whole.is_within(claim)) return whole;
  const Range part = zeros_in_parts(layers);
  return part.is_empty() ? part : intersection(whole, on_side(variable, part));
}

}  // namespace gcslab::verifier
