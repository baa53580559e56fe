#include "homotopy/path_trace.h"

#include <algorithm>

namespace gcslab {
namespace {

/// The points after the first one, each step in so many parts.
std::vector<std::vector<double>> subdivided(const std::vector<CurvePoint>& steps, std::size_t parts) {
  std::vector<std::vector<double>> points;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    for (std::size_t k = 1; k < parts; ++k) {
      const double u = static_cast<double>(k) / static_cast<double>(parts);
      points.push_back(point_between(steps[i - 1], steps[i], u));
    }
    points.push_back(steps[i].v);
  }
  return points;
}

/// At most `most` of them: the last, and others at equal distances in the list.
std::vector<std::vector<double>> thinned(std::vector<std::vector<double>> points, std::size_t most) {
  if (points.size() <= most) return points;
  std::vector<std::vector<double>> kept;
  for (std::size_t k = 1; k <= most; ++k) kept.push_back(std::move(points[k * points.size() / most - 1]));
  return kept;
}

}  // namespace

PathObserver PathTrace::observer() {
  return [this](const PathState& state) {
    if (state.path.steps == 1) {
      forward_.clear();
      backward_.clear();
    }
    Steps& steps = state.direction > 0 ? forward_ : backward_;
    if (steps.empty()) steps.push_back(*state.before);
    steps.push_back(state.here);
  };
}

void PathTrace::end_at(const std::vector<double>& v) {
  Steps& steps = backward_.empty() ? forward_ : backward_;
  if (!steps.empty()) steps.back().v = v;
}

std::size_t PathTrace::steps() const {
  const auto steps_of = [](const Steps& steps) { return steps.empty() ? 0 : steps.size() - 1; };
  return steps_of(forward_) + steps_of(backward_);
}

PathTrace::Samples PathTrace::samples(std::size_t most) const {
  if (steps() == 0) return {};
  const std::size_t places = std::max<std::size_t>(most, 2) - 1;  // beside the start
  const std::size_t parts = std::max<std::size_t>(1, places / steps());
  std::vector<std::vector<double>> before = subdivided(backward_, parts), after = subdivided(forward_, parts);
  const std::size_t all = before.size() + after.size();
  if (all > places) {
    const std::size_t share = before.size() * places / all;
    before = thinned(std::move(before), share);
    after = thinned(std::move(after), places - share);
  }
  Samples result;
  result.points.assign(before.rbegin(), before.rend());
  result.start = result.points.size();
  result.points.push_back((forward_.empty() ? backward_ : forward_).front().v);
  result.points.insert(result.points.end(), after.begin(), after.end());
  return result;
}

}  // namespace gcslab
