#include "homotopy/curve_point.h"

#include <algorithm>
#include <cmath>

namespace gcslab {

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

}  // namespace gcslab
