#include "box_solver/search_record.h"

#include <array>
#include <optional>
#include <string>
#include <utility>

#include "base/check.h"
#include "base/error.h"

namespace gcslab {
namespace {

constexpr std::array<std::pair<BoxFate, std::string_view>, 6> kNames = {{{BoxFate::empty, "empty"},
                                                                         {BoxFate::root, "root"},
                                                                         {BoxFate::covered, "covered"},
                                                                         {BoxFate::cut, "cut"},
                                                                         {BoxFate::undecided, "undecided"},
                                                                         {BoxFate::pending, "pending"}}};

/// Does again to a box what a trace says was done to it.
class StageReplay {
 public:
  explicit StageReplay(std::span<const ProofStep> steps) : steps_(steps) {}

  std::vector<Box> run(const Box& box) {
    stages_ = {box};
    const std::optional<Box> left = part(box);
    if (left) keep(*left);
    return std::move(stages_);
  }

 private:
  void keep(const Box& box) {
    if (box != stages_.back()) stages_.push_back(box);
  }

  /// Steps up to the end of the part of a box that is one of two cases, or of everything. Rounds inside a
  /// case are about a part of the box only, and are no stages of it.
  std::optional<Box> part(std::optional<Box> box) {
    for (; next_ < steps_.size(); ++next_) {
      const ProofStep& step = steps_[next_];
      if (step.argument == Argument::otherwise || step.argument == Argument::join) break;
      if (step.argument == Argument::expansion) {
        if (box && depth_ == 0) keep(*box);
        continue;
      }
      if (!box) continue;
      box = step.argument == Argument::cases ? cases(*box) : narrowed(*box, step);
    }
    return box;
  }

  static std::optional<Box> narrowed(Box box, const ProofStep& step) {
    if (is_empty(step.result)) return std::nullopt;
    box[step.variable] = step.result;
    return box;
  }

  /// Both parts of a box and the hull of what they leave; ends on the step that joins them.
  std::optional<Box> cases(const Box& box) {
    const ProofStep& step = steps_[next_++];
    Box lower = box, upper = box;
    lower[step.variable].upper = step.result.lower;
    upper[step.variable].lower = step.result.lower;
    ++depth_;
    const std::optional<Box> left = part(lower);
    GCSLAB_CHECK(next_ < steps_.size() && steps_[next_].argument == Argument::otherwise);
    ++next_;
    const std::optional<Box> right = part(upper);
    GCSLAB_CHECK(next_ < steps_.size() && steps_[next_].argument == Argument::join);
    --depth_;
    if (!left || !right) return left ? left : right;
    Box joined;
    for (std::size_t i = 0; i < box.size(); ++i) joined.push_back(hull((*left)[i], (*right)[i]));
    return joined;
  }

  std::span<const ProofStep> steps_;
  std::size_t next_ = 0;
  int depth_ = 0;
  std::vector<Box> stages_;
};

}  // namespace

std::string_view name_of(BoxFate fate) {
  for (const auto& [known, name] : kNames) {
    if (known == fate) return name;
  }
  return "";
}

BoxFate box_fate_from_name(std::string_view name) {
  for (const auto& [fate, known] : kNames) {
    if (known == name) return fate;
  }
  throw InputError("'" + std::string(name) + "' is no fate of a box");
}

std::vector<Box> stages_of(const Box& box, std::span<const ProofStep> steps) {
  return StageReplay(steps).run(box);
}

void SearchRecord::add(const Box& taken, const ProofTrace& trace, const Box& left, BoxFate fate) {
  ++told_;
  if (boxes_.size() >= limit_) return;
  RecordedBox box{fate, stages_of(taken, trace.steps())};
  if (fate != BoxFate::empty && box.left() != left) box.stages.push_back(left);
  box.reductions = static_cast<int>(box.stages.size()) - 1;
  if (fate == BoxFate::empty) {
    ++box.reductions;
    if (!trace.steps().empty()) box.reason = trace.steps().back().argument;
  }
  boxes_.push_back(std::move(box));
}

}  // namespace gcslab
