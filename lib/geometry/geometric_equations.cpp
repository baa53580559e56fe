#include "geometry/geometric_equations.h"

#include <fmt/format.h>

#include "expression/substitute.h"
#include "geometry/reach.h"

namespace gcslab {
namespace {

void name_coordinates(const ConstraintSystem& system, const FramedCoordinates& framed,
                      GeometricEquations& result) {
  for (std::size_t k = 0; k < system.objects.size(); ++k) {
    const auto& [name, sort] = system.objects[k];
    const std::vector<CoordinateName>& coordinates = coordinate_names(sort, system.universe);
    result.sorts.push_back(sort);
    result.objects.emplace_back();
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      if (sort == Sort::point && framed.is_zero[k][i]) {
        result.objects[k].push_back(result.graph->constant(0));
        continue;
      }
      result.objects[k].push_back(result.graph->variable(static_cast<int>(result.unknowns.size())));
      result.unknowns.push_back(name + "_" + coordinates[i].suffix);
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

/// |n|^2 = 1, |u|^2 = 1 and u.m = 0.
void add_normalisation(const ObjectParts<Expression>& object, GeometricEquations& result) {
  const auto add = [&](const Expression& equation) {
    result.equations.push_back(equation);
    result.constraint_of_equation.emplace_back();
  };
  if (object.direction.empty()) return;
  add(squared_norm(object.direction) - result.graph->constant(1));
  const bool is_line_in_space = !object.position.empty() && !object.radius;
  if (is_line_in_space) add(dot(object.direction, object.position));
}

Interval range_of(Role role, const Reach& reach) {
  switch (role) {
    case Role::direction:
      return {-1, 1};
    case Role::radius:
      return {0, reach.radius};
    case Role::position:
    case Role::offset:
      return {-reach.distance, reach.distance};
  }
  return Interval::entire();
}

}  // namespace

GeometricEquations geometric_equations(const ConstraintSystem& system, const Frame& frame) {
  const FramedCoordinates framed = framed_coordinates(system, frame);
  GeometricEquations result;
  result.universe = system.universe;
  result.parameters = system.parameters;
  name_coordinates(system, framed, result);
  const auto auxiliaries = name_auxiliaries(system, framed, result);
  for (std::size_t c = 0; c < system.constraints.size(); ++c) {
    if (framed.is_absorbed[c]) continue;
    const Constraint& constraint = system.constraints[c];
    ConstraintPlace place = system.place(constraint, result.objects);
    place.auxiliaries = auxiliaries[c];
    std::optional<Expression> parameter;
    if (constraint.parameter)
      parameter = result.graph->variable(static_cast<int>(result.unknowns.size() + *constraint.parameter));
    const Interpretation& chosen = constraint.kind->interpretations[constraint.interpretation];
    for (const Expression& equation : chosen.equations(place, parameter)) {
      result.equations.push_back(equation);
      result.constraint_of_equation.emplace_back(c);
    }
  }
  for (std::size_t k = 0; k < result.objects.size(); ++k)
    add_normalisation(parts_of(result.sorts[k], result.universe, result.objects[k]), result);
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
  const std::vector<Reach> reaches = reaches_of(system, frame, valuation);
  for (std::size_t k = 0; k < equations.objects.size(); ++k) {
    const std::vector<CoordinateName>& names = coordinate_names(equations.sorts[k], equations.universe);
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!equations.objects[k][i].is_constant()) result.box.push_back(range_of(names[i].role, reaches[k]));
    }
  }
  result.box.resize(equations.unknowns.size(), Interval::entire());
  return result;
}

namespace {

/// The objects with `value_of` number i for unknown i, and `zero` where the frame says 0.
template <class Coordinate, class ValueOf>
std::vector<std::vector<Coordinate>> filled(const GeometricEquations& equations, const Coordinate& zero,
                                            const ValueOf& value_of) {
  std::vector<std::vector<Coordinate>> figure;
  for (const Vector& object : equations.objects) {
    figure.emplace_back();
    for (const Expression& coordinate : object)
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
  for (std::size_t k = 0; k < figure.size(); ++k) {
    for (std::size_t i = 0; i < figure[k].size(); ++i) {
      if (!equations.objects[k][i].is_constant()) result.push_back(figure[k][i]);
    }
  }
  result.resize(equations.unknowns.size(), 0.0);
  return result;
}

FigureBox figure_box(const GeometricEquations& equations, const Box& unknowns) {
  return filled(equations, Interval(0), [&](std::size_t i) { return unknowns[i]; });
}

}  // namespace gcslab
