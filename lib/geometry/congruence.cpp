#include "geometry/congruence.h"

#include <algorithm>

#include "interval/fast_interval.h"

namespace gcslab {
namespace {

/// Enclosures of the squared distances of all pairs of points.
std::vector<Interval> squared_distances(const FigureBox& figure) {
  const NumberTraits<FastInterval>::Scope scope;
  std::vector<Interval> result;
  for (std::size_t p = 0; p < figure.size(); ++p) {
    for (std::size_t q = p + 1; q < figure.size(); ++q) {
      FastInterval sum(Interval(0));
      for (std::size_t axis = 0; axis < figure[p].size(); ++axis)
        sum = sum + sqr(FastInterval(figure[p][axis]) - FastInterval(figure[q][axis]));
      result.push_back(sum.interval());
    }
  }
  return result;
}

bool may_be_equal(const std::vector<Interval>& a, const std::vector<Interval>& b) {
  return std::ranges::equal(a, b, [](const Interval& x, const Interval& y) { return !disjoint(x, y); });
}

}  // namespace

std::vector<std::vector<std::size_t>> congruence_classes(const std::vector<FigureBox>& figures) {
  std::vector<std::vector<Interval>> distances;
  for (const FigureBox& figure : figures) distances.push_back(squared_distances(figure));
  std::vector<std::vector<std::size_t>> classes;
  for (std::size_t f = 0; f < figures.size(); ++f) {
    const auto is_like = [&](const std::vector<std::size_t>& members) {
      return may_be_equal(distances[members.front()], distances[f]);
    };
    const auto found = std::ranges::find_if(classes, is_like);
    if (found == classes.end()) {
      classes.push_back({f});
    } else {
      found->push_back(f);
    }
  }
  return classes;
}

}  // namespace gcslab
