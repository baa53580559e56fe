#include "homotopy/level_crossing.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "homotopy/corrector.h"

namespace gcslab {
namespace {

constexpr int kIterations = 10;
constexpr double kExact = 1e-15;

Cubic cubic_of_t(const CurvePoint& a, const CurvePoint& b) {
  return cubic_between(a, b, distance(a.v, b.v), a.v.size() - 1);
}

/// Where t has its extremum between points with slopes of opposite signs.
double extremum(const Cubic& t) {
  double low = 0, high = 1;
  for (int k = 0; k < 40; ++k) {
    const double middle = (low + high) / 2;
    (t.slope(middle) * t.start_slope > 0 ? low : high) = middle;
  }
  return low;
}

/// Singular values below that part of the largest one are taken for 0.
constexpr double kSingular = 1e-7;

/// The values and the m by m Jacobian by the coordinates but t; false where undefined.
bool evaluate(Curve& curve, const std::vector<double>& v, Eigen::VectorXd& values, Eigen::MatrixXd& matrix) {
  const auto m = static_cast<Eigen::Index>(curve.size());
  Matrix<double> jacobian(curve.size(), curve.size() + 1);
  values.resize(m);
  if (!curve.jacobian(v, {values.data(), curve.size()}, jacobian)) return false;
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  matrix = Eigen::Map<const RowMajor>(jacobian.data(), m, m + 1).leftCols(m);
  return true;
}

/// The same as solve_at_level by least changes, which needs no full rank; the rank. Nothing where the
/// equations are undefined or it does not converge.
std::optional<std::size_t> solve_singular(Curve& curve, std::vector<double>& v) {
  Eigen::VectorXd values;
  Eigen::MatrixXd matrix;
  double change = HUGE_VAL;
  Eigen::Index rank = 0;
  for (int k = 0; k < 2 * kIterations && change > kExact * (1 + norm(v)); ++k) {
    if (!evaluate(curve, v, values, matrix)) return std::nullopt;
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition(matrix.rows(), matrix.cols());
    decomposition.setThreshold(kSingular);
    decomposition.compute(matrix);
    rank = decomposition.rank();
    const Eigen::VectorXd step = decomposition.solve(values);
    for (Eigen::Index i = 0; i < step.size(); ++i) v[static_cast<std::size_t>(i)] -= step[i];
    change = step.norm();
  }
  if (!(change <= 1e-10 * (1 + norm(v)))) return std::nullopt;
  return static_cast<std::size_t>(rank);
}

}  // namespace

bool solve_at_level(Curve& curve, std::vector<double>& v) {
  const std::size_t m = curve.size();
  std::vector<double> values(m), change(m + 1), border(m + 1, 0.0);
  border[m] = 1;
  Matrix<double> jacobian(m, m + 1);
  BorderedMatrix matrix(curve.pattern());
  double before = HUGE_VAL;
  for (int k = 0; k < kIterations; ++k) {
    if (!curve.jacobian(v, values, jacobian) || !matrix.factorise(jacobian, border)) return false;
    if (matrix.pivot_ratio() > 1 / kSingular) return false;
    matrix.solve(values, 0, change);
    const double length = norm(change);
    const double size = 1 + norm(v);
    if (!(length < before / 2)) return length <= 1e-9 * size;
    for (std::size_t i = 0; i < m; ++i) v[i] -= change[i];
    if (length <= kExact * size) return true;
    before = length;
  }
  return true;
}

bool lies_on_continuum(Curve& curve, const std::vector<double>& v) {
  constexpr double kAway = 1e-3;
  Eigen::VectorXd values;
  Eigen::MatrixXd matrix;
  if (!evaluate(curve, v, values, matrix)) return false;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition(matrix.rows(), matrix.cols());
  decomposition.setThreshold(kSingular);
  decomposition.compute(matrix);
  const Eigen::MatrixXd nullspace = (decomposition.colsPermutation() * decomposition.matrixZ().transpose())
                                        .rightCols(matrix.cols() - decomposition.rank());
  for (Eigen::Index k = 0; k < nullspace.cols(); ++k) {
    std::vector<double> moved = v;
    for (Eigen::Index i = 0; i < values.size(); ++i)
      moved[static_cast<std::size_t>(i)] += kAway * nullspace(i, k);
    const double away = solve_singular(curve, moved) ? distance(moved, v) : 0;
    if (away > kAway / 2 && away < 2 * kAway) return true;
  }
  return false;
}

bool crosses(double level, const CurvePoint& a, const CurvePoint& b) {
  return (a.v.back() - level) * (b.v.back() - level) < 0 || (b.v.back() == level && a.v.back() != level);
}

bool crosses_twice(double level, const CurvePoint& a, const CurvePoint& b) {
  constexpr double kTooNear = 1e-6;
  const Cubic t = cubic_of_t(a, b);
  if (t.start_slope * t.end_slope >= 0 || (t.start - level) * (t.end - level) <= 0) return false;
  if (distance(a.v, b.v) <= kTooNear) return false;
  return (t.at(extremum(t)) - level) * (t.start - level) < 0;
}

bool turns_near(double level, const CurvePoint& a, const CurvePoint& b) {
  constexpr double kNear = 1e-2;  // in steps
  const Cubic t = cubic_of_t(a, b);
  if (t.start_slope * t.end_slope >= 0 || (t.start - level) * (t.end - level) <= 0) return false;
  return std::abs(t.at(extremum(t)) - level) <= kNear * distance(a.v, b.v);
}

std::optional<CurvePoint> turning_point(Curve& curve, const CurvePoint& a, const CurvePoint& b) {
  Corrector corrector(curve, {CorrectorKind::newton, 1e-14, 20});
  TangentSolver tangents(curve);
  double low = 0, high = 1;
  double at_low = a.tangent.back(), at_high = b.tangent.back();
  CurvePoint point;
  // Regula falsi, Illinois variant (Dowell, Jarratt 1971).
  for (int k = 0; k < 60; ++k) {
    const double u = low + (high - low) * at_low / (at_low - at_high);
    point.v = point_between(a, b, u);
    if (corrector.correct(a, {}, 1, point.v).end == Correction::End::undefined) return std::nullopt;
    if (!tangents.find(point, a.tangent)) return std::nullopt;
    const double slope = point.tangent.back();
    if (std::abs(slope) < 1e-13 || high - low < 1e-15) break;
    if (slope * at_high < 0) {
      low = high;
      at_low = at_high;
    } else {
      at_low /= 2;
    }
    high = u;
    at_high = slope;
  }
  return point;
}

std::size_t rank_at(Curve& curve, const std::vector<double>& v) {
  constexpr double kNearlySingular = 1e-5;  // a double root is known to half of the digits
  Eigen::VectorXd values;
  Eigen::MatrixXd matrix;
  if (!evaluate(curve, v, values, matrix)) return 0;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition(matrix.rows(), matrix.cols());
  decomposition.setThreshold(kNearlySingular);
  decomposition.compute(matrix);
  return static_cast<std::size_t>(decomposition.rank());
}

namespace {

/// The point of the cubic between two points on either side of a level at which t is that.
std::vector<double> point_where(double level, const CurvePoint& a, const CurvePoint& b) {
  const Cubic t = cubic_of_t(a, b);
  double low = 0, high = 1;
  for (int k = 0; k < 40; ++k) {
    const double middle = (low + high) / 2;
    ((t.at(middle) - level) * (t.start - level) > 0 ? low : high) = middle;
  }
  std::vector<double> v = point_between(a, b, high);
  v.back() = level;
  return v;
}

/// Where the curve meets a level on which the Jacobian is singular, as on a continuum of solutions, from
/// points on either side, where it is not: to the fourth power of how far they are.
std::optional<std::vector<double>> limit_at(double level, Curve& curve, const CurvePoint& a,
                                            const CurvePoint& b) {
  constexpr double kAside = 1e-3;
  TangentSolver tangents(curve);
  const auto aside = [&](const CurvePoint& end) -> std::optional<CurvePoint> {
    const double away = std::clamp((end.v.back() - level) / 2, -kAside, kAside);
    CurvePoint point{point_where(level + away, a, b), {}};
    if (!solve_at_level(curve, point.v) || !tangents.find(point, end.tangent)) return std::nullopt;
    return point;
  };
  const std::optional<CurvePoint> before = aside(a), after = aside(b);
  if (!before || !after) return std::nullopt;
  return point_where(level, *before, *after);
}

}  // namespace

std::optional<LevelPoint> point_at(double level, Curve& curve, const CurvePoint& a, const CurvePoint& b) {
  LevelPoint result{point_where(level, a, b), curve.size()};
  const std::vector<double> found = result.v;
  if (solve_at_level(curve, result.v)) return result;
  result.v = limit_at(level, curve, a, b).value_or(found);
  const std::optional<std::size_t> rank = solve_singular(curve, result.v);
  if (!rank) return std::nullopt;
  result.rank = *rank;
  return result;
}

}  // namespace gcslab
