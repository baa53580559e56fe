#pragma once

// The terms of a lifted system over a box: their values, and the strips around those that are graphs.

#include <memory>
#include <optional>
#include <vector>

#include "box_solver/graph_strips.h"
#include "box_solver/lifted_system.h"

namespace gcslab {

/// Two variables of a lifted system of which one is a function of the other.
struct GraphColumns {
  std::size_t value;
  std::size_t argument;
};

class TermRanges {
 public:
  /// `system` must outlive it.
  explicit TermRanges(const LiftedSystem& system);

  /// The box, followed by a side for each term that encloses its values there.
  Box lift(const Box& box);

  const std::vector<GraphColumns>& graphs() const { return graphs_; }
  /// The strips of a graph over a lifted box.
  const StripsOfGraph& strips(std::size_t graph, const Box& lifted);

 private:
  std::optional<Tape> tape_;  ///< of all terms
  std::optional<TapeEvaluator<FastInterval>> evaluator_;
  std::vector<GraphColumns> graphs_;
  std::vector<GraphStrips> strips_;  ///< one a graph
};

}  // namespace gcslab
