#pragma once

// The cover of a plane curve in one panel: kept cells filled, visited cells outlined, the true curve over
// them.

#include <string>
#include <vector>

#include "covering/cover_tree.h"
#include "experiments/reporting/figure_script.h"
#include "experiments/reporting/report_context.h"

namespace gcslab {

struct CoverStyle {
  bool visited = true;        ///< outline the cells that were dropped
  bool curve = true;          ///< draw the true curve
  bool vertical_tics = true;  ///< numbers on the left side
};

/// Height over width of the panel in which both variables have the same scale; 1 for domains that are so long
/// that no panel would be legible.
double panel_aspect(const Box& domain);

/// Draws into `panel`. The tree has two variables. `name` says in the data whose cover it is.
void draw_cover(FigureScript& figure, const PanelBox& panel, const CoverTree& tree,
                const std::vector<Polyline>& curve, const CoverStyle& style, const std::string& name);

/// The polyline with fewer points, none of the left out ones farther than `tolerance` from it (Douglas,
/// Peucker 1973).
Polyline simplified(const Polyline& line, double tolerance);

}  // namespace gcslab
