#pragma once

// A legend that wraps below a figure, and the look of the lines that it explains.

#include <string>
#include <vector>

#include "experiments/reporting/figure_script.h"

namespace gcslab {

/// How line number `index` looks: colour, point type and dash differ, so that it is known in grey print too.
struct LineLook {
  std::string colour;
  int point_type;
  int dash_type;

  std::string line_style(double width = 1) const;
};
LineLook line_look(std::size_t index);

/// The height that a legend takes in a figure of this width; 0 for one line, which needs none.
double legend_height(const std::vector<std::string>& names, double width);

/// Draws samples and names from `top` downwards, from `left` or farther to the left where it needs the room;
/// they appear with the next plot.
void draw_legend(FigureScript& figure, const std::vector<std::string>& names, double left, double top);

}  // namespace gcslab
