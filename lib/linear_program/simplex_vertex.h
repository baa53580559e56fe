#pragma once

// A vertex of the polytope of a SimplexProgram: which constraints hold it, its edges, and where it lies.

#include <cstddef>
#include <span>
#include <vector>

#include "linear_program/edge_matrix.h"
#include "linear_program/simplex_program.h"

namespace gcslab {

class SimplexVertex {
 public:
  static constexpr int kFree = -1;

  /// The corner of the column box where every column is at its lower bound.
  void start_at_corner(const SimplexProgram& program);
  /// Computes the edges anew from the constraints that hold the vertex. One that depends on the others is
  /// replaced by a column bound, so that this succeeds whatever the program's numbers have become.
  void rebuild(const SimplexProgram& program);
  /// Moves to where the holding constraints are at the given sides, and computes every value there.
  void place(const SimplexProgram& program, const ConstraintSides& sides);

  std::size_t slots() const { return constraint_.size(); }
  const EdgeMatrix& edges() const { return edges_; }
  std::size_t constraint(std::size_t slot) const { return constraint_[slot]; }
  /// The slot of a constraint, or kFree.
  int slot_of(std::size_t constraint) const { return slot_of_[constraint]; }
  /// 1 when the slot's constraint is at its lower side, -1 at its upper one, 0 for an equation: where values
  /// may go.
  double inward(std::size_t slot) const { return inward_[slot]; }
  const double* inward() const { return inward_.data(); }
  /// v = (x, A x).
  const double* values() const { return value_.data(); }
  std::size_t exchanges_since_rebuild() const { return exchanges_; }

  /// result[t] = a . edge_t for the normal a of a constraint.
  void along_edges(const SimplexProgram& program, std::size_t constraint, double* result) const;
  /// rate[k] = how fast the value of constraint k grows along an edge; exactly 0 for those that hold.
  void follow_edge(const SimplexProgram& program, std::size_t slot, double* rate) const;
  /// Puts back values that `values` gave while the same constraints held the vertex.
  void set_values(std::span<const double> values) { value_.assign(values.begin(), values.end()); }
  /// values += step * rate.
  void advance(const double* rate, double step);
  /// The slot's constraint goes from one side to the other.
  void flip(std::size_t slot, const ConstraintSides& sides);
  /// Another constraint takes the slot, at the side that `inward` says.
  void exchange(const SimplexProgram& program, std::size_t slot, std::size_t constraint, double inward,
                const ConstraintSides& sides, const double* along, const double* edge);

 private:
  void hold(std::size_t slot, std::size_t constraint, double inward);
  void bring_in_rows(const SimplexProgram& program, std::span<const std::size_t> rows,
                     std::span<const double> inward);
  void settle_columns(const SimplexProgram& program);
  std::size_t best_slot_for(const double* along) const;

  EdgeMatrix edges_;
  std::vector<std::size_t> constraint_;
  std::vector<double> inward_;
  std::vector<int> slot_of_;
  std::vector<double> value_;
  std::vector<char> wanted_;  ///< of a rebuild: columns whose bounds held
  std::vector<double> along_;
  std::vector<double> edge_;
  std::vector<double> offset_;
  std::size_t exchanges_ = 0;
};

}  // namespace gcslab
