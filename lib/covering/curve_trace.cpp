#include "covering/curve_trace.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/check.h"
#include "expression/tape_evaluator.h"

namespace gcslab {
namespace {

/// The values of f on the grid and the crossings of its edges. An edge is named by twice the number of its
/// left or lower vertex, plus 1 when it is vertical.
class Grid {
 public:
  Grid(Expression function, const Box& box, int resolution)
      : box_(box), resolution_(static_cast<std::size_t>(resolution)), side_(resolution_ + 1) {
    const Tape tape(function, 2);
    TapeEvaluator<double> evaluator(tape);
    values_.reserve(side_ * side_);
    for (std::size_t row = 0; row < side_; ++row) {
      for (std::size_t column = 0; column < side_; ++column) {
        evaluator.evaluate(std::array{coordinate(0, column), coordinate(1, row)});
        values_.push_back(evaluator.value());
      }
    }
  }

  std::size_t resolution() const { return resolution_; }
  std::size_t vertex(std::size_t row, std::size_t column) const { return row * side_ + column; }
  bool positive(std::size_t vertex) const { return values_[vertex] > 0; }
  bool finite(std::size_t vertex) const { return std::isfinite(values_[vertex]); }
  double value(std::size_t vertex) const { return values_[vertex]; }

  std::array<double, 2> crossing(std::size_t edge) const {
    const std::size_t from = edge / 2;
    const bool vertical = edge % 2 == 1;
    const std::size_t to = from + (vertical ? side_ : 1);
    const double t = values_[from] / (values_[from] - values_[to]);
    const double along = std::isfinite(t) ? std::clamp(t, 0.0, 1.0) : 0.5;
    const double x = coordinate(0, from % side_), y = coordinate(1, from / side_);
    if (vertical) return {x, y + along * (coordinate(1, to / side_) - y)};
    return {x + along * (coordinate(0, to % side_) - x), y};
  }

 private:
  double coordinate(std::size_t axis, std::size_t index) const {
    const double t = static_cast<double>(index) / static_cast<double>(resolution_);
    return box_[axis].lower + t * (box_[axis].upper - box_[axis].lower);
  }

  const Box& box_;
  std::size_t resolution_;
  std::size_t side_;
  std::vector<double> values_;
};

/// Which edges each crossed edge is joined to: at most two, one in each square beside it.
using Neighbours = std::unordered_map<std::size_t, std::vector<std::size_t>>;

void join(Neighbours& neighbours, std::size_t a, std::size_t b) {
  neighbours[a].push_back(b);
  neighbours[b].push_back(a);
}

void march_square(const Grid& grid, std::size_t row, std::size_t column, Neighbours& neighbours) {
  const std::array<std::size_t, 4> corners = {grid.vertex(row, column), grid.vertex(row, column + 1),
                                              grid.vertex(row + 1, column + 1), grid.vertex(row + 1, column)};
  if (!std::ranges::all_of(corners, [&](std::size_t v) { return grid.finite(v); })) return;
  // Edge k runs between corner k and corner k + 1.
  const std::array<std::size_t, 4> edges = {2 * corners[0], 2 * corners[1] + 1, 2 * corners[3],
                                            2 * corners[0] + 1};
  std::vector<std::size_t> crossed;
  for (std::size_t k = 0; k < 4; ++k) {
    if (grid.positive(corners[k]) != grid.positive(corners[(k + 1) % 4])) crossed.push_back(edges[k]);
  }
  if (crossed.size() == 2) join(neighbours, crossed[0], crossed[1]);
  if (crossed.size() != 4) return;
  double sum = 0;
  for (const std::size_t corner : corners) sum += grid.value(corner);
  const bool first_corner_cut_off = (sum > 0) != grid.positive(corners[0]);
  if (first_corner_cut_off) {
    join(neighbours, edges[3], edges[0]), join(neighbours, edges[1], edges[2]);
  } else {
    join(neighbours, edges[0], edges[1]), join(neighbours, edges[2], edges[3]);
  }
}

/// Takes a chain of edges out of the map, starting at `edge`.
Polyline take_chain(const Grid& grid, Neighbours& neighbours, std::size_t edge) {
  Polyline line{grid.crossing(edge)};
  while (true) {
    auto& next_edges = neighbours[edge];
    if (next_edges.empty()) return line;
    const std::size_t next = next_edges.back();
    next_edges.pop_back();
    auto& back = neighbours[next];
    back.erase(std::ranges::find(back, edge));
    line.push_back(grid.crossing(next));
    edge = next;
  }
}

}  // namespace

std::vector<Polyline> trace_curve(Expression function, const Box& box, int resolution) {
  GCSLAB_CHECK(box.size() == 2 && resolution > 0);
  const Grid grid(function, box, resolution);
  Neighbours neighbours;
  for (std::size_t row = 0; row < grid.resolution(); ++row) {
    for (std::size_t column = 0; column < grid.resolution(); ++column)
      march_square(grid, row, column, neighbours);
  }
  std::vector<std::size_t> edges;
  for (const auto& [edge, joined] : neighbours) edges.push_back(edge);
  std::ranges::sort(edges);  // the same polylines on every machine
  std::vector<Polyline> lines;
  for (const std::size_t ends :
       {std::size_t{1}, std::size_t{2}}) {  // open chains from their ends, then closed ones
    for (const std::size_t edge : edges) {
      if (neighbours[edge].size() == ends) lines.push_back(take_chain(grid, neighbours, edge));
    }
  }
  return lines;
}

}  // namespace gcslab
