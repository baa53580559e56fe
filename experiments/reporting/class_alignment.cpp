#include "experiments/reporting/class_alignment.h"

#include <algorithm>
#include <cmath>

#include "geometry/congruence.h"

namespace gcslab {
namespace {

constexpr double kSame = 1e-6;

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
  Wireframe figure;
  std::vector<double> distances;

  bool has_only_points() const { return figure.objects.empty(); }
};

Known known(const FigurePicture& picture, std::size_t number) {
  Wireframe figure = picture.wires.at(picture.figures[number].places);
  std::vector<double> lengths = distances(figure.points);
  return {std::move(figure), std::move(lengths)};
}

bool agree(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size() || a.empty()) return false;
  const double largest = std::ranges::max(a);
  return std::ranges::equal(a, b, [&](double x, double y) { return std::abs(x - y) <= kSame * largest; });
}

FigureBox around(const Figure& figure) {
  double largest = 0;
  for (const std::vector<double>& object : figure) {
    for (const double x : object) largest = std::max(largest, std::abs(x));
  }
  FigureBox boxes;
  for (const std::vector<double>& object : figure) {
    boxes.emplace_back();
    for (const double x : object) boxes.back().emplace_back(x - kSame / 2 * largest, x + kSame / 2 * largest);
  }
  return boxes;
}

bool may_be_congruent(const Wireframe& a, const Wireframe& b) {
  const std::vector<FigureBox> boxes = {around(a.figure()), around(b.figure())};
  return a.universe() == b.universe() && a.sorts() == b.sorts() &&
         congruence_classes(a.sorts(), a.universe(), boxes).size() == 1;
}

bool are_same(const Known& a, const Known& b) {
  if (a.figure.names != b.figure.names) return false;
  if (a.has_only_points() && b.has_only_points()) return agree(a.distances, b.distances);
  return may_be_congruent(a.figure, b.figure);
}

}  // namespace

std::vector<AlignedLine> aligned_classes(const std::vector<const FigurePicture*>& columns) {
  std::vector<AlignedLine> lines;
  std::vector<Known> firsts;  // one a line
  for (std::size_t column = 0; column < columns.size(); ++column) {
    if (columns[column] == nullptr) continue;
    const FigurePicture& picture = *columns[column];
    for (std::size_t k = 0; k < picture.figures.size(); ++k) {
      const Known figure = known(picture, k);
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
