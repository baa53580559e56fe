#pragma once

// What one thread does with one box of the search.

#include <memory>
#include <optional>
#include <vector>

#include "box_solver/search.h"
#include "certification/root_certifier.h"
#include "interval/fast_interval.h"

namespace gcslab {

inline constexpr int kDoubleBits = 53;

/// The sizes of the variables: the radii of the search box, at most 1.
std::vector<double> variable_scales(const Box& search_box);

/// A box of the search with what strategies want to know of its past.
struct SearchNode {
  std::uint64_t id = 0;
  Box box;
  std::size_t last_variable = 0;
  double share = 0;    ///< of the whole search
  int stuck = 0;       ///< how many of the last cuts on the way here gained nothing at the highest precision
  double measure = 0;  ///< best-first: larger is taken first
  std::uint64_t cluster = 0;  ///< the small box that it is a part of; 0: it is part of none
};

/// A box in which a certified root is the only one.
struct ExclusionBox {
  Box box;
  std::size_t root;  ///< number of the root
};

struct NodeOutcome {
  enum class Kind {
    empty,      ///< has no solution
    covered,    ///< its only possible root is a certified one: `root`, or the one in `found`
    cut,        ///< to be searched in two parts
    undecided,  ///< too small to cut
    skipped     ///< not worked on: the search was stopped
  };
  Kind kind = Kind::skipped;
  Box box;                             ///< what is left after contraction
  std::optional<CertifiedRoot> found;  ///< a root proved here, in the box or near it
  std::size_t root = 0;                ///< covered: the number of the root, when `found` is empty
  Cut cut{};
  Experience experience;  ///< of the contractor with this box
  int stuck = 0;          ///< of the two parts
  std::string reason;     ///< undecided: why
  ProofTrace trace;
};

/// Contraction and certification in more than double precision, for boxes in which double precision sees only
/// rounding errors.
class PrecisionLevel {
 public:
  PrecisionLevel(const SystemFunctions& functions, const ContractorMaker& make_contractor,
                 const std::string& certifier, const std::vector<double>& scales, int bits);

  Contractor& contractor() { return *contractor_; }
  std::optional<CertifiedRoot> certify(const Box& box);

 private:
  std::unique_ptr<Contractor> contractor_;
  std::unique_ptr<RootCertifier> certifier_;  ///< square systems
};

class NodeProcessor {
 public:
  NodeProcessor(const SystemFunctions& functions, const Box& search_box,
                const ContractorMaker& make_contractor, const SearchOptions& options);

  /// `so_far` is what contractors met in the search before.
  NodeOutcome process(const SearchNode& node, const std::vector<ExclusionBox>& exclusions,
                      const Experience& so_far);

 private:
  bool is_excluded(NodeOutcome& outcome, const std::vector<ExclusionBox>& exclusions) const;
  void find_root(NodeOutcome& outcome);
  /// Works on a box at higher precisions while rounding errors hide what is in it, and once before one that
  /// is too small to cut is given up. False: it has no solution.
  bool escalate(NodeOutcome& outcome);
  /// Whether rounding errors of double precision hide what an equation does in the box: `partly` when they
  /// could be told from its values by sharper bounds only, `wholly` when no contraction in double precision
  /// succeeds.
  enum class Hidden { no, partly, wholly };
  Hidden hidden_by_rounding(const Box& box);
  void cut_or_keep(const SearchNode& node, NodeOutcome& outcome);
  std::optional<Cut> cut_at_uniqueness_box(const Box& box, const Box& uniqueness) const;
  bool is_open(std::size_t variable, const Interval& side) const;
  /// The variables whose sides are worth a cut.
  std::vector<std::size_t> open_sides(const Box& box) const;

  const SystemFunctions* functions_;
  const ContractorMaker* make_contractor_;
  const SearchOptions* options_;
  std::vector<double> scales_;           ///< of the variables
  std::vector<double> least_width_;      ///< narrower sides of a cover are not cut
  std::vector<double> least_magnitude_;  ///< of a variable, for its resolution
  std::unique_ptr<Contractor> contractor_;
  std::unique_ptr<Bisection> bisection_;
  std::optional<NewtonIteration> newton_;     ///< square systems
  std::unique_ptr<RootCertifier> certifier_;  ///< square systems
  SystemEvaluator<FastInterval> evaluator_;
  Matrix<FastInterval> jacobian_;
  std::vector<std::unique_ptr<PrecisionLevel>> levels_;  ///< made when first needed
};

}  // namespace gcslab
