#include "experiments/reporting/label_placement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "experiments/reporting/figure_script.h"

namespace gcslab {
namespace {

constexpr double kTextHeight = 0.8 * kSmallText * kMillimetresPerPoint;
constexpr double kClearance = 0.25;  // around a text
constexpr double kPointReach = 1.0;  // from a point to its text
constexpr double kLineReach = 0.5;   // from a line to its text
constexpr double kPointPenalty = 6;  // of a covered point, in millimetres of covered line
constexpr double kTextPenalty = 60;  // of a covered text
constexpr double kOutsidePenalty = 30;

/// Half of the box's extent along a direction of length 1.
double extent(const PaperPoint& direction, double width, double height) {
  return (std::abs(direction[0]) * width + std::abs(direction[1]) * height) / 2;
}

}  // namespace

bool PaperBox::overlaps(const PaperBox& other) const {
  return std::abs(centre[0] - other.centre[0]) < (width + other.width) / 2 &&
         std::abs(centre[1] - other.centre[1]) < (height + other.height) / 2;
}

double PaperBox::length_inside(const PaperSegment& segment) const {
  // The part [begin, end] of the way that lies between both pairs of sides (Liang, Barsky 1984).
  double begin = 0, end = 1;
  const std::array<double, 2> half = {width / 2, height / 2};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double start = segment.from[axis] - centre[axis], step = segment.to[axis] - segment.from[axis];
    if (step == 0) {
      if (std::abs(start) > half[axis]) return 0;
      continue;
    }
    const double one = (-half[axis] - start) / step, other = (half[axis] - start) / step;
    begin = std::max(begin, std::min(one, other));
    end = std::min(end, std::max(one, other));
  }
  if (begin >= end) return 0;
  return (end - begin) * std::hypot(segment.to[0] - segment.from[0], segment.to[1] - segment.from[1]);
}

LabelPlacer::LabelPlacer(PaperBox page, std::vector<PaperSegment> lines, std::vector<PaperPoint> points)
    : page_(page), lines_(std::move(lines)), points_(std::move(points)) {}

double LabelPlacer::disturbance(const PaperBox& box) const {
  double sum = 0;
  for (const PaperSegment& line : lines_) sum += box.length_inside(line);
  for (const PaperPoint& point : points_) sum += box.overlaps({point, 0.8, 0.8}) ? kPointPenalty : 0;
  for (const PaperBox& other : placed_) sum += box.overlaps(other) ? kTextPenalty : 0;
  const std::array<double, 2> half = {(page_.width - box.width) / 2, (page_.height - box.height) / 2};
  for (std::size_t axis = 0; axis < 2; ++axis)
    sum += std::abs(box.centre[axis] - page_.centre[axis]) > half[axis] ? kOutsidePenalty : 0;
  return sum;
}

PaperPoint LabelPlacer::best_of(const std::vector<Candidate>& candidates, double width, double height) {
  double least = std::numeric_limits<double>::infinity();
  PaperBox best{};
  for (const Candidate& candidate : candidates) {
    const PaperBox box{candidate.centre, width, height};
    const double cost = disturbance(box) + candidate.penalty;
    if (cost < least) {
      least = cost;
      best = box;
    }
  }
  placed_.push_back(best);
  return best.centre;
}

PaperPoint LabelPlacer::beside_point(const PaperPoint& point, const PaperPoint& away,
                                     const std::string& text) {
  constexpr int kDirections = 24;
  const double width = text_width(text) + 2 * kClearance, height = kTextHeight + 2 * kClearance;
  const double length = std::hypot(away[0], away[1]);
  std::vector<Candidate> candidates;
  for (const double more : {0.0, 1.0, 2.2}) {
    for (int k = 0; k < kDirections; ++k) {
      const double angle = 2 * std::numbers::pi * k / kDirections;
      const PaperPoint d = {std::cos(angle), std::sin(angle)};
      const double reach = kPointReach - kClearance + more + extent(d, width, height);
      const double cosine = length == 0 ? 0 : (d[0] * away[0] + d[1] * away[1]) / length;
      candidates.push_back({{point[0] + reach * d[0], point[1] + reach * d[1]}, 0.3 * (1 - cosine) + more});
    }
  }
  return best_of(candidates, width, height);
}

PaperPoint LabelPlacer::beyond_point(const PaperPoint& point, const PaperPoint& direction,
                                     const std::string& text) {
  constexpr double kStep = 0.5;
  constexpr int kSteps = 18, kDirections = 32;
  constexpr double kDear = 0.3;  // a millimetre farther, in millimetres of covered line
  const double width = text_width(text) + 2 * kClearance, height = kTextHeight + 2 * kClearance;
  const double straight = std::atan2(direction[1], direction[0]);
  std::vector<Candidate> candidates;
  for (int step = 0; step <= kSteps; ++step) {
    const double more = kStep * step;
    for (int k = 0; k < kDirections; ++k) {
      const double aside = 2 * std::numbers::pi * k / kDirections;
      const PaperPoint d = {std::cos(straight + aside), std::sin(straight + aside)};
      const double reach = kLineReach + more + extent(d, width, height);
      candidates.push_back(
          {{point[0] + reach * d[0], point[1] + reach * d[1]}, kDear * more + 2 * (1 - std::cos(aside))});
    }
  }
  return best_of(candidates, width, height);
}

PaperPoint LabelPlacer::beside_line(const PaperSegment& line, const std::string& text) {
  constexpr int kSteps = 12;
  constexpr double kFarthest = 0.42;  // of the line's length, from its middle
  const double width = text_width(text) + 2 * kClearance, height = kTextHeight + 2 * kClearance;
  const double dx = line.to[0] - line.from[0], dy = line.to[1] - line.from[1], length = std::hypot(dx, dy);
  const PaperPoint normal = length == 0 ? PaperPoint{0, 1} : PaperPoint{-dy / length, dx / length};
  std::vector<Candidate> candidates;
  for (int step = -kSteps; step <= kSteps; ++step) {
    const double off = kFarthest * step / kSteps;
    const PaperPoint foot = {line.from[0] + (0.5 + off) * dx, line.from[1] + (0.5 + off) * dy};
    for (const double more : {0.0, 1.5, 3.0, 4.5, 6.0}) {
      const double reach = kLineReach + more + extent(normal, width, height);
      for (const double side : {1.0, -1.0})
        candidates.push_back({{foot[0] + side * reach * normal[0], foot[1] + side * reach * normal[1]},
                              2 * std::abs(off) + more + (side * normal[1] < 0 ? 0.1 : 0)});
    }
  }
  return best_of(candidates, width, height);
}

PaperPoint LabelPlacer::beside_curve(const std::vector<PaperSegment>& pieces, const std::string& text) {
  const double width = text_width(text) + 2 * kClearance, height = kTextHeight + 2 * kClearance;
  std::vector<Candidate> candidates;
  for (const auto& [from, to] : pieces) {
    const double dx = to[0] - from[0], dy = to[1] - from[1], length = std::hypot(dx, dy);
    if (length == 0) continue;
    const PaperPoint normal = {-dy / length, dx / length};
    for (const double more : {0.0, 1.0}) {
      const double reach = kLineReach + more + extent(normal, width, height);
      for (const double side : {1.0, -1.0})
        candidates.push_back({{(from[0] + to[0]) / 2 + side * reach * normal[0],
                               (from[1] + to[1]) / 2 + side * reach * normal[1]},
                              more});
    }
  }
  return best_of(candidates, width, height);
}

}  // namespace gcslab
