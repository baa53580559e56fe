#include "box_solver/node_processor.h"

#include <algorithm>
#include <cmath>

namespace gcslab {
namespace {

SystemEvaluator<FastInterval> made_in_scope(const SystemFunctions& functions) {
  const NumberTraits<FastInterval>::Scope scope;
  return SystemEvaluator<FastInterval>(functions);
}

bool is_subset(const Box& a, const Box& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!subset(a[i], b[i])) return false;
  }
  return true;
}

}  // namespace

std::vector<double> variable_scales(const Box& search_box) {
  std::vector<double> scales;
  for (const Interval& side : search_box)
    scales.push_back(is_bounded(side) && width(side) > 0 ? std::min(radius(side), 1.0) : 1);
  return scales;
}

PrecisionLevel::PrecisionLevel(const SystemFunctions& functions, const ContractorMaker& make_contractor,
                               const std::string& certifier, const std::vector<double>& scales, int bits)
    : contractor_(make_contractor(functions, bits)) {
  if (functions.is_square()) certifier_ = make_root_certifier(certifier, functions, scales, bits);
}

std::optional<CertifiedRoot> PrecisionLevel::certify(const Box& box) {
  return certifier_ == nullptr ? std::nullopt : certifier_->certify_box(box);
}

NodeProcessor::NodeProcessor(const SystemFunctions& functions, const Box& search_box,
                             const ContractorMaker& make_contractor, const SearchOptions& options)
    : functions_(&functions),
      make_contractor_(&make_contractor),
      options_(&options),
      scales_(variable_scales(search_box)),
      contractor_(make_contractor(functions, kDoubleBits)),
      bisection_(bisection_registry().at(options.bisection).make(functions)),
      evaluator_(made_in_scope(functions)),
      jacobian_(functions.equations().size(), functions.variables()) {
  for (const Interval& side : search_box) {
    const double size = is_bounded(side) ? magnitude(side) : 1;
    const bool is_cover = functions.constraints() < functions.variables();
    least_width_.push_back(is_cover && is_bounded(side) ? options.cover_resolution * width(side) : 0);
    least_magnitude_.push_back(1e-3 * std::min(size, 1.0));
  }
  if (functions.is_square()) {
    newton_.emplace(functions, scales_);
    certifier_ = make_root_certifier(options.certifier, functions, scales_, kDoubleBits);
  }
}

NodeOutcome NodeProcessor::process(const SearchNode& node, const std::vector<ExclusionBox>& exclusions,
                                   const Experience& so_far) {
  NodeOutcome outcome;
  outcome.trace = ProofTrace(options_->proof != nullptr || options_->record != nullptr);
  outcome.box = node.box;
  if (is_excluded(outcome, exclusions)) return outcome;
  contractor_->learn(so_far, node.id);
  const bool may_have_roots = contractor_->contract(outcome.box, outcome.trace);
  outcome.experience = contractor_->experience();
  if (!may_have_roots) {
    outcome.kind = NodeOutcome::Kind::empty;
    return outcome;
  }
  if (is_excluded(outcome, exclusions)) return outcome;
  find_root(outcome);
  if (!outcome.found && !escalate(outcome)) {
    outcome.kind = NodeOutcome::Kind::empty;
    return outcome;
  }
  if (outcome.found && is_subset(outcome.box, outcome.found->uniqueness_box)) {
    outcome.kind = NodeOutcome::Kind::covered;
    return outcome;
  }
  if (outcome.stuck > 0) outcome.stuck += node.stuck;
  cut_or_keep(node, outcome);
  return outcome;
}

/// Compares the error of each equation's value at the midpoint with what the equation varies by over the box:
/// `partly` by its gradient there, `wholly` by the bounds of its gradient on the box.
NodeProcessor::Hidden NodeProcessor::hidden_by_rounding(const Box& box) {
  constexpr double kSmall = 1e-3;
  constexpr double kPart = 0.1;
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (!(width(box[i]) <= kSmall * scales_[i])) return Hidden::no;
  }
  const NumberTraits<FastInterval>::Scope scope;
  std::vector<FastInterval> whole, middle;
  for (const Interval& side : box) {
    whole.emplace_back(side);
    middle.emplace_back(midpoint(side));
  }
  std::vector<FastInterval> values(functions_->equations().size());
  evaluator_.values(middle, values);
  const auto error_dominates = [&](const std::vector<FastInterval>& where) {
    if (!evaluator_.jacobian(where, jacobian_)) return false;
    for (std::size_t k = 0; k < values.size(); ++k) {
      double variation = 0;
      for (std::size_t i = 0; i < box.size(); ++i)
        variation += magnitude(jacobian_(k, i).interval()) * radius(box[i]);
      if (!(width(values[k].interval()) > kPart * variation)) return false;
    }
    return true;
  };
  if (!error_dominates(middle)) return Hidden::no;
  return error_dominates(whole) ? Hidden::wholly : Hidden::partly;
}

bool NodeProcessor::escalate(NodeOutcome& outcome) {
  constexpr int kFirstLevel = 128;
  if (options_->maximum_bits < kFirstLevel) return true;
  const Hidden hidden = hidden_by_rounding(outcome.box);
  const bool is_last_chance = certifier_ != nullptr && open_sides(outcome.box).empty();
  const int maximum_bits = hidden == Hidden::wholly                     ? options_->maximum_bits
                           : hidden == Hidden::partly || is_last_chance ? kFirstLevel
                                                                        : 0;
  int bits = kFirstLevel;
  for (std::size_t level = 0; bits <= maximum_bits; ++level, bits *= 2) {
    if (levels_.size() <= level)
      levels_.push_back(std::make_unique<PrecisionLevel>(*functions_, *make_contractor_, options_->certifier,
                                                         scales_, bits));
    const Box before = outcome.box;
    if (!levels_[level]->contractor().contract(outcome.box, outcome.trace)) return false;
    outcome.found = levels_[level]->certify(outcome.box);
    if (outcome.found || largest_gain(before, outcome.box) > 0.1) return true;
  }
  if (hidden == Hidden::wholly) ++outcome.stuck;
  return true;
}

std::vector<std::size_t> NodeProcessor::open_sides(const Box& box) const {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (is_open(i, box[i])) open.push_back(i);
  }
  return open;
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
  if (certifier_ == nullptr || !std::ranges::all_of(outcome.box, is_bounded)) return;
  const std::optional<ApproximateRoot> approximate = newton_->run(outcome.box);
  if (!approximate) return;
  outcome.found = certifier_->certify(*approximate, outcome.box);
}

bool NodeProcessor::is_open(std::size_t variable, const Interval& side) const {
  double point = 0;
  if (!cut_point(side, point)) return false;
  if (width(side) <= least_width_[variable]) return false;
  const double size = std::max(magnitude(side), least_magnitude_[variable]);
  return std::isinf(size) || width(side) > options_->resolution * size;
}

void NodeProcessor::cut_or_keep(const SearchNode& node, NodeOutcome& outcome) {
  constexpr int kMaximumStuck = 6;
  constexpr double kFarOut = 1e100;  // products overflow soon after: no cut would help
  outcome.kind = NodeOutcome::Kind::cut;
  if (std::ranges::any_of(outcome.box, [](const Interval& side) { return mignitude(side) > kFarOut; })) {
    outcome.kind = NodeOutcome::Kind::undecided;
    outcome.reason = "beyond 1e100, where double precision decides nothing";
    return;
  }
  if (outcome.stuck > kMaximumStuck) {
    outcome.kind = NodeOutcome::Kind::undecided;
    outcome.reason = "no precision up to maximum_bits decides: perhaps a multiple root";
    return;
  }
  if (outcome.found) {
    if (const auto cut = cut_at_uniqueness_box(outcome.box, outcome.found->uniqueness_box)) {
      outcome.cut = *cut;
      return;
    }
  }
  const std::vector<std::size_t> open = open_sides(outcome.box);
  if (open.empty()) {
    outcome.kind = NodeOutcome::Kind::undecided;
    outcome.reason = functions_->constraints() < functions_->variables()
                         ? "meets the set of solutions, as far as is known"
                         : "as narrow as the resolution, with nothing proved";
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
