#pragma once

// The branch-and-prune engine: contract a box, certify a root in it, or cut it in two.
//
// Promise: every solution of the system in the search box lies in the box of a listed solution or in an
// undecided box. Each listed solution is certified, and no two are the same root. Where no more is proved of
// an undecided box than that a root exists in it, a solution of the claim `exists` is listed beside it: it
// settles nothing, since there may be more roots. The answer does not depend
// on the number of threads: boxes are taken in batches of one size, each is worked on with what was known
// when its batch began, and the findings are taken in order.

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "box_solver/bisection.h"
#include "box_solver/contractor.h"
#include "box_solver/proof_log.h"
#include "box_solver/search_record.h"
#include "certification/root_certificate.h"

namespace gcslab {

enum class Order { depth_first, best_first };

struct SearchOptions {
  std::string bisection = "relative_smear_sum";
  std::string certifier = "krawczyk_slopes+kantorovich";  ///< composition of root_certifier.h
  Order order = Order::depth_first;
  double resolution = 1e-13;           ///< sides narrower than this part of their magnitude are not cut
  double cover_resolution = 1.0 / 64;  ///< the same for systems with fewer equations than variables, as part
                                       ///< of the search box: their solution set is covered
  int maximum_bits = 1024;             ///< precision goes up to this where double cannot decide
  /// Boxes spent on a box narrower than 1e-5 of the variables' sizes before the rest of it stays undecided:
  /// around a multiple root too many are left to follow. Not for systems whose solution set is covered.
  std::uint64_t cluster_boxes = 20'000;
  std::uint64_t maximum_boxes = ~std::uint64_t{0};
  std::size_t maximum_open = 2'000'000;  ///< boxes held in memory
  int threads = 1;
  ProofLog* proof = nullptr;       ///< told everything that the search does
  SearchRecord* record = nullptr;  ///< told every box with its fate
};

/// What is known of the inequalities at a root.
enum class InequalityState { proved, undecided };

struct Solution {
  CertifiedRoot root;  ///< for the claim `exists` without uniqueness: that box is empty
  InequalityState inequalities = InequalityState::proved;
  Claim claim = Claim::unique;  ///< or `exists`
};

struct UndecidedBox {
  Box box;
  std::string reason;
};

struct SearchStatistics {
  std::uint64_t boxes = 0;  ///< taken from the list
  std::uint64_t bisections = 0;
  double explored = 0;  ///< part of the search that is settled, each cut counted as two halves
};

struct SearchResult {
  std::vector<CertifiedRoot> roots;     ///< all that were proved, in the search box or near it
  std::vector<Solution> solutions;      ///< those of them that are solutions, then what only exists
  std::vector<UndecidedBox> undecided;  ///< searched down to the resolution; touching ones as their hull
  std::vector<Box> pending;             ///< not searched when the budget ended
  SearchStatistics statistics;
};

/// An upper bound of the volume of all undecided boxes and all that were not searched, together.
double undecided_volume(const SearchResult& result);

/// Makes the contractor of one thread: in the arithmetic of the method for 53 bits, else in MPFR intervals of
/// that many.
using ContractorMaker = std::function<std::unique_ptr<Contractor>(const SystemFunctions&, int bits)>;

/// Sees the search as it goes on.
class SearchObserver {
 public:
  virtual ~SearchObserver() = default;
  virtual void batch_done(const SearchStatistics&, std::size_t /*open*/, std::size_t /*solutions*/) {}
};

/// What a search starts from: at first the search box, later what an interrupted one left.
struct SearchStart {
  std::vector<Box> boxes;
  std::vector<CertifiedRoot> roots{};
  std::vector<UndecidedBox> undecided{};
};

/// Searches the boxes, which together are the search box or what is left of it. `search_box` says which roots
/// are solutions: those whose box meets it.
SearchResult search(const SystemFunctions& functions, const Box& search_box, SearchStart start,
                    const ContractorMaker& make_contractor, const SearchOptions& options,
                    const std::stop_token& stop = {}, SearchObserver* observer = nullptr);

}  // namespace gcslab
