#pragma once

// The cover of a plane curve in one panel: kept cells filled, visited cells outlined, the true curve over
// them.

#include <string>
#include <vector>

#include "covering/cover_tree.h"
#include "experiments/reporting/figure_script.h"
#include "experiments/reporting/plane_drawing.h"

namespace gcslab {

struct CoverStyle {
  bool visited = true;        ///< outline the cells that were dropped
  bool curve = true;          ///< draw the true curve
  bool vertical_tics = true;  ///< numbers on the left side
};

/// Draws into `panel`. The tree has two variables. `name` says in the data whose cover it is.
void draw_cover(FigureScript& figure, const PanelBox& panel, const CoverTree& tree,
                const std::vector<Polyline>& curve, const CoverStyle& style, const std::string& name);

}  // namespace gcslab
