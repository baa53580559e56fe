#pragma once

// Existence of a root, single or not, by signs on the faces of a box.
//
// Miranda 1940: continuous g_1 .. g_n on a box vanish together somewhere in it when each g_i is <= 0 on one
// of the two faces across variable i and >= 0 on the other. Here g = C f with a regular C, the inverse of the
// middle of the slopes over the box. On a face g_i is enclosed by what its values there give and by its mean
// value form about the middle of the face.

#include "verifier/real_matrix.h"

namespace gcslab::verifier {

class Miranda {
 public:
  /// `system` must outlive it.
  explicit Miranda(JudgedSystem& system) : system_(&system) {}

  /// Whether the box is proved to contain a root of the equations. No for unbounded boxes and for systems
  /// that are not square.
  bool contains_root(const Box& box);

 private:
  bool precondition(const RangeBox& box);
  Range combined(std::size_t row, const RangeBox& where);
  Range on_face(std::size_t variable, double end, const RangeBox& box, const RangeBox& centre);

  JudgedSystem* system_;
  RealMatrix multipliers_;  ///< C
  RangeMatrix slopes_;      ///< C S
};

}  // namespace gcslab::verifier
