#include "geometry/sketch.h"

#include <cmath>
#include <fmt/format.h>

#include "base/random.h"
#include "expression/tape_evaluator.h"

namespace gcslab {
namespace {

using Numbers = std::vector<double>;

/// A frame's points nearer to a line than this part of their distances leave no direction to tell.
constexpr double kFlat = 1e-9;

double dot(const Numbers& a, const Numbers& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

Numbers difference(const Numbers& a, const Numbers& b) {
  Numbers result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - b[i]);
  return result;
}

/// The part of `a` that is orthogonal to the axes, with length 1; empty when that is too little of it.
Numbers next_axis(Numbers a, const std::vector<Numbers>& axes) {
  const double length = std::sqrt(dot(a, a));
  for (int pass = 0; pass < 2; ++pass) {
    for (const Numbers& axis : axes) {
      const double part = dot(a, axis);
      for (std::size_t i = 0; i < a.size(); ++i) a[i] -= part * axis[i];
    }
  }
  const double left = std::sqrt(dot(a, a));
  if (!(left > kFlat * length)) return {};
  for (double& x : a) x /= left;
  return a;
}

}  // namespace

Figure in_frame(const ConstraintSystem& system, const Frame& frame, const Figure& figure) {
  if (frame.empty()) return figure;
  const Numbers& origin = figure[frame[0]];
  std::vector<Numbers> axes;
  for (std::size_t k = 1; k < frame.size(); ++k) {
    axes.push_back(next_axis(difference(figure[frame[k]], origin), axes));
    if (!axes.back().empty()) continue;
    std::string names;
    for (const std::size_t point : frame) names += " " + system.points[point];
    throw InputError("the sketch has the points of the frame," + names +
                     (axes.size() == 1 ? ", at one place" : ", on a line") +
                     "; draw them apart, or choose another frame");
  }
  if (axes.size() == 1) axes.push_back({-axes[0][1], axes[0][0]});
  if (origin.size() == 3) {
    const Numbers &x = axes[0], &y = axes[1];
    axes.push_back({x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]});
  }
  Figure result;
  for (const Numbers& point : figure) {
    const Numbers offset = difference(point, origin);
    result.emplace_back();
    for (const Numbers& axis : axes) result.back().push_back(dot(offset, axis));
  }
  for (std::size_t k = 0; k < frame.size(); ++k) {
    for (std::size_t axis = k; axis < origin.size(); ++axis) result[frame[k]][axis] = 0;
  }
  return result;
}

std::vector<double> parameters_of(const ConstraintSystem& system, const Figure& figure) {
  std::vector<double> values(system.parameters.size(), 0.0);
  std::vector<bool> is_read(values.size(), false);
  for (const Constraint& constraint : system.constraints) {
    if (!constraint.parameter || is_read[*constraint.parameter]) continue;
    ExpressionGraph graph;
    ConstraintPlace place{system.universe, {}};
    Numbers coordinates;
    for (const std::size_t p : constraint.points) {
      place.points.emplace_back();
      for (const double x : figure[p]) {
        place.points.back().push_back(graph.variable(static_cast<int>(coordinates.size())));
        coordinates.push_back(x);
      }
    }
    const Tape tape(constraint.kind->measure(place), static_cast<int>(coordinates.size()));
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
  Figure figure(system.points.size(), Numbers(dimension(system.universe)));
  for (Numbers& point : figure) {
    for (double& x : point) x = random.uniform(-1, 1);
  }
  return figure;
}

}  // namespace gcslab
