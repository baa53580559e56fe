#include "box_solver/node_processor.h"

#include <algorithm>
#include <cmath>

namespace gcslab {
namespace {

bool is_subset(const Box& a, const Box& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!subset(a[i], b[i])) return false;
  }
  return true;
}

}  // namespace

NodeProcessor::NodeProcessor(const SystemFunctions& functions, const Box& search_box,
                             std::unique_ptr<Contractor> contractor, const SearchOptions& options)
    : functions_(&functions),
      options_(&options),
      contractor_(std::move(contractor)),
      bisection_(bisection_registry().at(options.bisection).make(functions)) {
  for (const Interval& side : search_box) {
    const double size = is_bounded(side) ? magnitude(side) : 1;
    scales_.push_back(is_bounded(side) && width(side) > 0 ? radius(side) : 1);
    least_magnitude_.push_back(1e-3 * std::min(size, 1.0));
  }
  if (functions.is_square()) {
    newton_.emplace(functions, scales_);
    certifier_.emplace(functions, 53);
  }
}

NodeOutcome NodeProcessor::process(const SearchNode& node, const std::vector<ExclusionBox>& exclusions) {
  NodeOutcome outcome;
  outcome.trace = ProofTrace(options_->proof != nullptr);
  outcome.box = node.box;
  if (is_excluded(outcome, exclusions)) return outcome;
  if (!contractor_->contract(outcome.box, outcome.trace)) {
    outcome.kind = NodeOutcome::Kind::empty;
    return outcome;
  }
  if (is_excluded(outcome, exclusions)) return outcome;
  find_root(outcome);
  if (outcome.found && is_subset(outcome.box, outcome.found->uniqueness_box)) {
    outcome.kind = NodeOutcome::Kind::covered;
    return outcome;
  }
  cut_or_keep(node, outcome);
  return outcome;
}

bool NodeProcessor::is_excluded(NodeOutcome& outcome, const std::vector<ExclusionBox>& exclusions) const {
  for (const ExclusionBox& exclusion : exclusions) {
    if (!is_subset(outcome.box, exclusion.box)) continue;
    outcome.kind = NodeOutcome::Kind::covered;
    outcome.root = exclusion.root;
    return true;
  }
  return false;
}

void NodeProcessor::find_root(NodeOutcome& outcome) {
  if (!certifier_ || !std::ranges::all_of(outcome.box, is_bounded)) return;
  const std::optional<ApproximateRoot> approximate = newton_->run(outcome.box);
  if (!approximate) return;
  outcome.found = certifier_->certify(*approximate);
  if (outcome.found) certifier_->enlarge_uniqueness(*outcome.found, *approximate, outcome.box, scales_);
}

bool NodeProcessor::is_open(std::size_t variable, const Interval& side) const {
  double point = 0;
  if (!cut_point(side, point)) return false;
  const double size = std::max(magnitude(side), least_magnitude_[variable]);
  return std::isinf(size) || width(side) > options_->resolution * size;
}

void NodeProcessor::cut_or_keep(const SearchNode& node, NodeOutcome& outcome) {
  outcome.kind = NodeOutcome::Kind::cut;
  if (outcome.found) {
    if (const auto cut = cut_at_uniqueness_box(outcome.box, outcome.found->uniqueness_box)) {
      outcome.cut = *cut;
      return;
    }
  }
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < outcome.box.size(); ++i) {
    if (is_open(i, outcome.box[i])) open.push_back(i);
  }
  if (open.empty()) {
    outcome.kind = NodeOutcome::Kind::undecided;
    return;
  }
  outcome.cut.variable = bisection_->choose(outcome.box, open, {node.box, node.last_variable});
  static_cast<void>(cut_point(outcome.box[outcome.cut.variable], outcome.cut.point));
}

/// Where the box sticks out of the uniqueness box most, if they meet in a part worth cutting off.
std::optional<Cut> NodeProcessor::cut_at_uniqueness_box(const Box& box, const Box& uniqueness) const {
  std::optional<Cut> best;
  double best_part = 0;
  for (std::size_t i = 0; i < box.size(); ++i) {
    const double side = width(box[i]);
    if (disjoint(box[i], uniqueness[i])) return std::nullopt;
    if (!(side > 0) || !(width(intersection(box[i], uniqueness[i])) > 1e-3 * side)) return std::nullopt;
    const auto consider = [&](double part, double point) {
      if (part > best_part && box[i].lower < point && point < box[i].upper) {
        best_part = part;
        best = Cut{i, point};
      }
    };
    consider((uniqueness[i].lower - box[i].lower) / side, uniqueness[i].lower);
    consider((box[i].upper - uniqueness[i].upper) / side, uniqueness[i].upper);
  }
  return best;
}

}  // namespace gcslab
