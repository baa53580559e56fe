#pragma once

// A search in one panel: every box that it took and what became of it, the curves of the equations and the
// roots.
//
// In two variables the fills tell how each part of the search box was settled: they do not overlap. In three
// the boxes are seen along one axis, as outlines only.

#include <array>
#include <string>

#include "experiments/reporting/figure_script.h"
#include "experiments/reporting/plane_drawing.h"
#include "experiments/solving/search_picture_json.h"

namespace gcslab {

struct BoxStyle {
  std::array<std::size_t, 2> variables = {0, 1};  ///< across and upwards
  bool fills = true;
  bool vertical_tics = true;  ///< numbers on the left side
};

/// The two sides of the search box that the panel shows.
Box shown_domain(const SearchPicture& picture, const BoxStyle& style);

/// Draws into `panel`. The curves are those of a search in two variables. `name` says in the data whose
/// search it is.
void draw_boxes(FigureScript& figure, const PanelBox& panel, const SearchPicture& picture,
                const ProblemCurves& curves, const BoxStyle& style, const std::string& name);

/// What the colours mean, for captions.
std::string box_colours_text(bool fills, bool curves);

/// "7 boxes, 9 reductions, 4 roots", or less of it where that is wider than `room` millimetres.
std::string box_counts_text(const SearchPicture& picture, double room);

}  // namespace gcslab
