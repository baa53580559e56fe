#include "linear_program/exact_polytope.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "base/check.h"
#include "linear_program/exact_factorisation.h"

namespace gcslab {
namespace {

using Point = ExactPolytope::Point;

Rational product(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  Rational sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

ExactFactorisation::SparseRow sparse(const std::vector<Rational>& row) {
  ExactFactorisation::SparseRow result;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i] != 0) result[i] = row[i];
  }
  return result;
}

Point difference(const Point& a, const Point& b) {
  Point result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - b[i]);
  return result;
}

/// |det| of a square matrix, by Gaussian elimination.
Rational absolute_determinant(std::vector<Point> rows) {
  Rational result = 1;
  for (std::size_t column = 0; column < rows.size(); ++column) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(column), rows.end(),
                                    [column](const Point& row) { return row[column] != 0; });
    if (pivot == rows.end()) return 0;
    std::swap(*pivot, rows[column]);
    result *= rows[column][column];
    for (std::size_t i = column + 1; i < rows.size(); ++i) {
      const Rational factor = rows[i][column] / rows[column][column];
      for (std::size_t j = column; j < rows.size(); ++j) rows[i][j] -= factor * rows[column][j];
    }
  }
  return abs(result);
}

/// Moves to the next subset of {0 .. count-1} of its size, in lexicographic order.
bool next_subset(std::vector<std::size_t>& subset, std::size_t count) {
  for (std::size_t i = subset.size(); i-- > 0;) {
    if (subset[i] + subset.size() == count + i) continue;
    ++subset[i];
    for (std::size_t j = i + 1; j < subset.size(); ++j) subset[j] = subset[j - 1] + 1;
    return true;
  }
  return false;
}

}  // namespace

bool HalfSpace::contains(const Point& point) const { return product(normal, point) >= least; }
bool HalfSpace::has_on_border(const Point& point) const { return product(normal, point) == least; }

ExactPolytope::ExactPolytope(std::vector<HalfSpace> half_spaces)
    : dimension_(half_spaces.empty() ? 0 : half_spaces.front().normal.size()),
      half_spaces_(std::move(half_spaces)) {
  GCSLAB_CHECK(dimension_ >= 1 && dimension_ <= 8 && half_spaces_.size() > dimension_);
  for (const HalfSpace& half_space : half_spaces_) GCSLAB_CHECK(half_space.normal.size() == dimension_);
  find_vertices();
  find_facets();
}

void ExactPolytope::find_vertices() {
  std::set<Point> found;
  std::vector<std::size_t> chosen(dimension_);
  for (std::size_t i = 0; i < dimension_; ++i) chosen[i] = i;
  do {
    std::vector<ExactFactorisation::SparseRow> rows;
    Point right_side;
    for (const std::size_t number : chosen) {
      rows.push_back(sparse(half_spaces_[number].normal));
      right_side.push_back(half_spaces_[number].least);
    }
    const ExactFactorisation factorisation(rows, dimension_);
    if (!factorisation.is_regular()) continue;
    const Point point = factorisation.solve(right_side);
    const auto holds = [&](const HalfSpace& half_space) { return half_space.contains(point); };
    if (std::ranges::all_of(half_spaces_, holds)) found.insert(point);
  } while (next_subset(chosen, half_spaces_.size()));
  vertices_.assign(found.begin(), found.end());
}

/// The dimension of the affine hull of some vertices.
std::size_t ExactPolytope::rank(const std::vector<std::size_t>& vertices) const {
  std::vector<ExactFactorisation::SparseRow> rows;
  for (const std::size_t v : vertices)
    rows.push_back(sparse(difference(vertices_[v], vertices_[vertices[0]])));
  const std::size_t count = rows.size();
  return count - ExactFactorisation(std::move(rows), dimension_).dependent_rows().size();
}

void ExactPolytope::find_facets() {
  for (std::size_t number = 0; number < half_spaces_.size(); ++number) {
    Facet facet{number, {}};
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      if (half_spaces_[number].has_on_border(vertices_[v])) facet.vertices.push_back(v);
    }
    if (facet.vertices.size() < dimension_ || facet.vertices.size() == vertices_.size()) continue;
    if (rank(facet.vertices) + 1 != dimension_) continue;
    const auto same = [&](const Facet& other) { return other.vertices == facet.vertices; };
    if (std::ranges::none_of(facets_, same)) facets_.push_back(std::move(facet));
  }
}

std::vector<std::pair<std::size_t, std::size_t>> ExactPolytope::edges() const {
  GCSLAB_CHECK(dimension_ == 2 || dimension_ == 3);
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (std::size_t a = 0; a < vertices_.size(); ++a) {
    for (std::size_t b = a + 1; b < vertices_.size(); ++b) {
      const auto has_both = [&](const Facet& facet) {
        return std::ranges::count(facet.vertices, a) + std::ranges::count(facet.vertices, b) == 2;
      };
      if (static_cast<std::size_t>(std::ranges::count_if(facets_, has_both)) + 1 >= dimension_)
        edges.emplace_back(a, b);
    }
  }
  return edges;
}

/// The volume, times the factorial of the dimension, of the simplices that join the apexes to a
/// triangulation of the face.
Rational ExactPolytope::volume_over(std::vector<std::size_t> face, std::vector<std::size_t>& apexes) const {
  apexes.push_back(face.front());
  Rational sum = 0;
  if (face.size() == 1) {
    std::vector<Point> rows;
    for (std::size_t i = 1; i < apexes.size(); ++i)
      rows.push_back(difference(vertices_[apexes[i]], vertices_[apexes[0]]));
    if (rows.size() == dimension_) sum = absolute_determinant(std::move(rows));
  } else {
    const std::size_t face_dimension = rank(face);
    std::set<std::vector<std::size_t>> parts;  // faces of the face that do not touch its apex
    for (const Facet& facet : facets_) {
      std::vector<std::size_t> part;
      std::ranges::set_intersection(face, facet.vertices, std::back_inserter(part));
      if (part.empty() || part.front() == face.front() || rank(part) + 1 != face_dimension) continue;
      if (parts.insert(part).second) sum += volume_over(std::move(part), apexes);
    }
  }
  apexes.pop_back();
  return sum;
}

Rational ExactPolytope::volume() const {
  if (facets_.empty()) return 0;
  std::vector<std::size_t> all(vertices_.size()), apexes;
  for (std::size_t v = 0; v < all.size(); ++v) all[v] = v;
  Rational result = volume_over(all, apexes);
  for (std::size_t k = 2; k <= dimension_; ++k) result /= static_cast<unsigned long>(k);
  return result;
}

}  // namespace gcslab
