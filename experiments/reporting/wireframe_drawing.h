#pragma once

// A figure in one panel: nearer edges darker and thicker, with a gap in what passes behind them, faces,
// planes and spheres shaded, what is behind or within them paler, points, objects and parameters named.

#include <string>

#include "experiments/reporting/axonometry.h"
#include "experiments/reporting/figure_script.h"

namespace gcslab {

struct WireLook {
  View view;
  bool names = true;        ///< of the points and objects
  bool values = true;       ///< at the edges, angles and objects of figures in the plane
  bool dimensions = false;  ///< also at those in space
};

/// Whether it shows the values of that figure.
bool shows_values(const Wireframe& figure, const WireLook& look);

/// The rectangle that a figure takes on paper without its texts, in its units.
struct SeenBounds {
  double left = 0, right = 0, bottom = 0, top = 0;

  double width() const { return right - left; }
  double height() const { return top - bottom; }
};
SeenBounds seen_bounds(const Wireframe& figure, const WireLook& look);

/// Draws at `scale` millimetres a unit, the middle of the bounds in the middle of the panel. `name` says in
/// the data whose figure it is.
void draw_wireframe(FigureScript& script, const PanelBox& panel, const Wireframe& figure,
                    const WireLook& look, double scale, const std::string& name);

}  // namespace gcslab
