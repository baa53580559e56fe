#pragma once

// Homotopy paths on paper: two unknowns and t as a curve in a box seen from one side, or one unknown against
// t.

#include <array>
#include <string>
#include <vector>

#include "experiments/reporting/axonometry.h"
#include "experiments/reporting/figure_script.h"

namespace gcslab {

/// Two unknowns and t.
using PathPoint = std::array<double, 3>;

struct PathCurve {
  std::string name;  ///< for the legend, which stands where there are several curves
  std::vector<PathPoint> points;
  bool is_bold = false;  ///< drawn below the others, which may run along it
};

struct PathPicture {
  std::array<std::string, 2> unknowns;
  std::vector<PathCurve> curves;
  std::vector<PathPoint> sketches{};   ///< squares, at t = 0
  std::vector<PathPoint> solutions{};  ///< discs, at t = 1
  std::vector<PathPoint> critical{};   ///< rings
};

struct PathStyle {
  double width = kColumnWidth;
  View view{-32, 18};
  bool is_flat = false;  ///< the first unknown across and t upwards; the second is not shown
};

/// The box is that of the curves, points and the planes t = 0 and t = 1, which are drawn lightly. Curves are
/// told apart by colours and dashes, with a gap where one passes behind itself or another.
FigureScript draw_paths(const PathPicture& picture, const PathStyle& style);

/// What the marks mean, for captions.
std::string path_marks_text(const PathPicture& picture);

}  // namespace gcslab
