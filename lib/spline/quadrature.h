#pragma once

// Integrals of smooth functions to a tolerance.
//
// Kronrod's rule of 15 points against Gauss's of 7 (Kronrod 1965; nodes and weights as in QUADPACK, Piessens
// et al. 1983): their difference, an estimate of the error of the worse one, says whether an interval is
// halved. An estimate is no proof: what oscillates between all nodes is not seen.

#include <array>
#include <cmath>

namespace gcslab {

struct Integral {
  double value = 0;
  double error_estimate = 0;
};

namespace spline_detail {

inline constexpr std::array<double, 8> kKronrodNodes = {
    0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
    0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
    0.586087235467691130294144838258730, 0.405845151377397166906606412076961,
    0.207784955007898467600689403773245, 0};
inline constexpr std::array<double, 8> kKronrodWeights = {
    0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
    0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
    0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
    0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
/// Of nodes 1, 3, 5, 7.
inline constexpr std::array<double, 4> kGaussWeights = {
    0.129484966168869693270611432679082, 0.279705391489276667901467771423780,
    0.381830050505118944950369775488975, 0.417959183673469387755102040816327};

template <class F>
Integral kronrod(const F& f, double a, double b) {
  const double middle = (a + b) / 2;
  const double half = (b - a) / 2;
  double kronrod = 0;
  double gauss = 0;
  for (std::size_t i = 0; i < kKronrodNodes.size(); ++i) {
    const double step = half * kKronrodNodes[i];
    const double values = i + 1 == kKronrodNodes.size() ? f(middle) : f(middle - step) + f(middle + step);
    kronrod += kKronrodWeights[i] * values;
    if (i % 2 == 1) gauss += kGaussWeights[i / 2] * values;
  }
  return {kronrod * half, std::fabs(kronrod - gauss) * half};
}

}  // namespace spline_detail

/// The integral of f from a to b; each part is halved until its estimate is within its share of the
/// tolerance, `depth` times at most.
template <class F>
Integral adaptive_integral(const F& f, double a, double b, double tolerance, int depth = 40) {
  const Integral whole = spline_detail::kronrod(f, a, b);
  if (whole.error_estimate <= tolerance || depth == 0) return whole;
  const double middle = (a + b) / 2;
  const Integral left = adaptive_integral(f, a, middle, tolerance / 2, depth - 1);
  const Integral right = adaptive_integral(f, middle, b, tolerance / 2, depth - 1);
  return {left.value + right.value, left.error_estimate + right.error_estimate};
}

}  // namespace gcslab
