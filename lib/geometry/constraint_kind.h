#pragma once

// What a constraint of some kind says of its objects, as equations.
//
// Each word is one file of lib/geometry/constraints and one line of constraint_registry.cpp. A word may have
// several kinds, told apart by the sorts of objects that they are about: the distance of two points, of a
// point and a line. Metric kinds have a parameter, the value of their measure; boolean ones are what they
// say. Everything is an expression in the coordinates of the objects, so that solvers differentiate, bound
// and export it like any other. No kind depends on which of its two sets of coordinates an object has
// (sort.h).

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/registry.h"
#include "geometry/sort.h"
#include "geometry/vector_algebra.h"
#include "interval/interval.h"

namespace gcslab {

/// The objects that a constraint names, by their coordinates, and its auxiliary unknowns.
struct ConstraintPlace {
  Universe universe;
  std::vector<ObjectParts<Expression>> objects;
  std::vector<Expression> auxiliaries{};

  /// From the position of object number `from` to that of number `to`.
  Vector vector(std::size_t from, std::size_t to) const {
    return difference(objects[to].position, objects[from].position);
  }
};

/// That one vector is a multiple of another: det(u, v) = 0 in the plane; v = s u in space, with an unknown s.
std::size_t auxiliaries_of_multiple(Universe universe);
std::vector<Expression> multiple_equations(const ConstraintPlace& place, const Vector& u, const Vector& v);

/// One way to write a constraint. Equations are expressions that vanish where it holds.
struct Interpretation {
  std::string name;
  std::string summary;
  /// The parameter is that of metric kinds.
  std::function<std::vector<Expression>(const ConstraintPlace&, const std::optional<Expression>& parameter)>
      equations;
  /// The equations are smooth where none of these vanishes. Null: everywhere.
  std::function<std::vector<Expression>(const ConstraintPlace&)> not_smooth_at{};
};

/// How near a kind keeps its two objects, by which solvers bound coordinates: points and centres, and the
/// nearest points of lines and planes, are at most this far apart. Nothing; 0; the parameter; the sum of the
/// radii of those that have one.
enum class Nearness { unknown, together, parameter, radii };

struct ConstraintKind {
  std::string name;
  std::string summary;
  std::vector<Universe> universes;              ///< where it makes sense
  std::vector<Sort> sorts;                      ///< of the objects that it names, in the order of all_sorts()
  std::vector<Interpretation> interpretations;  ///< the first is the default
  /// How many degrees of freedom it takes.
  std::function<int(Universe)> restriction = [](Universe) { return 1; };
  /// Unknowns that its equations have beside the objects.
  std::function<std::size_t(Universe)> auxiliaries = [](Universe) { return std::size_t{0}; };
  /// Metric kinds: what a figure shows for the parameter. Null: boolean.
  std::function<Expression(const ConstraintPlace&)> measure{};
  /// Metric kinds: the values that a figure can show.
  Interval possible = Interval::entire();
  Nearness nearness = Nearness::unknown;
  /// It is about pairs of points, which may share a point; otherwise all objects differ.
  bool is_about_pairs = false;
  /// Boolean kinds: the metric one that is 0 exactly where they hold. Empty: none.
  std::string metric_form{};

  bool is_metric() const { return measure != nullptr; }
  bool takes(Universe universe) const;
  /// It names points alone.
  bool is_about_points() const;
};

/// All kinds, in the order of their words.
class ConstraintRegistry {
 public:
  explicit ConstraintRegistry(const std::vector<std::vector<ConstraintKind>>& words);

  const std::vector<ConstraintKind>& entries() const { return kinds_; }
  /// The words, each once.
  const std::vector<std::string>& names() const { return names_; }
  /// The kinds of a word; none when nothing is called so.
  std::vector<const ConstraintKind*> kinds(std::string_view name) const;
  /// The first kind of a word, which is about points where one of them is. Throws InputError that proposes
  /// the nearest name.
  const ConstraintKind& at(std::string_view name) const;

 private:
  std::vector<ConstraintKind> kinds_;
  std::vector<std::string> names_;
};

const ConstraintRegistry& constraint_registry();

constexpr Interval kAnyLength = {0, std::numeric_limits<double>::infinity()};

// One function a file of lib/geometry/constraints: the kinds of a word.
std::vector<ConstraintKind> distance_constraints();
std::vector<ConstraintKind> angle_constraints();
std::vector<ConstraintKind> area_constraints();
std::vector<ConstraintKind> volume_constraints();
std::vector<ConstraintKind> radius_constraints();
std::vector<ConstraintKind> incidence_constraints();
std::vector<ConstraintKind> centre_constraints();
std::vector<ConstraintKind> tangent_constraints();
std::vector<ConstraintKind> collinear_constraints();
std::vector<ConstraintKind> coplanar_constraints();
std::vector<ConstraintKind> parallel_constraints();
std::vector<ConstraintKind> perpendicular_constraints();
std::vector<ConstraintKind> equal_lengths_constraints();
/// fixed_x, fixed_y, fixed_z.
std::vector<ConstraintKind> fixed_coordinate_constraints(std::size_t axis);

}  // namespace gcslab
