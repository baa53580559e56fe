#include "packing/radii_enclosure.h"

#include <cmath>

#include "packing/angle_sum.h"

namespace gcslab {
namespace {

using Numbers = std::vector<MpfrInterval>;

MpfrInterval number(double value) { return MpfrInterval(Interval(value)); }

/// A number of the interval, about its middle, as an interval of no width.
MpfrInterval middle(const MpfrInterval& x) {
  MpfrNumber sum;
  mpfr_add(sum.get(), x.lower(), x.upper(), MPFR_RNDN);
  mpfr_div_2ui(sum.get(), sum.get(), 1, MPFR_RNDN);
  return {sum, sum};
}

Numbers excesses(const Triangulation& graph, const Numbers& radii) {
  Numbers result = angle_sums<MpfrInterval>(graph, radii);
  const MpfrInterval full = number(2) * NumberTraits<MpfrInterval>::pi();
  for (MpfrInterval& sum : result) sum = sum - full;
  return result;
}

/// The radii times 1 + part * step, each rounded to a number.
Numbers moved(Numbers radii, const std::vector<double>& step, double part) {
  for (std::size_t i = 0; i < step.size(); ++i) {
    MpfrInterval& radius = radii[i + 3];
    radius = middle(radius * (number(1) + number(part) * number(step[i])));
  }
  return radii;
}

std::vector<double> middles(const Numbers& numbers) {
  std::vector<double> result;
  for (const MpfrInterval& x : numbers) result.push_back(midpoint(x.interval()));
  return result;
}

double largest_magnitude(const Numbers& numbers) {
  double result = 0;
  for (const MpfrInterval& x : numbers) result = std::max(result, magnitude(x.interval()));
  return result;
}

bool is_supersolution(const Triangulation& graph, const Numbers& radii) {
  for (const MpfrInterval& excess : excesses(graph, radii)) {
    if (!(mpfr_sgn(excess.upper()) <= 0)) return false;
  }
  return true;
}

bool is_subsolution(const Triangulation& graph, const Numbers& radii) {
  for (const MpfrInterval& excess : excesses(graph, radii)) {
    if (!(mpfr_sgn(excess.lower()) >= 0)) return false;
  }
  return true;
}

bool are_positive(const Numbers& radii) {
  for (const MpfrInterval& radius : radii) {
    if (!(mpfr_sgn(radius.lower()) > 0)) return false;
  }
  return true;
}

Numbers start(const std::array<Rational, 3>& outer_radii, std::span<const double> approximate) {
  Numbers radii;
  for (const Rational& radius : outer_radii)
    radii.push_back(NumberTraits<MpfrInterval>::from_rational(radius));
  for (const double radius : approximate.subspan(3)) radii.push_back(number(radius));
  return radii;
}

/// Newton's steps with the derivative of the doubles: each gains about as many digits as a double has.
bool refine(const Triangulation& graph, const AngleSumDerivative& derivative, int bits, Numbers& radii) {
  constexpr int kBitsOfAStep = 30;
  for (int i = 0; i <= bits / kBitsOfAStep; ++i) {
    const auto step = derivative.solve(middles(excesses(graph, radii)));
    if (!step) return false;
    radii = moved(std::move(radii), *step, 1);
    double largest = 0;
    for (const double change : *step) largest = std::max(largest, std::fabs(change));
    if (largest < std::ldexp(1.0, 12 - bits)) break;
  }
  return true;
}

}  // namespace

std::optional<std::vector<MpfrInterval>> enclose_radii(const Triangulation& graph,
                                                       const std::array<Rational, 3>& outer_radii,
                                                       std::span<const double> approximate, int bits) {
  constexpr int kAttempts = 4;
  Numbers radii = start(outer_radii, approximate);
  const AngleSumDerivative derivative(graph, approximate);
  if (!refine(graph, derivative, bits, radii)) return std::nullopt;
  const std::vector<double> ones(static_cast<std::size_t>(graph.inner_vertices()), 1);
  const auto direction = derivative.solve(ones);
  if (!direction) return std::nullopt;
  // The angle sums at the two points differ from 2 pi by about `change`, which must outweigh their errors.
  double change = 2 * largest_magnitude(excesses(graph, radii)) + std::ldexp(1.0, 8 - bits);
  for (int i = 0; i < kAttempts; ++i, change *= 16) {
    const Numbers above = moved(radii, *direction, change);
    const Numbers below = moved(radii, *direction, -change);
    if (!are_positive(below) || !is_supersolution(graph, above) || !is_subsolution(graph, below)) continue;
    std::vector<MpfrInterval> result;
    for (std::size_t v = 0; v < radii.size(); ++v)
      result.emplace_back(MpfrNumber(below[v].lower()), MpfrNumber(above[v].upper()));
    return result;
  }
  return std::nullopt;
}

}  // namespace gcslab
