#include "experiments/reporting/axonometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "experiments/reporting/seen_objects.h"

namespace gcslab {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

SeenPoint between(const SeenPoint& a, const SeenPoint& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.away + t * (b.away - a.away)};
}

double distance(const SeenPoint& a, const SeenPoint& b) { return std::hypot(a.x - b.x, a.y - b.y); }

bool has_end(const WireEdge& edge, std::size_t point) { return edge.from == point || edge.to == point; }

/// The largest distance between points of the figure in space.
double size_of(const Figure& figure) {
  double size = 0;
  for (const auto& a : figure) {
    for (const auto& b : figure) {
      double sum = 0;
      for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
      size = std::max(size, std::sqrt(sum));
    }
  }
  return size;
}

/// How far apart the parts of the figure are seen, as a part of its size.
double clearness(const View& view, const Wireframe& figure) {
  const std::vector<SeenPoint> points = seen_points(view, figure.points);
  constexpr double kOpen = 0.2;  // what a line end-on, a circle edge-on count
  if (figure.points.size() < 2) return kOpen * openness(figure, view);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (std::size_t q = 0; q < p; ++q) least = std::min(least, distance(points[p], points[q]));
    for (const WireEdge& edge : figure.edges) {
      if (!has_end(edge, p))
        least = std::min(least, distance_to_segment(points[p], points[edge.from], points[edge.to]));
    }
  }
  const double size = size_of(figure.points);
  const double clear = size == 0 ? 0 : least / size;
  return figure.objects.empty() ? clear : std::min(kOpen * openness(figure, view), clear);
}

/// Where two edges cross on paper: the part of the way along the first, and along the second.
struct Crossing {
  double first, second;
  double sine;  ///< of the angle between them
};

std::optional<Crossing> crossing_of(const SeenPoint& a, const SeenPoint& b, const SeenPoint& c,
                                    const SeenPoint& d) {
  const double ux = b.x - a.x, uy = b.y - a.y, vx = d.x - c.x, vy = d.y - c.y;
  const double determinant = ux * vy - uy * vx, lengths = std::hypot(ux, uy) * std::hypot(vx, vy);
  if (std::abs(determinant) <= 1e-9 * lengths) return std::nullopt;
  const double s = ((c.x - a.x) * vy - (c.y - a.y) * vx) / determinant;
  const double t = ((c.x - a.x) * uy - (c.y - a.y) * ux) / determinant;
  if (!(s > 0 && s < 1 && t > 0 && t < 1)) return std::nullopt;
  return Crossing{s, t, std::abs(determinant) / lengths};
}

using SeenLine = std::vector<SeenPoint>;

/// What is hidden of a line, from and to in length along it.
struct Gap {
  double from, to;
};

/// Lengths along the line at its points.
std::vector<double> lengths_along(const SeenLine& line) {
  std::vector<double> result = {0};
  for (std::size_t i = 1; i < line.size(); ++i)
    result.push_back(result.back() + distance(line[i - 1], line[i]));
  return result;
}

std::vector<Gap> gaps_of(std::size_t number, const std::vector<SeenLine>& lines, double gap) {
  constexpr double kLongest = 2;
  const SeenLine& line = lines[number];
  const std::vector<double> along = lengths_along(line);
  std::vector<Gap> gaps;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const SeenPoint &a = line[i - 1], &b = line[i];
    for (const SeenLine& other : lines) {
      for (std::size_t k = 1; k < other.size(); ++k) {
        const SeenPoint &c = other[k - 1], &d = other[k];
        const auto crossing = crossing_of(a, b, c, d);
        if (!crossing) continue;
        const double behind = between(a, b, crossing->first).away - between(c, d, crossing->second).away;
        if (!(behind > 1e-9 * (distance(a, b) + distance(c, d)))) continue;
        const double at = along[i - 1] + crossing->first * distance(a, b);
        const double half = gap * std::min(kLongest, 1 / crossing->sine);
        gaps.push_back({at - half, at + half});
      }
    }
  }
  std::ranges::sort(gaps, {}, &Gap::from);
  return gaps;
}

/// The line from one length along it to another.
SeenLine part_of(const SeenLine& line, double from, double to) {
  const std::vector<double> along = lengths_along(line);
  SeenLine part;
  const auto at = [&](std::size_t i, double length) {
    return between(line[i - 1], line[i], (length - along[i - 1]) / (along[i] - along[i - 1]));
  };
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (along[i] <= from || along[i - 1] >= to || along[i] == along[i - 1]) continue;
    if (part.empty()) part.push_back(from > along[i - 1] ? at(i, from) : line[i - 1]);
    part.push_back(to < along[i] ? at(i, to) : line[i]);
  }
  return part;
}

}  // namespace

double distance_to_segment(const SeenPoint& p, const SeenPoint& a, const SeenPoint& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  if (squared == 0) return distance(p, a);
  return distance(p, between(a, b, std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0, 1.0)));
}

SeenPoint View::seen(std::span<const double> point) const {
  if (point.size() == 2) return {point[0], point[1], 0};
  const double cos_turned = std::cos(turned * kRadians), sin_turned = std::sin(turned * kRadians);
  const double cos_raised = std::cos(raised * kRadians), sin_raised = std::sin(raised * kRadians);
  const double across = cos_turned * point[0] + sin_turned * point[1];
  const double away = -sin_turned * point[0] + cos_turned * point[1];
  return {across, cos_raised * point[2] + sin_raised * away, cos_raised * away - sin_raised * point[2]};
}

std::vector<SeenPoint> seen_points(const View& view, const Figure& figure) {
  std::vector<SeenPoint> result;
  for (const std::vector<double>& point : figure) result.push_back(view.seen(point));
  return result;
}

View best_view(const std::vector<Wireframe>& figures) {
  View best;
  double clearest = -1;
  for (int turned = -90; turned < 270; turned += 5) {
    for (int raised = 10; raised <= 55; raised += 5) {
      const View view{static_cast<double>(turned), static_cast<double>(raised)};
      double least = std::numeric_limits<double>::infinity();
      for (const Wireframe& figure : figures) least = std::min(least, clearness(view, figure));
      if (least > clearest) {
        clearest = least;
        best = view;
      }
    }
  }
  return best;
}

std::vector<VisiblePart> visible_parts(const std::vector<std::vector<SeenPoint>>& lines, double gap) {
  std::vector<VisiblePart> parts;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    double begin = 0;
    const auto add = [&](double end) {
      if (end > begin) parts.push_back({part_of(lines[k], begin, end), k});
    };
    for (const Gap& hidden : gaps_of(k, lines, gap)) {
      add(hidden.from);
      begin = std::max(begin, hidden.to);
    }
    add(lengths_along(lines[k]).back());
  }
  return parts;
}

}  // namespace gcslab
