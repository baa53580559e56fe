#pragma once

// Contractors shrink a box without losing a root: the exchangeable parts of branch and prune.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "box_solver/experience.h"
#include "box_solver/proof_step.h"
#include "certification/system_functions.h"
#include "interval/interval.h"

namespace gcslab {

/// A contractor belongs to one thread. Its result depends on the box and, for compositions, on what they are
/// told of the search, but on nothing else.
class Contractor {
 public:
  virtual ~Contractor() = default;

  /// The rough number of arithmetic operations of a call, for weighing one contractor against another; 0:
  /// next to nothing.
  virtual double cost() const { return 0; }
  /// The same of the last call, where it depends on the box.
  virtual double last_cost() const { return cost(); }
  /// Before `contract`: what the search has met, and the number of the box. `so_far` must live through it.
  virtual void learn(const Experience& /*so_far*/, std::uint64_t /*box_number*/) {}
  /// After it: what this box adds.
  virtual Experience experience() const { return {}; }

  /// Shrinks `box`, which is bounded or not, but not empty. Promise: every solution of the system in the box
  /// before is in the box after. False means that there is none; the box is then without meaning. Each
  /// narrowing is told to `trace`.
  [[nodiscard]] virtual bool contract(Box& box, ProofTrace& trace) = 0;
};

/// How much smaller a box became: the largest relative loss of a side, in [0, 1].
double largest_gain(const Box& before, const Box& after);

}  // namespace gcslab
