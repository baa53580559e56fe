#include "geometry/degrees_of_freedom.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

#include "base/random.h"
#include "expression/tape_evaluator.h"
#include "geometry/bipartite_matching.h"
#include "geometry/figure_projection.h"
#include "geometry/sketch.h"

namespace gcslab {
namespace {

Incidence incidence_of(const GeometricEquations& equations) {
  Incidence rows;
  for (const Expression& equation : equations.equations) {
    std::set<std::size_t> unknowns;
    const std::vector<bool> reached = reachable_from({&equation, 1});
    for (std::uint32_t node = 0; node < reached.size(); ++node) {
      const Expression e = equation.graph().node(node);
      if (!reached[node] || e.operation() != Operation::variable) continue;
      const auto variable = static_cast<std::size_t>(e.variable());
      if (variable < equations.unknowns.size()) unknowns.insert(variable);
    }
    rows.emplace_back(unknowns.begin(), unknowns.end());
  }
  return rows;
}

/// The constraints that have one of the equations.
template <class IsChosen>
std::vector<std::size_t> constraints_of(const GeometricEquations& equations, const IsChosen& is_chosen) {
  std::set<std::size_t> result;
  for (std::size_t k = 0; k < equations.equations.size(); ++k) {
    const std::optional<std::size_t> constraint = equations.constraint_of_equation[k];
    if (constraint && is_chosen(k)) result.insert(*constraint);
  }
  return {result.begin(), result.end()};
}

/// The objects that have one of the unknowns as a coordinate.
template <class IsChosen>
std::vector<std::size_t> objects_of(const GeometricEquations& equations, const IsChosen& is_chosen) {
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < equations.objects.size(); ++k) {
    const auto is_unknown = [&](const Expression& coordinate) {
      return !coordinate.is_constant() && is_chosen(static_cast<std::size_t>(coordinate.variable()));
    };
    if (std::ranges::any_of(equations.objects[k], is_unknown)) result.push_back(k);
  }
  return result;
}

/// The sketch with every coordinate moved by up to a twentieth of its size, or a random figure.
Figure drawn(const ConstraintSystem& system, std::uint64_t seed) {
  constexpr double kPart = 0.05;
  ConstraintSystem random_one = system;
  random_one.sketch.reset();
  random_one.random_sketch = seed;
  if (!system.sketch) return *sketch_of(random_one);
  double size = 0;
  for (const auto& object : *system.sketch) {
    for (const double x : object) size = std::max(size, std::abs(x - system.sketch->front().front()));
  }
  Random random(seed, "witness");
  Figure figure = *system.sketch;
  for (std::size_t k = 0; k < figure.size(); ++k) {
    const auto& names = coordinate_names(system.objects[k].sort, system.universe);
    for (std::size_t i = 0; i < names.size(); ++i)
      figure[k][i] += random.uniform(-kPart, kPart) * (names[i].role == Role::direction ? 1 : size);
  }
  return figure;
}

/// The Jacobian by the unknowns, each row of length 1.
Eigen::MatrixXd jacobian_at(const GeometricEquations& equations, std::vector<double> unknowns,
                            const std::vector<double>& parameters) {
  const auto columns = static_cast<Eigen::Index>(unknowns.size());
  Eigen::MatrixXd result(static_cast<Eigen::Index>(equations.equations.size()), columns);
  unknowns.insert(unknowns.end(), parameters.begin(), parameters.end());
  const Tape tape(equations.equations, static_cast<int>(unknowns.size()));
  TapeEvaluator<double> evaluator(tape);
  evaluator.evaluate(unknowns);
  for (Eigen::Index k = 0; k < result.rows(); ++k) {
    const auto gradient = evaluator.reverse_gradient(static_cast<std::size_t>(k));
    for (Eigen::Index i = 0; i < columns; ++i) result(k, i) = gradient[static_cast<std::size_t>(i)];
    const double length = result.row(k).norm();
    if (length > 0) result.row(k) /= length;
  }
  return result;
}

WitnessDiagnosis diagnosis_of(const Eigen::MatrixXd& jacobian, const GeometricEquations& equations) {
  constexpr double kSmall = 1e-7;  // of a singular value, and of a part of a vector of length 1
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::VectorXd& values = svd.singularValues();
  const Eigen::Index rank = (values.array() > kSmall * values[0]).count();
  const auto is_in_kernel = [&](const Eigen::MatrixXd& basis, std::size_t row) {
    return basis.row(static_cast<Eigen::Index>(row)).tail(basis.cols() - rank).norm() > kSmall;
  };
  WitnessDiagnosis result;
  result.rank = static_cast<std::size_t>(rank);
  result.redundant = constraints_of(equations, [&](std::size_t k) { return is_in_kernel(svd.matrixU(), k); });
  result.movable = objects_of(equations, [&](std::size_t i) { return is_in_kernel(svd.matrixV(), i); });
  return result;
}

std::optional<WitnessDiagnosis> diagnosis_at(const ConstraintSystem& system, const Frame& frame,
                                             const GeometricEquations& equations, std::uint64_t seed) {
  try {
    const Figure figure = in_frame(system, frame, drawn(system, seed));
    const FigureProjection witness =
        satisfy_common_equations(system, equations, unknowns_of(equations, figure));
    if (!witness.holds) return std::nullopt;
    const Eigen::MatrixXd jacobian = jacobian_at(
        equations, witness.unknowns, parameters_of(system, figure_at(equations, witness.unknowns)));
    if (!jacobian.allFinite()) return std::nullopt;
    return diagnosis_of(jacobian, equations);
  } catch (const InputError&) {  // no frame, or a measure that is undefined: another figure may do
    return std::nullopt;
  }
}

std::string names_of(const ConstraintSystem& system, const std::vector<std::size_t>& objects) {
  std::vector<std::string> names;
  for (const std::size_t object : objects) names.push_back(system.objects[object].name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string descriptions_of(const ConstraintSystem& system, const std::vector<std::size_t>& constraints) {
  std::vector<std::string> texts;
  for (const std::size_t constraint : constraints)
    texts.push_back(system.describe(system.constraints[constraint]));
  return fmt::format("{}", fmt::join(texts, "; "));
}

}  // namespace

StructuralDiagnosis structural_diagnosis(const GeometricEquations& equations) {
  const StructuralParts parts = structural_parts(incidence_of(equations), equations.unknowns.size());
  const auto is_in = [](const std::vector<std::size_t>& sorted) {
    return [&sorted](std::size_t k) { return std::ranges::binary_search(sorted, k); };
  };
  return {parts.matched, constraints_of(equations, is_in(parts.over_rows)),
          objects_of(equations, is_in(parts.under_columns))};
}

std::optional<WitnessDiagnosis> witness_diagnosis(const ConstraintSystem& system, const Frame& frame,
                                                  const GeometricEquations& equations) {
  constexpr std::uint64_t kFigures = 5;
  if (equations.unknowns.empty() || equations.equations.empty()) return std::nullopt;
  std::optional<WitnessDiagnosis> best;
  for (std::uint64_t seed = 0; seed < kFigures; ++seed) {
    const auto found = diagnosis_at(system, frame, equations, seed);
    if (found && (!best || found->rank > best->rank)) best = found;
  }
  return best;
}

std::string structure_text(const ConstraintSystem& system, const StructuralDiagnosis& diagnosis) {
  std::vector<std::string> texts;
  if (!diagnosis.over.empty())
    texts.push_back("over-constrained: " + descriptions_of(system, diagnosis.over));
  if (!diagnosis.under.empty()) texts.push_back("under-constrained: " + names_of(system, diagnosis.under));
  if (texts.empty()) return "no part is over- or under-constrained";
  return fmt::format("{}", fmt::join(texts, "; "));
}

std::string witness_text(const ConstraintSystem& system, const GeometricEquations& equations,
                         const WitnessDiagnosis& diagnosis) {
  std::string text = fmt::format("rank {} of {} equations in {} unknowns at a witness", diagnosis.rank,
                                 equations.equations.size(), equations.unknowns.size());
  if (!diagnosis.redundant.empty())
    text += "; redundant, each given the others: " + descriptions_of(system, diagnosis.redundant);
  if (!diagnosis.movable.empty()) text += "; movable: " + names_of(system, diagnosis.movable);
  return text;
}

}  // namespace gcslab
