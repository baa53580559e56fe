#include "homotopy/sketch_solver.h"

#include <algorithm>
#include <cmath>

#include "certification/point_certifier.h"
#include "homotopy/level_crossing.h"

namespace gcslab {
namespace {

/// Uncertified points nearer than this part of their size are one.
constexpr double kSame = 1e-7;

bool is_in(const std::vector<double>& point, const Box& box) {
  for (std::size_t i = 0; i < point.size(); ++i) {
    if (!contains(box[i], point[i])) return false;
  }
  return true;
}

/// Farther out than rounding tells: a circle of negative radius, for example, is no figure.
bool is_outside(const std::vector<double>& point, const Box& box) {
  for (std::size_t i = 0; i < point.size(); ++i) {
    const double slack = kSame * std::max(1.0, std::abs(point[i]));
    if (point[i] < box[i].lower - slack || point[i] > box[i].upper + slack) return true;
  }
  return false;
}

bool is_near(const std::vector<double>& a, const std::vector<double>& b) {
  double distance = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    distance = std::max(distance, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(a[i]));
  }
  return distance <= kSame * size;
}

/// Whether it is the root of an earlier solution: in its uniqueness box, or near where nothing is proved.
bool is_same(const SketchSolution& solution, const std::vector<double>& point) {
  return solution.root ? is_in(point, solution.root->uniqueness_box) : is_near(solution.unknowns, point);
}

}  // namespace

SketchSolutions solutions_of(Path path, FigureCurve& figures, const SystemFunctions& wanted,
                             const std::string& certifier) {
  SketchSolutions result;
  result.path = std::move(path);
  std::erase_if(result.path.crossings, [&](const Crossing& crossing) {
    return is_outside(figures.unknowns(crossing.v), wanted.system().box);
  });
  PointCertifier prover(wanted, certifier);
  for (const Crossing& crossing : result.path.crossings) {
    const std::vector<double> unknowns = figures.unknowns(crossing.v);
    const auto known =
        std::ranges::find_if(result.solutions, [&](const SketchSolution& s) { return is_same(s, unknowns); });
    result.solution_of_crossing.push_back(static_cast<std::size_t>(known - result.solutions.begin()));
    if (known != result.solutions.end()) continue;
    const bool is_regular = crossing.rank == figures.size();
    result.solutions.push_back({unknowns, is_regular ? prover.certify(unknowns) : std::nullopt, crossing.rank,
                                !is_regular && lies_on_continuum(figures, crossing.v)});
  }
  return result;
}

SketchSolutions solve_along_path(FigureCurve& figures, Curve& curve, const std::vector<double>& start,
                                 const SystemFunctions& wanted, const TrackerOptions& options,
                                 const std::string& certifier, const std::stop_token& stop,
                                 const PathAids& aids) {
  return solutions_of(follow_path(curve, start, options, stop, aids), figures, wanted, certifier);
}

}  // namespace gcslab
