#pragma once

// Proves anew that a box contains a root, and that a larger box contains no other.
//
// Existence: Krawczyk's operator K(X) = c - C f(c) + (I - C S(X, c)) (X - c) maps X into its interior, so
// that C is regular and f has a root in K(X) (Krawczyk 1969; slopes S: Neumaier 1990, section 5.2). The point
// c, its inverse C and the box X around it are the verifier's own: Newton's iteration in 256 bits from the
// middle of the claimed box. Uniqueness: with the slopes S from that root's enclosure to the points of a box
// U, |I - C S| w < w for a vector w > 0 makes C S regular, so that f(p) = S (p - root) vanishes at no other p
// of U. Where U is too large for that it is cut into parts, of which each is proved by its own slopes or C,
// or because an equation vanishes nowhere in it.

#include <optional>
#include <string>
#include <vector>

#include "verifier/real_matrix.h"

namespace gcslab::verifier {

/// Where exactly one root lies, to many digits.
struct EnclosedRoot {
  RangeBox enclosure;
  RealMatrix inverse;  ///< approximate, of the Jacobian there
};

class RootProver {
 public:
  /// For square systems. `system` must outlive it.
  explicit RootProver(JudgedSystem& system) : system_(&system) {}

  /// Encloses a root of the claimed box; nothing when none is proved to lie in it.
  std::optional<EnclosedRoot> enclose(const Box& claimed);

  /// Whether the box is proved to contain no root besides the one in the enclosure.
  bool has_no_other(const Box& box, const EnclosedRoot& root);

 private:
  bool newton(std::vector<Real>& point, RealMatrix& inverse);
  bool evaluate(const RangeBox& centre, RangeBox& values);
  void compute_residual(const RealMatrix& inverse);
  bool image(const RangeBox& x, const RangeBox& centre, const RealMatrix& inverse, RangeBox& result);
  std::optional<RangeBox> contracted(const RangeBox& centre, const RealMatrix& inverse);
  bool tighten(RangeBox& box);
  bool is_contracting(const Box& box) const;
  bool vanishes_nowhere(const RangeBox& part);
  bool is_regular_from_root(const Box& part, const EnclosedRoot& root);
  bool is_proved_in_parts(const Box& box, const EnclosedRoot& root);

  JudgedSystem* system_;
  RangeMatrix slopes_;
  RangeMatrix residual_;  ///< I - C S
};

}  // namespace gcslab::verifier
