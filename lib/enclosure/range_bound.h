#pragma once

// Bounds of the range of a function over boxes: one interface, so that ways to bound can be compared on the
// same function and box.

#include <memory>

#include "interval/interval.h"

namespace gcslab {

/// Which half of a side a walk goes to. The halves share the midpoint of the side (covering/cover_tree.h).
enum class Half { lower, upper };

/// A walk from a domain to its halves, quarters, ... and back. A bound that can compute a half from its whole
/// more cheaply than anew (de Casteljau) keeps what it knows along the path.
class BoundWalk {
 public:
  virtual ~BoundWalk() = default;

  /// Goes to a half of the current box. Depth-first: each enter is undone by one leave.
  virtual void enter(std::size_t variable, Half half) = 0;
  virtual void leave() = 0;

  /// Encloses {f(p) : p in box, f defined at p}. `box` is the current box of the walk.
  virtual Interval bound(const Box& box) = 0;

  /// True only when f has no zero on the current box.
  virtual bool excludes_zero(const Box& box) { return !contains(bound(box), 0); }
};

/// A way to bound one function f.
class RangeBound {
 public:
  virtual ~RangeBound() = default;

  /// Encloses {f(p) : p in box, f defined at p}; empty when f is defined nowhere on the box.
  virtual Interval over(const Box& box) = 0;

  /// Starts a walk at `domain` that goes at most `depth` halvings deep in each variable. The bound must
  /// outlive it. By default every box of the walk is bounded anew.
  virtual std::unique_ptr<BoundWalk> walk(const Box& domain, int depth);
};

}  // namespace gcslab
