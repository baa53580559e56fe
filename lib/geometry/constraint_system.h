#pragma once

// A figure described by what is true of it: objects, constraints between them, and values of the parameters.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/constraint_kind.h"

namespace gcslab {

struct NamedObject {
  std::string name;
  Sort sort;
};

struct Constraint {
  const ConstraintKind* kind;
  std::vector<std::size_t> objects;      ///< of the sorts of the kind
  std::optional<std::size_t> parameter;  ///< number of the parameter, of metric kinds
  std::size_t interpretation = 0;        ///< number among those of the kind
};

/// Values for all parameters, in their order, as constant expressions of their own graph: 1.3, sqrt(2), 30
/// deg.
struct Valuation {
  std::string name;
  std::vector<Expression> values;
};

/// Coordinates of all objects: figure[k][i] is coordinate i of object k, as sort.h lists them.
using Figure = std::vector<std::vector<double>>;

/// Where a figure is held: the first point is the origin, the second lies on the x axis, the third, in space,
/// in the xy plane. Empty: coordinates are free, and constraints must hold the figure.
using Frame = std::vector<std::size_t>;

struct ConstraintSystem {
  Universe universe = Universe::space;
  std::vector<NamedObject> objects;  ///< points first, the others in the order of their sorts
  std::vector<Constraint> constraints;
  std::vector<std::string> parameters;
  std::vector<Valuation> valuations;  ///< the first is the default; at least one
  std::shared_ptr<ExpressionGraph> values_graph = std::make_shared<ExpressionGraph>();
  std::optional<Frame> frame;                  ///< as the user said; nothing: to be chosen
  std::optional<Figure> sketch;                ///< coordinates that the user gave
  std::optional<std::uint64_t> random_sketch;  ///< the seed of a random one

  /// How many objects are points: objects 0, 1, ...
  std::size_t points() const;
  /// The names of all objects.
  std::vector<std::string> names() const;
  /// "constraint 3, distance P0 P1".
  std::string describe(const Constraint& constraint) const;
  /// The valuation of that name; of the empty name, the default. Throws InputError with the nearest name.
  const Valuation& valuation(const std::string& name) const;
  /// What a constraint is about, where these are the coordinates of all objects; without auxiliaries.
  ConstraintPlace place(const Constraint& constraint, const std::vector<Vector>& coordinates) const;
};

/// Each coordinate of each object a variable of its own, numbered in order, and their values in a figure in
/// the same order.
std::vector<Vector> coordinate_variables(const ConstraintSystem& system, ExpressionGraph& graph);
std::vector<double> coordinates_in_order(const Figure& figure);

}  // namespace gcslab
