#include "packing/packing_solver.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/error.h"
#include "box_solver/inequality_check.h"
#include "certification/krawczyk_certifier.h"
#include "interval/fast_interval.h"
#include "packing/angle_sum.h"
#include "packing/circle_layout.h"
#include "packing/packing_problem.h"
#include "packing/radii_enclosure.h"

namespace gcslab {
namespace {

std::array<Rational, 3> outer_radii(const OuterDiscs& outer) {
  return {outer[0].radius, outer[1].radius, outer[2].radius};
}

/// A box of doubles that holds the packing; nothing when the radii could not be enclosed with so many bits.
std::optional<Box> layout_box(const PackingProblem& problem, const std::vector<double>& approximate,
                              int bits) {
  const NumberTraits<MpfrInterval>::Scope scope(bits);
  const auto radii = enclose_radii(problem.graph, outer_radii(problem.outer), approximate, bits);
  if (!radii) return std::nullopt;
  const std::vector<EnclosedDisc> discs = lay_out(problem.graph, problem.outer, *radii);
  Box box;
  for (std::size_t v = 3; v < discs.size(); ++v) {
    for (const MpfrInterval* part : {&discs[v].x, &discs[v].y, &discs[v].radius})
      box.push_back(part->interval());
  }
  return std::ranges::all_of(box, is_bounded) ? std::optional(box) : std::nullopt;
}

bool is_subset(const Box& a, const Box& b) {
  return std::ranges::equal(a, b, [](const Interval& x, const Interval& y) { return subset(x, y); });
}

/// What Krawczyk's operator proves of a box of this arithmetic.
template <class T>
std::optional<CertifiedRoot> certified(const SystemFunctions& functions, const Box& box, int bits) {
  ApproximateRoot centre;
  std::vector<double> scales;
  for (const Interval& side : box) scales.push_back(std::min(1.0, magnitude(side)));
  KrawczykCertifier<T> certifier(functions, scales, bits);
  std::optional<CertifiedRoot> root = certifier.certify_box(box, centre);
  if (!root || !is_subset(box, root->uniqueness_box)) return std::nullopt;
  return root;
}

/// No narrower box of doubles would hold much less.
bool is_tight(const Box& box) {
  return std::ranges::all_of(box, [](const Interval& side) {
    double end = side.lower;
    for (int i = 0; i < 3; ++i) end = std::nextafter(end, side.upper);
    return end == side.upper;
  });
}

/// The packing as a root of the equations. More precision in the proof is worth its time only where more in
/// the layout is of no use.
std::optional<CertifiedRoot> root_in(const SystemFunctions& functions, const Box& box, int bits) {
  std::optional<CertifiedRoot> root = certified<FastInterval>(functions, box, 53);
  if (!root && is_tight(box)) root = certified<MpfrInterval>(functions, box, bits);
  if (!root) return std::nullopt;
  // The one root of the uniqueness box is the packing, and so lies in both boxes.
  for (std::size_t i = 0; i < box.size(); ++i) {
    root->box[i] = intersection(root->box[i], box[i]);
    GCSLAB_CHECK(!is_empty(root->box[i]));
  }
  root->evidence.insert(root->evidence.begin(), {"angle_sum", Claim::unique, box, bits});
  return root;
}

class PackingSolver {
 public:
  PackingSolver(const SystemFunctions& functions, const Box& search_box, const PackingSolverOptions& options)
      : functions_(functions),
        search_box_(search_box),
        options_(options),
        problem_(recognise_packing(functions)) {}

  SearchResult run(const std::stop_token& stop) {
    if (options_.proof != nullptr) options_.proof->begin(search_box_);
    result_.statistics.boxes = 1;
    const auto root = find_root(stop);
    if (root) {
      take(*root);
    } else if (stop.stop_requested()) {
      keep_pending();
    } else {
      keep_undecided("doubles are too coarse for the discs of this packing, or maximum_bits is too low");
    }
    if (options_.proof != nullptr) options_.proof->finish();
    return std::move(result_);
  }

 private:
  std::optional<CertifiedRoot> find_root(const std::stop_token& stop) const {
    const OuterDiscs& outer = problem_.outer;
    const auto approximate = approximate_radii(
        problem_.graph, {outer[0].radius.get_d(), outer[1].radius.get_d(), outer[2].radius.get_d()});
    if (!approximate) return std::nullopt;
    for (int bits = options_.bits;; bits = std::min(2 * bits, options_.maximum_bits)) {
      if (stop.stop_requested()) return std::nullopt;
      const std::optional<Box> box = layout_box(problem_, *approximate, bits);
      if (box) {
        auto root = root_in(functions_, *box, bits);
        if (root || is_tight(*box)) return root;
      }
      if (bits >= options_.maximum_bits) return std::nullopt;
    }
  }

  void take(const CertifiedRoot& root) {
    result_.roots.push_back(root);
    if (options_.proof != nullptr) options_.proof->root(0, root);
    const auto state = InequalityCheck(functions_).at(root.box);
    if (state && meets_search_box(root.box)) result_.solutions.push_back({root, *state});
    if (const auto gap = completeness_gap(root, state)) {
      keep_undecided("that there is no other solution is not proved: " + *gap);
    } else if (options_.proof != nullptr) {
      options_.proof->theorem("circle_packing");
    }
  }

  bool meets_search_box(const Box& box) const {
    return std::ranges::equal(box, search_box_,
                              [](const Interval& x, const Interval& y) { return !disjoint(x, y); });
  }

  std::optional<std::string> completeness_gap(const CertifiedRoot& root,
                                              const std::optional<InequalityState>& state) const {
    if (!is_subset(root.box, search_box_)) return "the packing does not lie in the box";
    if (state != InequalityState::proved) return "an inequality is not proved of the packing";
    return uniqueness_gap(problem_, search_box_);
  }

  void keep_undecided(std::string reason) {
    if (options_.proof != nullptr) {
      options_.proof->start(0, search_box_);
      options_.proof->node(0, ProofTrace());
      options_.proof->end_undecided();
    }
    result_.undecided.push_back({search_box_, std::move(reason)});
  }

  void keep_pending() {
    if (options_.proof != nullptr) {
      options_.proof->start(0, search_box_);
      options_.proof->node(0, ProofTrace());
      options_.proof->end_pending();
    }
    result_.pending.push_back(search_box_);
  }

  const SystemFunctions& functions_;
  const Box& search_box_;
  PackingSolverOptions options_;
  PackingProblem problem_;
  SearchResult result_;
};

}  // namespace

SearchResult solve_packing(const SystemFunctions& functions, const Box& search_box,
                           const PackingSolverOptions& options, const std::stop_token& stop) {
  return PackingSolver(functions, search_box, options).run(stop);
}

}  // namespace gcslab
