#include "packing/angle_sum.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/check.h"
#include "interval/mpfr_interval.h"
#include "interval/point_numbers.h"
#include "interval/rounding.h"

namespace gcslab {
namespace {

template <class T>
T number(long value) {
  return NumberTraits<T>::from_rational(value);
}

/// Adds the three angles of a face where they belong to inner vertices.
template <class T>
void add_angles(const Face& face, std::span<const T> radii, const T& two, std::vector<T>& sums) {
  std::array<T, 3> r = {radii[static_cast<std::size_t>(face[0])], radii[static_cast<std::size_t>(face[1])],
                        radii[static_cast<std::size_t>(face[2])]};
  const T whole = r[0] + r[1] + r[2];
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_outer(face[i])) continue;
    const T& b = r[(i + 1) % 3];
    const T& c = r[(i + 2) % 3];
    T& sum = sums[static_cast<std::size_t>(face[i] - 3)];
    sum = sum + two * atan(sqrt(b * c / (r[i] * whole)));
  }
}

/// How fast the angles of a face at the two ends of one of its edges open with the other end's radius: for
/// the edges opposite to each corner.
std::array<double, 3> opening_rates(const std::array<double, 3>& r) {
  const double inscribed = std::sqrt(r[0] * r[1] * r[2] / (r[0] + r[1] + r[2]));
  return {inscribed / (r[1] + r[2]), inscribed / (r[2] + r[0]), inscribed / (r[0] + r[1])};
}

using Triplets = std::vector<Eigen::Triplet<double>>;

/// The share of one edge, seen from its inner end v: (-J)(v, v) and, when w is inner too, (-J)(v, w).
void add_edge(int v, int w, double rate, Triplets& entries) {
  if (is_outer(v)) return;
  entries.emplace_back(v - 3, v - 3, rate);
  if (!is_outer(w)) entries.emplace_back(v - 3, w - 3, -rate);
}

}  // namespace

template <class T>
std::vector<T> angle_sums(const Triangulation& graph, std::span<const T> radii) {
  const T two = number<T>(2);
  std::vector<T> sums(static_cast<std::size_t>(graph.inner_vertices()), number<T>(0));
  for (const Face& face : graph.faces()) add_angles(face, radii, two, sums);
  return sums;
}

template std::vector<double> angle_sums(const Triangulation&, std::span<const double>);
template std::vector<MpfrInterval> angle_sums(const Triangulation&, std::span<const MpfrInterval>);

AngleSumDerivative::AngleSumDerivative(const Triangulation& graph, std::span<const double> radii) {
  const NearestRounding nearest;
  Triplets entries;
  for (const Face& face : graph.faces()) {
    const std::array<double, 3> rates =
        opening_rates({radii[static_cast<std::size_t>(face[0])], radii[static_cast<std::size_t>(face[1])],
                       radii[static_cast<std::size_t>(face[2])]});
    for (std::size_t i = 0; i < 3; ++i) {
      const int v = face[(i + 1) % 3], w = face[(i + 2) % 3];
      add_edge(v, w, rates[i], entries);
      add_edge(w, v, rates[i], entries);
    }
  }
  const Eigen::Index size = graph.inner_vertices();
  GCSLAB_CHECK(size > 0);
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factors_.compute(matrix);
}

std::optional<std::vector<double>> AngleSumDerivative::solve(std::span<const double> right_side) const {
  const NearestRounding nearest;
  if (factors_.info() != Eigen::Success) return std::nullopt;
  const Eigen::VectorXd x = factors_.solve(
      Eigen::Map<const Eigen::VectorXd>(right_side.data(), static_cast<Eigen::Index>(right_side.size())));
  if (!x.allFinite()) return std::nullopt;
  return std::vector<double>(x.begin(), x.end());
}

namespace {

std::vector<double> excesses(const Triangulation& graph, std::span<const double> radii) {
  std::vector<double> result = angle_sums<double>(graph, radii);
  for (double& sum : result) sum -= 2 * std::numbers::pi;
  return result;
}

double norm(const std::vector<double>& x) {
  return Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())).norm();
}

double largest(const std::vector<double>& x) {
  double result = 0;
  for (const double entry : x) result = std::max(result, std::fabs(entry));
  return result;
}

std::vector<double> moved(std::vector<double> radii, const std::vector<double>& step, double part) {
  for (std::size_t i = 0; i < step.size(); ++i) radii[i + 3] *= std::exp(part * step[i]);
  return radii;
}

}  // namespace

std::optional<std::vector<double>> approximate_radii(const Triangulation& graph,
                                                     const std::array<double, 3>& outer_radii) {
  const NearestRounding nearest;
  constexpr int kMaximumSteps = 200;
  constexpr double kLongestStep = 2;  // a factor of about seven a radius
  std::vector<double> radii(outer_radii.begin(), outer_radii.end());
  radii.resize(static_cast<std::size_t>(graph.vertices()), *std::ranges::min_element(outer_radii) / 4);
  std::vector<double> excess = excesses(graph, radii);
  for (int i = 0; i < kMaximumSteps; ++i) {
    const auto step = AngleSumDerivative(graph, radii).solve(excess);
    if (!step) return std::nullopt;
    if (largest(*step) < 1e-12) return moved(std::move(radii), *step, 1);
    // The norm of the excess falls along Newton's direction, so that a short enough part of it gains.
    double part = std::min(1.0, kLongestStep / largest(*step));
    std::vector<double> next = moved(radii, *step, part);
    std::vector<double> next_excess = excesses(graph, next);
    while (!(norm(next_excess) < norm(excess)) && part > 1e-6) {
      part /= 2;
      next = moved(radii, *step, part);
      next_excess = excesses(graph, next);
    }
    if (!(norm(next_excess) < norm(excess)))
      return largest(*step) < 1e-6 ? std::optional(radii) : std::nullopt;
    radii = std::move(next);
    excess = std::move(next_excess);
  }
  return std::nullopt;
}

}  // namespace gcslab
