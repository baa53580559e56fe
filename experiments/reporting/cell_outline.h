#pragma once

// Many cells as few lines: the shapes that a drawing of a cover needs, in whole numbers on the grid of the
// finest cells.

#include <array>
#include <cstdint>
#include <vector>

namespace gcslab {

using GridPoint = std::array<std::int64_t, 2>;
using GridPolygon = std::vector<GridPoint>;  ///< closed: the last point is joined to the first

/// The square [x, x+1] x [y, y+1].
struct GridCell {
  std::int64_t x, y;
  friend bool operator==(const GridCell&, const GridCell&) = default;
};

/// [x0, x1] x [y0, y1].
struct GridRectangle {
  std::int64_t x0, y0, x1, y1;
};

/// A horizontal or vertical line.
struct GridSegment {
  GridPoint from, to;
};

/// One polygon for each set of cells that hang together by edges. Filled by the nonzero winding rule (or
/// even-odd) the polygons cover each cell once and nothing else, without seams. A hole is joined to the outer
/// border by a bridge of no width inside the cells, walked once each way. Edges are parallel to the axes;
/// cells may be listed repeatedly.
std::vector<GridPolygon> outline(const std::vector<GridCell>& cells);

/// The borders of all rectangles, each point of them drawn once, in as few segments as straight lines allow.
std::vector<GridSegment> borders(const std::vector<GridRectangle>& rectangles);

}  // namespace gcslab
