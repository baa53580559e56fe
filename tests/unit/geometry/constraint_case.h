#pragma once

// A kind of constraint by itself: objects of its sorts, random figures of them, and values of its equations.

#include <string>
#include <vector>

#include "base/random.h"
#include "expression/tape_evaluator.h"
#include "geometry/geometric_equations.h"
#include "geometry/sketch.h"

namespace gcslab {

struct ConstraintCase {
  const ConstraintKind* kind;
  Universe universe;
};

/// Every kind in every universe that it takes.
inline std::vector<ConstraintCase> all_constraint_cases() {
  std::vector<ConstraintCase> result;
  for (const ConstraintKind& kind : constraint_registry().entries()) {
    for (const Universe universe : kind.universes) result.push_back({&kind, universe});
  }
  return result;
}

/// "distance_point_line_2d".
inline std::string name_of(const ConstraintCase& of) {
  std::string name = of.kind->name;
  for (const Sort sort : of.kind->sorts) name += "_" + name_of(sort);
  return name + (of.universe == Universe::plane ? "_2d" : "_3d");
}

/// A system of this one constraint, without a frame.
inline ConstraintSystem system_of(const ConstraintCase& of, std::size_t interpretation = 0) {
  ConstraintSystem system;
  system.universe = of.universe;
  system.frame = Frame();
  Constraint constraint{of.kind, {}, std::nullopt, interpretation};
  for (std::size_t k = 0; k < of.kind->sorts.size(); ++k) {
    system.objects.push_back({"O" + std::to_string(k), of.kind->sorts[k]});
    constraint.objects.push_back(k);
  }
  if (of.kind->is_metric()) {
    system.parameters.emplace_back("a");
    constraint.parameter = 0;
  }
  system.constraints.push_back(constraint);
  return system;
}

inline Figure random_figure(ConstraintSystem system, Random& random) {
  system.random_sketch = random.next() >> 1;
  return *sketch_of(system);
}

inline std::vector<double> flat(const Figure& figure) {
  std::vector<double> result;
  for (const auto& object : figure) result.insert(result.end(), object.begin(), object.end());
  return result;
}

/// Of all equations, at unknowns and parameters.
inline std::vector<double> values_at(const GeometricEquations& equations,
                                     const std::vector<double>& numbers) {
  const Tape tape(equations.equations,
                  static_cast<int>(equations.unknowns.size() + equations.parameters.size()));
  TapeEvaluator<double> evaluator(tape);
  evaluator.evaluate(numbers);
  std::vector<double> values;
  for (std::size_t k = 0; k < equations.equations.size(); ++k) values.push_back(evaluator.value(k));
  return values;
}

}  // namespace gcslab
