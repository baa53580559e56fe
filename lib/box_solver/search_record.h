#pragma once

// What a search did, box by box, so that it can be drawn.
//
// Holds the first boxes that a search took, up to a limit, in the order in which their findings were taken:
// the same for any number of threads. Each comes with what was left of it after each round of contraction,
// and with what became of it. The boxes of one fate other than `cut` and the parts that contractions took
// away tile the search box.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "box_solver/proof_step.h"

namespace gcslab {

enum class BoxFate {
  empty,      ///< proved to have no root
  root,       ///< its only root was certified here
  covered,    ///< its only possible root is one that was certified elsewhere
  cut,        ///< searched on in two parts
  undecided,  ///< too small to cut, with nothing proved
  pending     ///< not searched when the budget ended
};

std::string_view name_of(BoxFate fate);
/// Throws InputError for another word.
BoxFate box_fate_from_name(std::string_view name);

struct RecordedBox {
  BoxFate fate = BoxFate::pending;
  /// As it was taken, then what each round of contraction that narrowed it left.
  std::vector<Box> stages;
  /// Rounds of contraction: those that narrowed it and one that showed that it has no root.
  int reductions = 0;
  /// empty: the argument that showed it.
  Argument reason = Argument::expansion;

  const Box& taken() const { return stages.front(); }
  const Box& left() const { return stages.back(); }
};

class SearchRecord {
 public:
  explicit SearchRecord(std::size_t limit) : limit_(limit) {}

  /// A box with what was done to it; `left` is what contraction left, unless the box is empty.
  void add(const Box& taken, const ProofTrace& trace, const Box& left, BoxFate fate);

  const std::vector<RecordedBox>& boxes() const { return boxes_; }
  /// All boxes that were told, those beyond the limit too.
  std::uint64_t told() const { return told_; }
  bool is_whole() const { return told_ == boxes_.size(); }

 private:
  std::size_t limit_;
  std::uint64_t told_ = 0;
  std::vector<RecordedBox> boxes_;
};

/// The box before the steps and after each round that narrowed it, ending with what all of them leave (with
/// the last nonempty one where they show that there is no root). A round begins where a contractor expands
/// the equations about the box.
std::vector<Box> stages_of(const Box& box, std::span<const ProofStep> steps);

}  // namespace gcslab
