#pragma once

// Polytopes of few dimensions, exactly: vertices, facets, edges and volume from half-spaces.
//
// For drawings and for checks of formulas, not for solving: every choice of as many half-spaces as there are
// dimensions is tried.

#include <cstddef>
#include <utility>
#include <vector>

#include "interval/rational.h"

namespace gcslab {

/// {x : normal . x >= least}.
struct HalfSpace {
  std::vector<Rational> normal;
  Rational least;

  bool contains(const std::vector<Rational>& point) const;
  bool has_on_border(const std::vector<Rational>& point) const;
};

class ExactPolytope {
 public:
  using Point = std::vector<Rational>;

  /// The vertices of a facet, by number.
  struct Facet {
    std::size_t half_space;
    std::vector<std::size_t> vertices;
  };

  /// The intersection of the half-spaces, which must be bounded; all normals have the same length, from 1 to
  /// 8. A half-space that has no facet, or that of an earlier one, is redundant.
  explicit ExactPolytope(std::vector<HalfSpace> half_spaces);

  std::size_t dimension() const { return dimension_; }
  const std::vector<HalfSpace>& half_spaces() const { return half_spaces_; }
  /// In lexicographic order; none when the intersection is empty.
  const std::vector<Point>& vertices() const { return vertices_; }
  /// None when the intersection has no interior.
  const std::vector<Facet>& facets() const { return facets_; }
  /// Pairs of vertices, of a polytope with interior in 2 or 3 dimensions.
  std::vector<std::pair<std::size_t, std::size_t>> edges() const;
  /// By a triangulation from one vertex of each face (Cohen, Hickey 1979, J. ACM 26:401).
  Rational volume() const;

 private:
  void find_vertices();
  void find_facets();
  std::size_t rank(const std::vector<std::size_t>& vertices) const;
  Rational volume_over(std::vector<std::size_t> face, std::vector<std::size_t>& apexes) const;

  std::size_t dimension_;
  std::vector<HalfSpace> half_spaces_;
  std::vector<Point> vertices_;
  std::vector<Facet> facets_;
};

}  // namespace gcslab
