#include "experiments/reporting/cell_outline.h"

#include <gtest/gtest.h>
#include <map>
#include <set>

#include "base/random.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

using CellCount = std::map<std::pair<std::int64_t, std::int64_t>, int>;

/// Winding number of every cell that is not 0: each upright edge changes the number of all cells to its
/// right.
CellCount winding_numbers(const std::vector<GridPolygon>& polygons, std::int64_t size) {
  CellCount numbers;
  for (const GridPolygon& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const GridPoint& from = polygon[i];
      const GridPoint& to = polygon[(i + 1) % polygon.size()];
      EXPECT_TRUE(from[0] == to[0] || from[1] == to[1]) << "an edge is oblique";
      if (from[0] != to[0]) continue;
      const int turn = to[1] < from[1] ? 1 : -1;  // down on the left side of a filled region
      for (std::int64_t y = std::min(from[1], to[1]); y < std::max(from[1], to[1]); ++y) {
        for (std::int64_t x = from[0]; x < size; ++x) numbers[{x, y}] += turn;
      }
    }
  }
  std::erase_if(numbers, [](const auto& entry) { return entry.second == 0; });
  return numbers;
}

std::vector<GridCell> random_cells(Random& random, std::int64_t size, std::uint64_t percent) {
  std::vector<GridCell> cells;
  for (std::int64_t y = 0; y < size; ++y) {
    for (std::int64_t x = 0; x < size; ++x) {
      if (random.below(100) < percent) cells.push_back({x, y});
    }
  }
  return cells;
}

void expect_covered_once(const std::vector<GridCell>& cells, std::int64_t size) {
  CellCount expected;
  for (const GridCell& cell : cells) expected[{cell.x, cell.y}] = 1;
  EXPECT_EQ(winding_numbers(outline(cells), size), expected);
}

TEST(Outline, CoversEveryCellOnceAndNothingElse) {
  Random random(fuzz_seed(), "cell_outline_test");
  const std::size_t cases = std::min<std::size_t>(fuzz_cases(400), 20000);
  for (std::size_t i = 0; i < cases; ++i) {
    const auto size = random.integer(1, 14);
    expect_covered_once(random_cells(random, size, 5 + random.below(95)), size);
    if (HasFailure()) FAIL() << "case " << i;
  }
}

TEST(Outline, RingWithinRing) {
  std::vector<GridCell> cells;
  for (std::int64_t y = 0; y < 9; ++y) {
    for (std::int64_t x = 0; x < 9; ++x) {
      const std::int64_t ring = std::min({x, y, 8 - x, 8 - y});
      if (ring % 2 == 0) cells.push_back({x, y});
    }
  }
  expect_covered_once(cells, 9);
  EXPECT_EQ(outline(cells).size(), 3U);
}

TEST(Outline, StraightEdgesHaveNoInnerPoints) {
  EXPECT_EQ(outline({{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}}).front().size(), 4U);
  EXPECT_TRUE(outline({}).empty());
}

TEST(Outline, RepeatedCellsCountOnce) { expect_covered_once({{1, 1}, {1, 1}}, 3); }

using UnitEdge = std::array<std::int64_t, 4>;

void add_unit_edges(const GridSegment& s, std::multiset<UnitEdge>& edges) {
  for (std::int64_t x = s.from[0]; x < s.to[0]; ++x) edges.insert({x, s.from[1], x + 1, s.from[1]});
  for (std::int64_t y = s.from[1]; y < s.to[1]; ++y) edges.insert({s.from[0], y, s.from[0], y + 1});
}

TEST(Borders, DrawEveryEdgeExactlyOnce) {
  Random random(fuzz_seed(), "borders_test");
  for (std::size_t i = 0; i < std::min<std::size_t>(fuzz_cases(300), 20000); ++i) {
    std::vector<GridRectangle> rectangles;
    std::multiset<UnitEdge> expected;
    for (std::uint64_t n = random.below(12); n > 0; --n) {
      const GridRectangle r = {random.integer(0, 7), random.integer(0, 7), random.integer(8, 12),
                               random.integer(8, 12)};
      rectangles.push_back(r);
      for (const GridSegment& side :
           {GridSegment{{r.x0, r.y0}, {r.x1, r.y0}}, GridSegment{{r.x0, r.y1}, {r.x1, r.y1}},
            GridSegment{{r.x0, r.y0}, {r.x0, r.y1}}, GridSegment{{r.x1, r.y0}, {r.x1, r.y1}}}) {
        add_unit_edges(side, expected);
      }
    }
    std::multiset<UnitEdge> drawn;
    for (const GridSegment& segment : borders(rectangles)) add_unit_edges(segment, drawn);
    const std::set<UnitEdge> distinct(expected.begin(), expected.end());
    ASSERT_EQ(drawn, std::multiset<UnitEdge>(distinct.begin(), distinct.end())) << "case " << i;
  }
}

}  // namespace
}  // namespace gcslab
