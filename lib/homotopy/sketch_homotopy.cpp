#include "homotopy/sketch_homotopy.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "homotopy/starting_figure.h"

namespace gcslab {
namespace {

std::size_t supporting_parameter(const ConstraintSystem& system) {
  for (const Constraint& constraint : system.constraints) {
    const bool is_length = constraint.kind->name == "distance";
    if (is_length && constraint.kind->interpretations[constraint.interpretation].name == "norm")
      return *constraint.parameter;
  }
  throw NotApplicable("interpolation=compact_support needs a distance with interpretation: norm");
}

std::unique_ptr<ParameterPath> parameter_path(Interpolation interpolation, const ConstraintSystem& system,
                                              const std::vector<double>& sketch,
                                              const std::vector<double>& wanted) {
  if (interpolation == Interpolation::linear) return linear_path(sketch, wanted);
  return compact_support_path(sketch, wanted, supporting_parameter(system));
}

/// Equations of constraints without a parameter, and, as not all of them hold in a sketch as it is drawn, of
/// constraints that share one.
std::vector<std::size_t> common_equations(const ConstraintSystem& system,
                                          const GeometricEquations& equations) {
  std::vector<int> uses(system.parameters.size(), 0);
  for (const Constraint& constraint : system.constraints) {
    if (constraint.parameter) ++uses[*constraint.parameter];
  }
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < equations.equations.size(); ++k) {
    const std::optional<std::size_t> number = equations.constraint_of_equation[k];
    if (!number) continue;
    const std::optional<std::size_t> parameter = system.constraints[*number].parameter;
    if (!parameter || uses[*parameter] > 1) result.push_back(k);
  }
  return result;
}

double size_of(const std::vector<double>& unknowns) {
  double size = 0;
  for (const double x : unknowns) size = std::max(size, std::abs(x));
  return size > 0 ? size : 1;
}

double longest_distance(const ConstraintSystem& system, const std::vector<double>& wanted) {
  double longest = 0;
  for (const Constraint& constraint : system.constraints) {
    if (constraint.kind->name == "distance") longest = std::max(longest, wanted[*constraint.parameter]);
  }
  return longest;
}

/// max |H_k| of these equations.
double largest(Homotopy& homotopy, const std::vector<double>& v, const std::vector<std::size_t>& equations) {
  std::vector<double> values(homotopy.size());
  double result = 0;
  if (!homotopy.values(v, values)) return result;
  for (const std::size_t k : equations) result = std::max(result, std::abs(values[k]));
  return result;
}

}  // namespace

SketchHomotopy::SketchHomotopy(const ConstraintSystem& system, const Frame& frame,
                               const GeometricEquations& equations, const std::vector<double>& wanted,
                               const Figure& sketch, const SketchHomotopyOptions& options) {
  constexpr double kNearlySatisfied = 0.01;
  const std::vector<std::size_t> common = common_equations(system, equations);
  const auto set_out = [&](bool as_drawn) {
    const StartingFigure first = starting_figure(system, frame, equations, sketch, as_drawn);
    unit_ = size_of(first.unknowns);
    homotopy_.emplace(equations, parameter_path(options.interpolation, system, first.parameters, wanted),
                      unit_);
    start_ = homotopy_->point(first.unknowns, 0);
    homotopy_->use(options.linear_algebra);
    homotopy_->balance(start_);
  };
  bool is_as_drawn = options.booleans == Booleans::perturbed;
  set_out(is_as_drawn);
  if (is_as_drawn && largest(*homotopy_, start_, common) < kNearlySatisfied) {
    is_as_drawn = false;
    set_out(is_as_drawn);
  }
  extent_ = std::max(unit_, longest_distance(system, wanted));
  if (options.booleans == Booleans::kept) return;
  for (const std::size_t k : common) homotopy_->perturb(k, start_, is_as_drawn ? 0 : options.leading);
}

}  // namespace gcslab
