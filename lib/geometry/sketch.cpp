#include "geometry/sketch.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "base/random.h"
#include "expression/tape_evaluator.h"
#include "geometry/numeric_vector.h"

namespace gcslab {
namespace {

/// A frame's points nearer to a line than this part of their distances leave no direction to tell.
constexpr double kFlat = 1e-9;

/// The axes of the frame's points after the first, as far as they leave a direction to tell.
std::vector<Numbers> frame_axes(const Frame& frame, const Figure& figure) {
  std::vector<Numbers> axes;
  for (std::size_t k = 1; k < frame.size(); ++k) {
    Numbers axis = next_axis(difference(figure[frame[k]], figure[frame[0]]), axes, kFlat);
    if (axis.empty()) break;
    axes.push_back(std::move(axis));
  }
  return axes;
}

/// The axes, completed to a right-handed basis.
std::vector<Numbers> completed(std::vector<Numbers> axes) {
  if (axes.size() == 1) axes.push_back({-axes[0][1], axes[0][0]});
  if (axes[0].size() == 3) {
    const Numbers &x = axes[0], &y = axes[1];
    axes.push_back({x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]});
  }
  return axes;
}

/// Orthonormal axes through the points of the frame, the first of which is the origin.
std::vector<Numbers> axes_of(const ConstraintSystem& system, const Frame& frame, const Figure& figure) {
  std::vector<Numbers> axes = frame_axes(frame, figure);
  if (axes.size() + 1 == frame.size()) return completed(std::move(axes));
  std::string names;
  for (const std::size_t point : frame) names += " " + system.objects[point].name;
  throw InputError("the sketch has the points of the frame," + names +
                   (axes.empty() ? ", at one place" : ", on a line") +
                   "; draw them apart, or choose another frame");
}

Numbers turned(const Numbers& vector, const std::vector<Numbers>& axes) {
  Numbers result;
  for (const Numbers& axis : axes) result.push_back(dot(vector, axis));
  return result;
}

/// The object in the coordinates of these axes at that origin.
Numbers moved(Sort sort, Universe universe, const Numbers& object, const Numbers& origin,
              const std::vector<Numbers>& axes) {
  ObjectParts<double> parts = parts_of(sort, universe, object);
  if (parts.offset) *parts.offset -= dot(parts.direction, origin);
  if (!parts.position.empty()) parts.position = turned(difference(parts.position, origin), axes);
  if (!parts.direction.empty()) parts.direction = turned(parts.direction, axes);
  if (sort == Sort::line && !parts.position.empty())
    parts.position = nearest_to_origin(parts.position, parts.direction);
  return joined(parts);
}

/// Into these axes, with the zeros of the frame exact.
Figure moved_to(const ConstraintSystem& system, const Frame& frame, const Figure& figure,
                const std::vector<Numbers>& axes) {
  const Numbers& origin = figure[frame[0]];
  Figure result;
  for (std::size_t k = 0; k < figure.size(); ++k)
    result.push_back(moved(system.objects[k].sort, system.universe, figure[k], origin, axes));
  for (std::size_t k = 0; k < frame.size(); ++k) {
    for (std::size_t axis = k; axis < origin.size(); ++axis) result[frame[k]][axis] = 0;
  }
  return result;
}

Numbers random_direction(Random& random, std::size_t size) {
  constexpr double kShortest = 0.1;
  while (true) {
    Numbers direction(size);
    for (double& x : direction) x = random.uniform(-1, 1);
    if (dot(direction, direction) >= kShortest * kShortest) return next_axis(direction, {}, 0);
  }
}

Numbers random_object(Sort sort, Universe universe, Random& random) {
  ObjectParts<double> parts = parts_of(sort, universe, Numbers(coordinate_names(sort, universe).size(), 0.0));
  Numbers place(dimension(universe));
  for (double& x : place) x = random.uniform(-1, 1);
  if (!parts.direction.empty()) parts.direction = random_direction(random, place.size());
  if (parts.offset) parts.offset = dot(parts.direction, place);
  if (parts.radius) parts.radius = random.unit();
  if (!parts.position.empty())
    parts.position = sort == Sort::line ? nearest_to_origin(place, parts.direction) : place;
  return joined(parts);
}

Numbers scaled(Sort sort, Universe universe, const Numbers& object, double factor) {
  ObjectParts<double> parts = parts_of(sort, universe, object);
  for (double& x : parts.position) x *= factor;
  if (parts.offset) *parts.offset *= factor;
  if (parts.radius) *parts.radius *= factor;
  return joined(parts);
}

/// By how much the figure's distances of points that constraints name are too small, on the whole.
double wanted_size(const ConstraintSystem& system, const Figure& figure) {
  if (system.valuations.empty()) return 1;
  const std::vector<double> values = values_of(system.valuations.front());
  double wanted = 0, drawn = 0;
  for (const Constraint& constraint : system.constraints) {
    if (constraint.kind->name != "distance" || !constraint.kind->is_about_points()) continue;
    const Numbers side = difference(figure[constraint.objects[0]], figure[constraint.objects[1]]);
    wanted += values[*constraint.parameter] * values[*constraint.parameter];
    drawn += dot(side, side);
  }
  return wanted > 0 && drawn > 0 ? std::sqrt(wanted / drawn) : 1;
}

}  // namespace

std::vector<double> nearest_to_origin(std::vector<double> point, const std::vector<double>& direction) {
  const double along = dot(point, direction);
  for (std::size_t i = 0; i < point.size(); ++i) point[i] -= along * direction[i];
  return point;
}

Figure in_frame(const ConstraintSystem& system, const Frame& frame, const Figure& figure) {
  if (frame.empty()) return figure;
  return moved_to(system, frame, figure, axes_of(system, frame, figure));
}

Figure in_frame_or_on_line(const ConstraintSystem& system, const Frame& frame, const Figure& figure) {
  if (frame.empty()) return figure;
  std::vector<Numbers> axes = frame_axes(frame, figure);
  const Numbers& origin = figure[frame[0]];
  std::vector<Numbers> others;
  for (std::size_t p = 0; p < system.points(); ++p) others.push_back(difference(figure[p], origin));
  for (std::size_t axis = 0; axis < origin.size(); ++axis) {
    others.emplace_back(origin.size(), 0.0);
    others.back()[axis] = 1;
  }
  for (std::size_t k = 0; axes.size() + 1 < frame.size(); ++k) {
    Numbers axis = next_axis(others[k], axes, kFlat);
    if (!axis.empty()) axes.push_back(std::move(axis));
  }
  return moved_to(system, frame, figure, completed(std::move(axes)));
}

bool is_frame_flat(const Frame& frame, const Figure& figure) {
  return frame_axes(frame, figure).size() + 1 < frame.size();
}

double frame_height(const Frame& frame, const Figure& figure) {
  if (frame.size() < 3) return 1;
  const Numbers &a = figure[frame[0]], &b = figure[frame[1]], &c = figure[frame[2]];
  double longest = 0;
  for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&a, &c), std::pair(&b, &c)}) {
    const Numbers side = difference(*from, *to);
    longest = std::max(longest, std::sqrt(dot(side, side)));
  }
  const Numbers axis = next_axis(difference(b, a), {}, 0);
  if (axis.empty()) return 0;
  Numbers rest = difference(c, a);
  const double along = dot(rest, axis);
  for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= along * axis[i];
  return std::sqrt(dot(rest, rest)) / longest;
}

std::vector<double> parameters_of(const ConstraintSystem& system, const Figure& figure) {
  std::vector<double> values(system.parameters.size(), 0.0);
  std::vector<bool> is_read(values.size(), false);
  ExpressionGraph graph;
  const std::vector<Vector> variables = coordinate_variables(system, graph);
  const Numbers coordinates = coordinates_in_order(figure);
  for (const Constraint& constraint : system.constraints) {
    if (!constraint.parameter || is_read[*constraint.parameter]) continue;
    const Tape tape(constraint.kind->measure(system.place(constraint, variables)),
                    static_cast<int>(coordinates.size()));
    TapeEvaluator<double> evaluator(tape);
    evaluator.evaluate(coordinates);
    if (!std::isfinite(evaluator.value()))
      throw InputError(system.describe(constraint) + ": is undefined in the sketch: points coincide");
    values[*constraint.parameter] = evaluator.value();
    is_read[*constraint.parameter] = true;
  }
  return values;
}

std::vector<double> values_of(const Valuation& valuation) {
  std::vector<double> values;
  for (const Expression& value : valuation.values) {
    const Tape tape(value, 0);
    TapeEvaluator<double> evaluator(tape);
    evaluator.evaluate({});
    values.push_back(evaluator.value());
  }
  return values;
}

std::optional<Figure> sketch_of(const ConstraintSystem& system) {
  if (system.sketch || !system.random_sketch) return system.sketch;
  Random random(*system.random_sketch, "sketch");
  Figure figure;
  for (const NamedObject& object : system.objects)
    figure.push_back(random_object(object.sort, system.universe, random));
  const double size = wanted_size(system, figure);
  for (std::size_t k = 0; k < figure.size(); ++k)
    figure[k] = scaled(system.objects[k].sort, system.universe, figure[k], size);
  return figure;
}

}  // namespace gcslab
