#include "homotopy/sketch_solver.h"

#include <algorithm>
#include <cmath>

#include "certification/root_certifier.h"

namespace gcslab {
namespace {

constexpr int kBits = 53;
/// Uncertified points nearer than this part of their size are one.
constexpr double kSame = 1e-7;

bool is_in(const std::vector<double>& point, const Box& box) {
  for (std::size_t i = 0; i < point.size(); ++i) {
    if (!contains(box[i], point[i])) return false;
  }
  return true;
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

std::optional<CertifiedRoot> certified(const std::vector<double>& point, NewtonIteration& newton,
                                       RootCertifier& certifier) {
  constexpr double kRadius = 1e-6;
  Box around;
  for (const double x : point) {
    const double reach = kRadius * std::max(std::abs(x), 1.0);
    around.emplace_back(x - reach, x + reach);
  }
  const std::optional<ApproximateRoot> approximate = newton.run(around);
  return approximate ? certifier.certify(*approximate, around) : std::nullopt;
}

}  // namespace

SketchSolutions solve_along_path(Homotopy& homotopy, const StartingFigure& start,
                                 const SystemFunctions& wanted, const TrackerOptions& options,
                                 const std::string& certifier, const std::stop_token& stop) {
  SketchSolutions result;
  result.path = follow_sketch(homotopy, start.unknowns, options, stop);
  const std::vector<double> scales(wanted.variables(), 1.0);
  NewtonIteration newton(wanted, scales);
  const auto prover = make_root_certifier(certifier, wanted, scales, kBits);
  for (const Crossing& crossing : result.path.crossings) {
    const auto known = std::ranges::find_if(
        result.solutions, [&](const SketchSolution& s) { return is_same(s, crossing.unknowns); });
    result.solution_of_crossing.push_back(static_cast<std::size_t>(known - result.solutions.begin()));
    if (known != result.solutions.end()) continue;
    result.solutions.push_back({crossing.unknowns, certified(crossing.unknowns, newton, *prover)});
  }
  return result;
}

}  // namespace gcslab
