#include "box_solver/search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "box_solver/box_clusters.h"
#include "box_solver/inequality_check.h"
#include "box_solver/lifted_system.h"
#include "box_solver/node_processor.h"
#include "box_solver/worker_pool.h"
#include "certification/root_certifier.h"

namespace gcslab {
namespace {

/// The same for any number of threads, so that the answer is too.
constexpr std::size_t kBatch = 16;

bool meet(const Box& a, const Box& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (disjoint(a[i], b[i])) return false;
  }
  return true;
}

bool is_subset(const Box& a, const Box& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!subset(a[i], b[i])) return false;
  }
  return true;
}

constexpr const char* kGivenUp =
    "part of a small box in which too many boxes stayed: perhaps a multiple root";

/// Boxes are small when their sides are at most this part of the variables' sizes.
constexpr double kSmall = 1e-5;

constexpr const char* kContainsRoot = "contains a root, which is listed, but perhaps others too";

/// Largest relative side: what best-first search takes first.
double measure_of(const Box& box, const Box& search_box) {
  double largest = 0;
  for (std::size_t i = 0; i < box.size(); ++i) {
    const double whole = width(search_box[i]);
    largest = std::max(largest, whole > 0 ? width(box[i]) / whole : 0);
  }
  return largest;
}

class Search {
 public:
  Search(const SystemFunctions& functions, const Box& search_box, const ContractorMaker& make_contractor,
         const SearchOptions& options)
      : functions_(functions),
        search_box_(search_box),
        options_(options),
        scales_(variable_scales(search_box)),
        inequalities_(functions),
        pool_(options.threads, [&] {
          return std::make_unique<NodeProcessor>(functions, search_box, make_contractor, options);
        }) {}

  SearchResult run(SearchStart start, const std::stop_token& stop, SearchObserver* observer) {
    if (options_.proof != nullptr) {
      options_.proof->begin(search_box_);
      for (const Term& term : terms_of(functions_)) options_.proof->term(term.place);
    }
    for (const CertifiedRoot& root : start.roots) enter_root(root);
    result_.undecided = std::move(start.undecided);
    const double share = 1.0 / static_cast<double>(start.boxes.size());
    for (auto box = start.boxes.rbegin(); box != start.boxes.rend(); ++box) {
      if (options_.proof != nullptr) options_.proof->start(next_id_, *box);
      push({.id = next_id_++, .box = std::move(*box), .share = share});
    }
    while (!open_.empty() && !stop.stop_requested() && within_budget()) {
      take_batch();
      const auto work = [&](NodeProcessor& processor, std::size_t i) {
        if (!stop.stop_requested()) outcomes_[i] = processor.process(batch_[i], exclusions_, experience_);
      };
      pool_.run(batch_.size(), work);
      merge_batch();
      if (observer != nullptr)
        observer->batch_done(result_.statistics, open_.size(), result_.solutions.size());
    }
    settle_given_up();
    for (SearchNode& node : open_) keep_pending(node);
    if (options_.proof != nullptr) options_.proof->finish();
    result_.roots = std::move(roots_);
    result_.undecided = clustered(std::move(result_.undecided), search_box_);
    list_existing(stop);
    return std::move(result_);
  }

 private:
  bool within_budget() const {
    return result_.statistics.boxes < options_.maximum_boxes && open_.size() < options_.maximum_open;
  }

  void push(SearchNode node) {
    if (options_.order == Order::depth_first) {
      open_.push_back(std::move(node));
      return;
    }
    node.measure = measure_of(node.box, search_box_);
    open_.push_back(std::move(node));
    std::ranges::push_heap(open_, {}, &SearchNode::measure);
  }

  void take_batch() {
    batch_.clear();
    const std::uint64_t left = options_.maximum_boxes - result_.statistics.boxes;
    while (!open_.empty() && batch_.size() < std::min<std::uint64_t>(kBatch, left)) {
      if (options_.order == Order::best_first) std::ranges::pop_heap(open_, {}, &SearchNode::measure);
      SearchNode node = std::move(open_.back());
      open_.pop_back();
      if (is_given_up(node)) {
        given_up_.push_back(std::move(node));
      } else {
        batch_.push_back(std::move(node));
      }
    }
    outcomes_.assign(batch_.size(), NodeOutcome());
  }

  /// The last node of the batch was the deepest; its children are pushed last.
  void merge_batch() {
    for (std::size_t i = batch_.size(); i-- > 0;) merge(batch_[i], outcomes_[i]);
  }

  /// Whether too many boxes were spent on the small box that it is a part of.
  bool is_given_up(const SearchNode& node) const {
    const auto found = boxes_of_cluster_.find(node.cluster);
    return found != boxes_of_cluster_.end() && found->second >= options_.cluster_boxes;
  }

  /// A root that was found since may cover what was given up; the rest stays undecided.
  void settle_given_up() {
    for (SearchNode& node : given_up_) {
      result_.statistics.explored += node.share;
      const auto covers = [&](const ExclusionBox& exclusion) { return is_subset(node.box, exclusion.box); };
      const auto found = std::ranges::find_if(exclusions_, covers);
      if (found == exclusions_.end()) {
        leave_undecided(node);
      } else {
        leave_covered(node, found->root);
      }
    }
    given_up_.clear();
  }

  void leave_covered(const SearchNode& node, std::size_t root) {
    if (options_.proof != nullptr) {
      options_.proof->node(node.id, ProofTrace());
      options_.proof->end_covered(root);
    }
    if (options_.record != nullptr) options_.record->add(node.box, ProofTrace(), node.box, BoxFate::covered);
  }

  void leave_undecided(SearchNode& node) {
    if (options_.proof != nullptr) options_.proof->node(node.id, ProofTrace());
    if (options_.record != nullptr)
      options_.record->add(node.box, ProofTrace(), node.box, BoxFate::undecided);
    keep_undecided(std::move(node.box), kGivenUp);
  }

  /// Small against the variables' sizes, where solutions are points.
  bool is_small(const Box& box) const {
    if (functions_.constraints() < functions_.variables()) return false;
    for (std::size_t i = 0; i < box.size(); ++i) {
      if (!(width(box[i]) <= kSmall * scales_[i])) return false;
    }
    return true;
  }

  void merge(SearchNode& node, NodeOutcome& outcome) {
    if (outcome.kind == NodeOutcome::Kind::skipped) {
      push(std::move(node));
      return;
    }
    ++result_.statistics.boxes;
    if (node.cluster != 0) ++boxes_of_cluster_[node.cluster];
    experience_ += outcome.experience;
    const std::size_t known_roots = roots_.size();
    const bool is_settled = !outcome.found || take_root(outcome);
    if (options_.record != nullptr) {
      const BoxFate fate = fate_of(outcome, is_settled, roots_.size() > known_roots);
      options_.record->add(node.box, outcome.trace, outcome.box, fate);
    }
    if (options_.proof != nullptr) options_.proof->node(node.id, outcome.trace);
    if (outcome.kind == NodeOutcome::Kind::cut) {
      cut(outcome, node);
      return;
    }
    result_.statistics.explored += node.share;
    switch (outcome.kind) {
      case NodeOutcome::Kind::covered:
        if (is_settled) {
          if (options_.proof != nullptr) options_.proof->end_covered(outcome.root);
        } else {
          keep_undecided(std::move(outcome.box), "a root that could not be told from another one");
        }
        return;
      case NodeOutcome::Kind::empty:
        if (options_.proof != nullptr) options_.proof->end_empty();
        return;
      case NodeOutcome::Kind::undecided:
        keep_undecided(std::move(outcome.box), std::move(outcome.reason));
        return;
      case NodeOutcome::Kind::cut:
      case NodeOutcome::Kind::skipped:
        return;
    }
  }

  static BoxFate fate_of(const NodeOutcome& outcome, bool is_settled, bool is_new_root) {
    switch (outcome.kind) {
      case NodeOutcome::Kind::empty:
        return BoxFate::empty;
      case NodeOutcome::Kind::covered:
        return !is_settled ? BoxFate::undecided : is_new_root ? BoxFate::root : BoxFate::covered;
      case NodeOutcome::Kind::cut:
        return BoxFate::cut;
      case NodeOutcome::Kind::undecided:
        return BoxFate::undecided;
      case NodeOutcome::Kind::skipped:
        break;
    }
    return BoxFate::pending;
  }

  void keep_undecided(Box box, std::string reason) {
    if (options_.proof != nullptr) options_.proof->end_undecided();
    result_.undecided.push_back({std::move(box), std::move(reason)});
  }

  void keep_pending(SearchNode& node) {
    if (options_.proof != nullptr) {
      options_.proof->node(node.id, ProofTrace());
      options_.proof->end_pending();
    }
    if (options_.record != nullptr) options_.record->add(node.box, ProofTrace(), node.box, BoxFate::pending);
    result_.pending.push_back(std::move(node.box));
  }

  void cut(const NodeOutcome& outcome, const SearchNode& node) {
    ++result_.statistics.bisections;
    const auto [variable, point] = outcome.cut;
    if (options_.proof != nullptr) options_.proof->end_cut(variable, point, next_id_, next_id_ + 1);
    SearchNode lower{.id = next_id_++,
                     .box = outcome.box,
                     .last_variable = variable,
                     .share = node.share / 2,
                     .stuck = outcome.stuck,
                     .cluster = node.cluster};
    if (lower.cluster == 0 && is_small(outcome.box)) lower.cluster = lower.id;
    SearchNode upper = lower;
    upper.id = next_id_++;
    lower.box[variable].upper = point;
    upper.box[variable].lower = point;
    push(std::move(upper));
    push(std::move(lower));
  }

  /// Enters the root of an outcome into the list of known ones unless it is there. False when that cannot be
  /// told.
  bool take_root(NodeOutcome& outcome) {
    const CertifiedRoot& root = *outcome.found;
    for (std::size_t k = 0; k < roots_.size(); ++k) {
      const bool same =
          is_subset(root.box, roots_[k].uniqueness_box) || is_subset(roots_[k].box, root.uniqueness_box);
      if (same) {
        exclude(root.uniqueness_box, k, root);
        outcome.root = k;
        return true;
      }
      if (meet(root.box, roots_[k].box)) return false;
    }
    outcome.root = roots_.size();
    enter_root(root);
    return true;
  }

  void enter_root(const CertifiedRoot& root) {
    exclude(root.uniqueness_box, roots_.size(), root);
    roots_.push_back(root);
    if (!meet(root.box, search_box_)) return;
    if (const auto state = inequalities_.at(root.box)) result_.solutions.push_back({root, *state});
  }

  void exclude(const Box& box, std::size_t number, const CertifiedRoot& root) {
    exclusions_.push_back({box, number});
    if (options_.proof != nullptr) options_.proof->root(number, root);
  }

  /// Lists a root of each undecided box in which one is proved to exist, apart from all that are listed.
  void list_existing(const std::stop_token& stop) {
    if (!functions_.is_square() || result_.undecided.empty()) return;
    const auto certifier =
        make_root_certifier(options_.certifier, functions_, variable_scales(search_box_), kDoubleBits);
    for (UndecidedBox& entry : result_.undecided) {
      if (stop.stop_requested()) return;
      const std::optional<Evidence> evidence = certifier->prove_existence(entry.box);
      if (!evidence || !meet(evidence->box, search_box_) || is_listed_near(evidence->box)) continue;
      const auto state = inequalities_.at(evidence->box);
      if (!state) continue;
      entry.reason = kContainsRoot;
      result_.solutions.push_back({{evidence->box, {}, {*evidence}}, *state, Claim::exists});
    }
  }

  bool is_listed_near(const Box& box) const {
    const auto is_near = [&](const Box& other) { return meet(box, other); };
    return std::ranges::any_of(result_.roots, is_near, &CertifiedRoot::box) ||
           std::ranges::any_of(result_.solutions, [&](const Solution& s) { return is_near(s.root.box); });
  }

  const SystemFunctions& functions_;
  const Box& search_box_;
  const SearchOptions& options_;
  std::vector<double> scales_;  ///< of the variables
  InequalityCheck inequalities_;
  WorkerPool<NodeProcessor> pool_;
  std::vector<SearchNode> open_;  ///< a stack, or a heap by measure
  std::vector<SearchNode> batch_;
  std::vector<SearchNode> given_up_;  ///< parts of small boxes on which too many were spent
  std::vector<NodeOutcome> outcomes_;
  std::vector<CertifiedRoot> roots_;  ///< in the search box or near it
  std::vector<ExclusionBox> exclusions_;
  std::uint64_t next_id_ = 0;
  Experience experience_;  ///< of the contractors
  std::unordered_map<std::uint64_t, std::uint64_t> boxes_of_cluster_;
  SearchResult result_;
};

}  // namespace

double undecided_volume(const SearchResult& result) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double sum = 0;
  const auto add = [&](const Box& box) {
    double volume = 1;
    for (const Interval& side : box) {
      const double factor = width(side);  // rounded upward
      volume = factor == 0 || volume == 0 ? 0 : std::nextafter(volume * factor, kInfinity);
    }
    if (volume > 0) sum = std::nextafter(sum + volume, kInfinity);
  };
  for (const UndecidedBox& entry : result.undecided) add(entry.box);
  for (const Box& box : result.pending) add(box);
  return sum;
}

SearchResult search(const SystemFunctions& functions, const Box& search_box, SearchStart start,
                    const ContractorMaker& make_contractor, const SearchOptions& options,
                    const std::stop_token& stop, SearchObserver* observer) {
  return Search(functions, search_box, make_contractor, options).run(std::move(start), stop, observer);
}

}  // namespace gcslab
