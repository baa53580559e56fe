#include "experiments/reporting/class_alignment.h"

#include <algorithm>
#include <cmath>

namespace gcslab {
namespace {

std::vector<double> distances(const Figure& figure) {
  std::vector<double> result;
  for (std::size_t p = 0; p < figure.size(); ++p) {
    for (std::size_t q = 0; q < p; ++q) {
      double sum = 0;
      for (std::size_t i = 0; i < figure[p].size(); ++i)
        sum += (figure[p][i] - figure[q][i]) * (figure[p][i] - figure[q][i]);
      result.push_back(std::sqrt(sum));
    }
  }
  return result;
}

/// A figure that lines are compared with.
struct Known {
  const std::vector<std::string>& names;
  std::vector<double> distances;
};

bool are_same(const Known& a, const Known& b) {
  constexpr double kSame = 1e-6;
  if (a.names != b.names || a.distances.size() != b.distances.size() || a.distances.empty()) return false;
  const double largest = std::ranges::max(a.distances);
  return std::ranges::equal(a.distances, b.distances,
                            [&](double x, double y) { return std::abs(x - y) <= kSame * largest; });
}

}  // namespace

std::vector<AlignedLine> aligned_classes(const std::vector<const FigurePicture*>& columns) {
  std::vector<AlignedLine> lines;
  std::vector<Known> firsts;  // one a line
  for (std::size_t column = 0; column < columns.size(); ++column) {
    if (columns[column] == nullptr) continue;
    const FigurePicture& picture = *columns[column];
    for (std::size_t k = 0; k < picture.figures.size(); ++k) {
      const Known figure{picture.wires.names, distances(picture.figures[k].points)};
      std::size_t line = 0;
      while (line < lines.size() && (lines[line][column] || !are_same(firsts[line], figure))) ++line;
      if (line == lines.size()) {
        lines.emplace_back(columns.size());
        firsts.push_back(figure);
      }
      lines[line][column] = k;
    }
  }
  return lines;
}

}  // namespace gcslab
