#include "homotopy/curve_point.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace gcslab {
namespace {

/// A kernel vector of the Jacobian at a point.
std::vector<double> direction_of_kernel(Curve& curve, const std::vector<double>& v) {
  const auto m = static_cast<Eigen::Index>(curve.size());
  std::vector<double> values(curve.size());
  Matrix<double> jacobian(curve.size(), curve.size() + 1);
  curve.jacobian(v, values, jacobian);
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(Eigen::Map<const RowMajor>(jacobian.data(), m, m + 1),
                                              Eigen::ComputeFullV);
  const Eigen::VectorXd last = svd.matrixV().col(m);
  return {last.data(), last.data() + last.size()};
}

}  // namespace

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

double norm(const std::vector<double>& a) { return std::sqrt(dot(a, a)); }

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

double largest(const std::vector<double>& a) {
  double result = 0;
  for (const double x : a) result = std::max(result, std::abs(x));
  return result;
}

std::vector<double> point_between(const CurvePoint& a, const CurvePoint& b, double u) {
  const double span = distance(a.v, b.v);
  std::vector<double> result;
  for (std::size_t i = 0; i < a.v.size(); ++i) result.push_back(cubic_between(a, b, span, i).at(u));
  return result;
}

TangentSolver::TangentSolver(Curve& curve)
    : curve_(&curve),
      matrix_(curve.pattern()),
      values_(curve.size()),
      zero_(curve.size(), 0.0),
      change_(curve.size() + 1),
      jacobian_(curve.size(), curve.size() + 1) {}

bool TangentSolver::find(CurvePoint& point, std::span<const double> along) {
  if (!curve_->jacobian(point.v, values_, jacobian_) || !matrix_.factorise(jacobian_, along)) return false;
  point.tangent.resize(point.v.size());
  matrix_.solve(zero_, 1, point.tangent);
  const double length = norm(point.tangent);
  for (double& x : point.tangent) x /= length;
  point.orientation = matrix_.determinant_sign();
  return true;
}

double TangentSolver::polish(CurvePoint& point) {
  matrix_.solve(values_, 0, change_);
  for (std::size_t i = 0; i < change_.size(); ++i) point.v[i] -= change_[i];
  return norm(change_);
}

CurvePoint starting_point(Curve& curve, const std::vector<double>& start) {
  CurvePoint result{start, {}};
  std::vector<double> values(curve.size());
  Matrix<double> jacobian(curve.size(), curve.size() + 1);
  if (!curve.jacobian(start, values, jacobian))
    throw NotApplicable("the sketch has points at which the equations are undefined");
  TangentSolver tangents(curve);
  std::vector<double> border(start.size(), 0.0);
  border.back() = 1;
  if (!tangents.find(result, border) && !tangents.find(result, direction_of_kernel(curve, start)))
    throw NotApplicable(
        "the sketch is singular: its constraints depend on each other there, draw it otherwise");
  return result;
}

}  // namespace gcslab
