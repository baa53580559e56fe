#pragma once

// Points of space on paper, as seen from far away: orthographic views, and what passes in front of what.

#include <span>
#include <vector>

#include "experiments/solving/wireframe.h"

namespace gcslab {

/// A point on paper, and how far it lies behind the middle of the figure, all in units of the figure.
struct SeenPoint {
  double x = 0, y = 0, away = 0;
};

/// From where a figure is seen; at 0, 0 the x axis runs to the right, z upwards and y away from the reader.
struct View {
  double turned = -35;  ///< degrees about the upright axis
  double raised = 22;   ///< degrees above the ground

  /// Points of the plane are seen as drawn.
  SeenPoint seen(std::span<const double> point) const;
};

/// On paper.
double distance_to_segment(const SeenPoint& p, const SeenPoint& a, const SeenPoint& b);

std::vector<SeenPoint> seen_points(const View& view, const Figure& figure);

/// Of a grid of views the one in which points stand farthest from each other and from the edges that they do
/// not belong to, as parts of the figure's size, and lines, circles and planes are seen most openly, in the
/// worst of the figures; the first of equally good ones.
View best_view(const std::vector<Wireframe>& figures);

/// A part of a polyline that is seen.
struct VisiblePart {
  std::vector<SeenPoint> points;
  std::size_t line;  ///< its number
};

/// The polylines, with a gap where one passes behind itself or another: half of it is `gap` long where they
/// cross at right angles, and longer, up to twice that, where they cross obliquely. Lines that meet have
/// none.
std::vector<VisiblePart> visible_parts(const std::vector<std::vector<SeenPoint>>& lines, double gap);

}  // namespace gcslab
