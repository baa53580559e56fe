#include "homotopy/path_explanation.h"

#include <Eigen/Dense>
#include <cmath>

#include "geometry/degeneracies.h"

namespace gcslab {
namespace {

constexpr double kNear = 1e-5;       ///< of what is special, in sizes of figures
constexpr double kFar = 1e3;         ///< in the same, and of t
constexpr double kStuckFar = 1e2;    ///< of where paths are stuck
constexpr double kStuckNear = 1e-3;  ///< of what stops a path

class Explanation {
 public:
  Explanation(const ConstraintSystem& system, const GeometricEquations& equations, FigureCurve& curve,
              double extent)
      : system_(&system), equations_(&equations), curve_(&curve), extent_(extent) {}

  Degeneracies special(const std::vector<double>& v, double far = kFar) const {
    return degeneracies_of(*system_, figure(v), extent_, kNear, far);
  }

  std::string end(PathEnd& end, const std::vector<double>& last) const {
    if (end == PathEnd::cycle || end == PathEnd::budget || last.empty()) return "";
    const Degeneracies found = special(last, end == PathEnd::stuck ? kStuckFar : kFar);
    std::string text = text_of(found, *system_);
    const bool is_t_far = std::abs(last.back()) > kFar;
    if (is_t_far) text += text.empty() ? "t goes to infinity" : "; t goes to infinity";
    if (end == PathEnd::stuck && (is_t_far || !found.far.empty())) end = PathEnd::to_infinity;
    if (end == PathEnd::to_infinity) return text;
    const auto rough = constraint_not_smooth_at(*system_, figure(last), extent_, kStuckNear);
    if (!rough && end == PathEnd::stuck && is_singular(last)) {
      end = PathEnd::to_undefined;
      return "constraints depend on each other" + (text.empty() ? "" : ": " + text);
    }
    if (!rough) return text;
    end = PathEnd::to_undefined;
    return system_->describe(system_->constraints[*rough]) + " is not smooth" +
           (text.empty() ? "" : ": " + text);
  }

 private:
  /// Whether the Jacobian has lost rank there, by much more than where a path turns sharply.
  bool is_singular(const std::vector<double>& v) const {
    constexpr double kSingular = 1e-9;
    const auto m = static_cast<Eigen::Index>(curve_->size());
    std::vector<double> values(curve_->size());
    Matrix<double> jacobian(curve_->size(), curve_->size() + 1);
    if (!curve_->jacobian(v, values, jacobian)) return false;
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(m, m + 1);
    factors.setThreshold(kSingular);
    factors.compute(Eigen::Map<const RowMajor>(jacobian.data(), m, m + 1));
    return factors.rank() < m;
  }

  Figure figure(const std::vector<double>& v) const { return figure_at(*equations_, curve_->unknowns(v)); }

  const ConstraintSystem* system_;
  const GeometricEquations* equations_;
  FigureCurve* curve_;
  double extent_;
};

}  // namespace

PathExplanation explain(Path& path, const ConstraintSystem& system, const GeometricEquations& equations,
                        FigureCurve& curve, double extent) {
  const Explanation explanation(system, equations, curve, extent);
  PathExplanation result;
  for (const BranchPoint& point : path.branch_points)
    result.branch_points.push_back(text_of(explanation.special(point.v), system));
  result.end = explanation.end(path.end, path.last);
  result.other_end = explanation.end(path.other_end, path.other_last);
  return result;
}

}  // namespace gcslab
