#pragma once

// The edges of a polytope at a vertex: the explicit inverse of the matrix of the constraints that hold there.
//
// At a vertex of a polytope in R^n, n constraints with normals a_0 ... a_{n-1} hold with equality; constraint
// t sits in slot t. Edge t is the direction along which the others go on holding and a_t.x grows by one:
// column t of the inverse of the matrix with rows a_t. Row j of that inverse, the j-th coordinates of all
// edges, is contiguous, so that what most is asked for, the multipliers of the objective x_j, needs no
// arithmetic. The squared lengths of the edges are kept along, for steepest edge pricing (Forrest, Goldfarb
// 1992).
//
// Exchanging one constraint is a rank-one update, restricted to the coordinates that the edge moves and the
// blocks of edges that the new constraint meets. An edge does not move, and a constraint does not meet, by
// less than 1e-13: that is noise, which would make the update dense.

#include <cstddef>
#include <span>
#include <vector>

namespace gcslab {

class EdgeMatrix {
 public:
  /// The vertex of n constraints with normals e_0 ... e_{n-1}.
  void reset(std::size_t size);

  std::size_t size() const { return size_; }
  /// Coordinate `column` of all edges; padded with zeros to a multiple of four.
  const double* coordinate(std::size_t column) const { return entries_.data() + column * stride_; }
  double squared_length(std::size_t slot) const { return squared_lengths_[slot]; }
  const double* squared_lengths() const { return squared_lengths_.data(); }
  /// The number of doubles that an array over the slots needs.
  std::size_t stride() const { return stride_; }

  /// edge[j] = coordinate j of one edge, 0 for noise.
  void copy_edge(std::size_t slot, double* edge) const;
  /// result[t] = a . edge_t for the sparse normal a.
  void along_edges(std::span<const int> columns, std::span<const double> values, double* result) const;
  /// point = sum_t offset[t] * edge_t: the vertex whose constraints hold at the values `offset`.
  void vertex(const double* offset, double* point) const;

  /// Puts the constraint with normal a into a slot, given along[t] = a . edge_t and edge = edge_slot.
  void exchange(std::size_t slot, const double* along, const double* edge);

 private:
  void find_factors(const double* along, double inverse);
  std::size_t find_moving(const double* edge);
  template <std::size_t count>
  void update_coordinates(const std::size_t* coordinates, const double* edge);
  void update_squared_lengths(std::size_t slot, double inverse);

  std::size_t size_ = 0;
  std::size_t stride_ = 0;
  std::vector<double> entries_;
  std::vector<double> squared_lengths_;
  std::vector<double> factors_;      ///< along / along[slot]
  std::vector<double> inner_;        ///< edge_t . edge_slot
  std::vector<std::size_t> blocks_;  ///< where factors_ has non-zeros, four edges a block
  std::vector<std::size_t> moving_;  ///< the coordinates in which the leaving edge is not zero, first
};

}  // namespace gcslab
