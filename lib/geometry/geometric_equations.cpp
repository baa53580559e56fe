#include "geometry/geometric_equations.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "expression/constant_enclosure.h"
#include "expression/substitute.h"

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void name_coordinates(const ConstraintSystem& system, const FramedCoordinates& framed,
                      GeometricEquations& result) {
  for (std::size_t p = 0; p < system.points.size(); ++p) {
    result.points.emplace_back();
    for (std::size_t axis = 0; axis < framed.is_zero[p].size(); ++axis) {
      if (framed.is_zero[p][axis]) {
        result.points[p].push_back(result.graph->constant(0));
        continue;
      }
      result.points[p].push_back(result.graph->variable(static_cast<int>(result.unknowns.size())));
      result.unknowns.push_back(system.points[p] + "_" + "xyz"[axis]);
    }
  }
}

/// The auxiliary unknowns of every constraint that is not absorbed.
std::vector<std::vector<Expression>> name_auxiliaries(const ConstraintSystem& system,
                                                      const FramedCoordinates& framed,
                                                      GeometricEquations& result) {
  std::vector<std::vector<Expression>> auxiliaries(system.constraints.size());
  for (std::size_t c = 0; c < system.constraints.size(); ++c) {
    if (framed.is_absorbed[c]) continue;
    const std::size_t count = system.constraints[c].kind->auxiliaries(system.universe);
    for (std::size_t k = 0; k < count; ++k) {
      auxiliaries[c].push_back(result.graph->variable(static_cast<int>(result.unknowns.size())));
      result.unknowns.push_back("s" + std::to_string(++result.auxiliaries));
    }
  }
  return auxiliaries;
}

/// Upper bounds of the distances of all points from the first of the frame, along constraints (Dijkstra
/// 1959).
std::vector<double> reaches(const ConstraintSystem& system, const Frame& frame, const Valuation& valuation) {
  std::vector<double> reach(system.points.size(), kInfinity);
  if (frame.empty()) return reach;
  reach[frame[0]] = 0;
  std::vector<bool> is_done(reach.size(), false);
  for (std::size_t round = 0; round < reach.size(); ++round) {
    std::size_t nearest = reach.size();
    for (std::size_t p = 0; p < reach.size(); ++p) {
      if (!is_done[p] && (nearest == reach.size() || reach[p] < reach[nearest])) nearest = p;
    }
    is_done[nearest] = true;
    for (const Constraint& constraint : system.constraints) {
      if (constraint.kind->name != "distance") continue;
      const double length = magnitude(constant_enclosure(valuation.values[*constraint.parameter]));
      for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        if (constraint.points[end] != nearest) continue;
        double& other = reach[constraint.points[1 - end]];
        other = std::min(other, std::nextafter(reach[nearest] + length, kInfinity));
      }
    }
  }
  return reach;
}

}  // namespace

GeometricEquations geometric_equations(const ConstraintSystem& system, const Frame& frame) {
  const FramedCoordinates framed = framed_coordinates(system, frame);
  GeometricEquations result;
  result.parameters = system.parameters;
  name_coordinates(system, framed, result);
  const auto auxiliaries = name_auxiliaries(system, framed, result);
  for (std::size_t c = 0; c < system.constraints.size(); ++c) {
    if (framed.is_absorbed[c]) continue;
    const Constraint& constraint = system.constraints[c];
    ConstraintPlace place{system.universe, {}, auxiliaries[c]};
    for (const std::size_t p : constraint.points) place.points.push_back(result.points[p]);
    std::optional<Expression> parameter;
    if (constraint.parameter)
      parameter = result.graph->variable(static_cast<int>(result.unknowns.size() + *constraint.parameter));
    const Interpretation& chosen = constraint.kind->interpretations[constraint.interpretation];
    for (const Expression& equation : chosen.equations(place, parameter)) {
      result.equations.push_back(equation);
      result.constraint_of_equation.push_back(c);
    }
  }
  return result;
}

std::string balance_text(const GeometricEquations& equations) {
  const std::size_t unknowns = equations.unknowns.size(), count = equations.equations.size();
  std::string text = fmt::format("{} unknowns, {} equations: ", unknowns, count);
  if (unknowns == count) return text + "well-constrained, as far as counting tells";
  if (unknowns < count) return text + fmt::format("over-constrained by {}", count - unknowns);
  return text + fmt::format("under-constrained, {} degrees of freedom are left", unknowns - count);
}

EquationSystem equation_system(const GeometricEquations& equations, const ConstraintSystem& system,
                               const Frame& frame, const Valuation& valuation) {
  EquationSystem result;
  result.variables = equations.unknowns;
  std::vector<Expression> replacements;
  for (std::size_t i = 0; i < equations.unknowns.size(); ++i)
    replacements.push_back(result.graph->variable(static_cast<int>(i)));
  for (const Expression& value : valuation.values)
    replacements.push_back(substitute(value, *result.graph, {}));
  for (const Expression& equation : equations.equations)
    result.equations.push_back(substitute(equation, *result.graph, replacements));
  const std::vector<double> reach = reaches(system, frame, valuation);
  for (std::size_t p = 0; p < equations.points.size(); ++p) {
    for (const Expression& coordinate : equations.points[p]) {
      if (!coordinate.is_constant()) result.box.emplace_back(-reach[p], reach[p]);
    }
  }
  result.box.resize(equations.unknowns.size(), Interval::entire());
  return result;
}

namespace {

/// The points with `value_of` number i for unknown i, and `zero` where the frame says 0.
template <class Coordinate, class ValueOf>
std::vector<std::vector<Coordinate>> filled(const GeometricEquations& equations, const Coordinate& zero,
                                            const ValueOf& value_of) {
  std::vector<std::vector<Coordinate>> figure;
  for (const Vector& point : equations.points) {
    figure.emplace_back();
    for (const Expression& coordinate : point)
      figure.back().push_back(
          coordinate.is_constant() ? zero : value_of(static_cast<std::size_t>(coordinate.variable())));
  }
  return figure;
}

}  // namespace

Figure figure_at(const GeometricEquations& equations, std::span<const double> unknowns) {
  return filled(equations, 0.0, [&](std::size_t i) { return unknowns[i]; });
}

std::vector<double> unknowns_of(const GeometricEquations& equations, const Figure& figure) {
  std::vector<double> result;
  for (std::size_t p = 0; p < figure.size(); ++p) {
    for (std::size_t axis = 0; axis < figure[p].size(); ++axis) {
      if (!equations.points[p][axis].is_constant()) result.push_back(figure[p][axis]);
    }
  }
  result.resize(equations.unknowns.size(), 0.0);
  return result;
}

FigureBox figure_box(const GeometricEquations& equations, const Box& unknowns) {
  return filled(equations, Interval(0), [&](std::size_t i) { return unknowns[i]; });
}

}  // namespace gcslab
