#pragma once

// Where a segment meets an implicit surface first: the primitive of ray casting (Tahari 2011, section 4.4.2).
//
// Promise: when there is a hit, it is the first one: the surface has no point on the segment before it. When
// there is none, the whole segment has no point of it. Double intervals decide where they can, by the sign
// variations of Bernstein coefficients on smaller and smaller parts from the start on; what they cannot
// decide (a root at the start, a tangent) is decided by exact isolation (real_roots.h).

#include <optional>
#include <span>

#include "univariate/real_roots.h"
#include "univariate/segment_restriction.h"

namespace gcslab {

struct FirstRoot {
  bool exists = false;
  Interval t{};            ///< contains the parameter of the first root, when it exists
  bool was_exact = false;  ///< doubles could not tell
};

class FirstRootFinder {
 public:
  /// Of the zero set of a polynomial in any number of variables.
  explicit FirstRootFinder(const Polynomial& polynomial);

  /// On the segment between two points, ends included. t is about as narrow as 2^-20.
  FirstRoot find(std::span<const double> from, std::span<const double> to) const;
  /// The same by exact arithmetic alone.
  FirstRoot find_exactly(std::span<const double> from, std::span<const double> to) const;

 private:
  /// Nothing when doubles cannot tell.
  std::optional<FirstRoot> find_fast(std::span<const double> from, std::span<const double> to) const;

  SegmentRestriction<FastInterval> restriction_;
  SegmentRestriction<Rational> exact_restriction_;
};

}  // namespace gcslab
