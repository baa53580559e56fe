#include "experiments/reporting/cell_outline.h"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "base/check.h"

namespace gcslab {
namespace {

// Sides of a cell in the order of a counter-clockwise walk: bottom, right, top, left.
constexpr std::array<GridPoint, 4> kForward = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
constexpr std::array<GridPoint, 4> kOutward = {{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
constexpr std::array<GridPoint, 4> kStart = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
constexpr std::size_t kRight = 1;
constexpr std::size_t kLeft = 3;

struct CellHash {
  std::size_t operator()(const GridCell& cell) const {
    return static_cast<std::size_t>(static_cast<std::uint64_t>(cell.x) * 0x9E3779B97F4A7C15U ^
                                    static_cast<std::uint64_t>(cell.y) * 0xC2B2AE3D27D4EB4FU);
  }
};

GridCell moved(const GridCell& cell, const GridPoint& step) { return {cell.x + step[0], cell.y + step[1]}; }

/// The borders of the cells as closed walks with the cells on their left, then joined to one walk a
/// component. A corner where only two diagonal cells meet belongs to two walks (or to one twice): each turns
/// left there.
class OutlineTracer {
 public:
  explicit OutlineTracer(const std::vector<GridCell>& cells) {
    for (const GridCell& cell : cells) {
      if (index_.emplace(cell, cells_.size()).second) cells_.push_back(cell);
    }
    is_traced_.assign(4 * cells_.size(), false);
  }

  std::vector<GridPolygon> run() {
    trace_all();
    std::vector<std::size_t> outer;
    for (std::size_t loop = 0; loop < leftmost_.size(); ++loop) {
      if (is_hole(loop)) {
        bridge(leftmost_[loop]);
      } else {
        outer.push_back(leftmost_[loop]);
      }
    }
    std::vector<GridPolygon> polygons;
    polygons.reserve(outer.size());
    for (const std::size_t first : outer) polygons.push_back(polygon_from(first));
    return polygons;
  }

 private:
  /// A corner of the walk. Node number 4 * cell + side is the start of that side; bridges add more.
  struct Node {
    GridPoint point;
    std::size_t next;
  };

  bool has(const GridCell& cell) const { return index_.contains(cell); }
  std::size_t edge(const GridCell& cell, std::size_t side) const { return 4 * index_.at(cell) + side; }

  /// The side on which the walk goes on after `side` of `cell`.
  std::size_t next_edge(const GridCell& cell, std::size_t side) const {
    const GridCell ahead = moved(cell, kForward[side]);
    if (!has(ahead)) return edge(cell, (side + 1) % 4);
    const GridCell diagonal = moved(ahead, kOutward[side]);
    return has(diagonal) ? edge(diagonal, (side + 3) % 4) : edge(ahead, side);
  }

  void trace_all() {
    nodes_.resize(4 * cells_.size());
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
      for (std::size_t side = 0; side < 4; ++side) {
        const bool is_border = !has(moved(cells_[cell], kOutward[side]));
        if (is_border && !is_traced_[4 * cell + side]) trace(4 * cell + side);
      }
    }
  }

  void trace(std::size_t first) {
    std::size_t leftmost = first;
    std::size_t at = first;
    do {
      const GridCell& cell = cells_[at / 4];
      const std::size_t side = at % 4;
      is_traced_[at] = true;
      nodes_[at] = {{cell.x + kStart[side][0], cell.y + kStart[side][1]}, next_edge(cell, side)};
      if (is_vertical(at) && (!is_vertical(leftmost) || nodes_[at].point[0] < nodes_[leftmost].point[0]))
        leftmost = at;
      at = nodes_[at].next;
    } while (at != first);
    leftmost_.push_back(leftmost);
  }

  static bool is_vertical(std::size_t edge) { return edge % 2 == 1; }

  /// The leftmost border of a component is the left side of a cell; that of a hole in it the right side of
  /// one.
  bool is_hole(std::size_t loop) const { return leftmost_[loop] % 4 == kRight; }

  /// Joins the walk around a hole to the walk that is met by going left from it. That walk reaches farther
  /// left, so the joined walks form a tree whose root is the outer one.
  void bridge(std::size_t hole) {
    GridCell cell = cells_[hole / 4];
    while (has({cell.x - 1, cell.y})) --cell.x;
    const std::size_t shore = next_edge(cell, kLeft);  // starts at the corner below that left side
    std::size_t before_hole = hole;
    while (nodes_[before_hole].next != hole) before_hole = nodes_[before_hole].next;
    const std::size_t hole_again = add_node(nodes_[hole].point, hole);
    const std::size_t shore_again = add_node(nodes_[shore].point, nodes_[shore].next);
    nodes_[before_hole].next = hole_again;
    nodes_[hole_again].next = shore_again;
    nodes_[shore].next = hole;
  }

  std::size_t add_node(const GridPoint& point, std::size_t next) {
    nodes_.push_back({point, next});
    return nodes_.size() - 1;
  }

  GridPolygon polygon_from(std::size_t first) const {
    GridPolygon corners;
    std::size_t at = first;
    do {
      corners.push_back(nodes_[at].point);
      at = nodes_[at].next;
    } while (at != first);
    return without_straight_points(corners);
  }

  /// Leaves out the points between two steps in the same direction; a turn back is a corner.
  static GridPolygon without_straight_points(const GridPolygon& corners) {
    const std::size_t count = corners.size();
    GridPolygon result;
    for (std::size_t i = 0; i < count; ++i) {
      if (direction(corners[(i + count - 1) % count], corners[i]) !=
          direction(corners[i], corners[(i + 1) % count])) {
        result.push_back(corners[i]);
      }
    }
    return result;
  }

  static GridPoint direction(const GridPoint& from, const GridPoint& to) {
    const auto sign = [](std::int64_t n) {
      return static_cast<std::int64_t>(n > 0) - static_cast<std::int64_t>(n < 0);
    };
    return {sign(to[0] - from[0]), sign(to[1] - from[1])};
  }

  std::vector<GridCell> cells_;
  std::unordered_map<GridCell, std::size_t, CellHash> index_;
  std::vector<Node> nodes_;
  std::vector<bool> is_traced_;
  std::vector<std::size_t> leftmost_;  ///< of each walk: the start of its leftmost side
};

using Span = std::array<std::int64_t, 2>;

/// The union of spans, as spans that do not touch.
std::vector<Span> united(std::vector<Span> spans) {
  std::ranges::sort(spans);
  std::vector<Span> result;
  for (const Span& span : spans) {
    if (!result.empty() && span[0] <= result.back()[1]) {
      result.back()[1] = std::max(result.back()[1], span[1]);
    } else {
      result.push_back(span);
    }
  }
  return result;
}

}  // namespace

std::vector<GridPolygon> outline(const std::vector<GridCell>& cells) { return OutlineTracer(cells).run(); }

std::vector<GridSegment> borders(const std::vector<GridRectangle>& rectangles) {
  std::map<std::int64_t, std::vector<Span>> rows;
  std::map<std::int64_t, std::vector<Span>> columns;
  for (const GridRectangle& r : rectangles) {
    GCSLAB_CHECK(r.x0 < r.x1 && r.y0 < r.y1);
    for (const std::int64_t y : {r.y0, r.y1}) rows[y].push_back({r.x0, r.x1});
    for (const std::int64_t x : {r.x0, r.x1}) columns[x].push_back({r.y0, r.y1});
  }
  std::vector<GridSegment> segments;
  for (const auto& [y, spans] : rows) {
    for (const Span& span : united(spans)) segments.push_back({{span[0], y}, {span[1], y}});
  }
  for (const auto& [x, spans] : columns) {
    for (const Span& span : united(spans)) segments.push_back({{x, span[0]}, {x, span[1]}});
  }
  return segments;
}

}  // namespace gcslab
