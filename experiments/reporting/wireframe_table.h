#pragma once

// Wireframes in lines and columns. Those of one group of lines are seen from one side and at one scale, so
// that they can be compared.

#include <optional>
#include <string>
#include <vector>

#include "experiments/reporting/wireframe_drawing.h"

namespace gcslab {

struct WireCell {
  std::optional<Wireframe> figure;
  std::string words{};    ///< in place of a figure
  std::string caption{};  ///< below it
};

struct WireGroup {
  std::string label{};  ///< beside each of its lines
  std::vector<std::vector<WireCell>> lines{};
};

struct WireTable {
  std::string title{};                  ///< above all; empty: none
  std::vector<std::string> headings{};  ///< one a column; empty: none
  std::vector<WireGroup> groups{};
};

struct WireTableStyle {
  double width = kPageWidth;
  std::optional<View> view{};  ///< nothing: the best for the figures of each group
  bool names = true;
  bool values = true;
  bool dimensions = false;  ///< values in space too
};

FigureScript draw_wire_table(const WireTable& table, const WireTableStyle& style);

/// The cells in lines of equal length, of up to `most`.
WireGroup in_lines(std::vector<WireCell> cells, std::size_t most);

/// A deformation: figures in the order of their captions, such as values of t, in lines of up to `per_line`,
/// without names at the points.
struct CaptionedFigure {
  Wireframe figure;
  std::string caption;
};
FigureScript draw_strip(const std::vector<CaptionedFigure>& figures, std::size_t per_line,
                        const WireTableStyle& style);

/// The note that explains how 3D figures are drawn, for captions; for the plane an empty one.
std::string depth_note(const WireTable& table);

}  // namespace gcslab
