#pragma once

// Replays a proof file: every box that the search started from or made by a cut is followed to its end, and
// every narrowing on the way is proved again.
//
// Promise: when run() returns with `is_complete`, every solution of the system in the search box lies in the
// box of a listed solution or in an undecided box of the result. What is not proved throws Refused with file
// and line.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "verifier/proof_reader.h"
#include "verifier/root_counter.h"
#include "verifier/root_prover.h"
#include "verifier/step_judge.h"

namespace gcslab::verifier {

/// What the result file lists, as far as it is proved.
struct ListedRoot {
  EnclosedRoot root;
  Box uniqueness_box;
};
struct ListedResult {
  std::vector<ListedRoot> roots;
  std::vector<Box> undecided;
  const RootCounter* counter = nullptr;  ///< for one polynomial in one variable
  std::vector<Interval> parts{};         ///< of the line, where roots are listed; with a counter

  /// Whether these parts and `others` contain all roots in the search interval.
  bool holds_all_roots(const Interval& search, const std::vector<Interval>& others) const;
};

struct ReplaySummary {
  bool is_complete = false;
  std::string gap;                              ///< why not
  std::map<std::string, std::uint64_t> counts;  ///< of what was proved, by name
};

class ProofReplay {
 public:
  /// All must outlive it.
  ProofReplay(JudgedSystem& system, const Box& search_box, const ListedResult& listed, ProofReader& reader);

  ReplaySummary run();

 private:
  /// A box on the way, with what was said about it.
  struct Part {
    Box box;
    bool is_empty = false;
    ExpansionBox expansion;
  };
  /// A case distinction: the part as it was before, and the first case once it is done.
  struct Cases {
    Part before;
    std::size_t variable;
    double point;
    std::optional<Part> first;
  };
  struct KnownRoot {
    EnclosedRoot root;
    std::vector<Box> uniqueness_boxes;
    bool is_accounted_for = false;  ///< listed, or proved to be no solution in the search box
  };

  void read_header();
  bool read_event(std::string_view word);
  void read_term();
  void read_start();
  void read_root();
  void read_node();
  void read_theorem();
  void read_packing_theorem();
  void read_loci_theorem();
  void read_hash();

  bool read_step(std::string_view word);
  void read_propagation(bool is_equation);
  /// Variable, claim and, into multipliers_, one multiplier an equation.
  std::size_t read_claim(Interval& claim, std::size_t equations);
  double read_multiplier();
  std::pair<EquationMultiple, double> read_multiple();
  GraphStrip read_strip();
  PositiveProduct read_product(std::string_view kind, std::size_t variables);
  std::pair<int, Monomial> signed_monomial(std::string_view text, std::size_t variables);
  Monomial monomial(std::string_view text, std::size_t variables);
  void read_row(std::string_view word);
  void read_expansion();
  void read_polytope();
  void open_cases();
  void open_other_case();
  void join_cases();
  void take_claim(std::size_t variable, const Interval& claim, const Range& proved);

  void end_node();
  void end_covered();
  void end_undecided();
  void end_counted();
  void end_cut();
  void open_box(std::uint64_t id, const Box& box);

  EnclosedRoot enclosed_root(const Box& box);
  bool is_accounted_for(const KnownRoot& known);
  static bool lies_in_any(const EnclosedRoot& root, const std::vector<Box>& boxes);
  bool violates_inequality(const RangeBox& root);
  bool satisfies_inequalities(const RangeBox& root);

  JudgedSystem* system_;
  const Box* search_box_;
  const ListedResult* listed_;
  ProofReader* reader_;
  RootProver prover_;
  StepJudge judge_;
  ReplaySummary summary_;
  std::vector<Box> undecided_;  ///< sorted
  std::vector<Box> starts_;
  bool theorem_covers_ = false;  ///< a theorem shows that the listed solutions are all
  std::unordered_map<std::uint64_t, Box> open_;
  std::unordered_map<std::uint64_t, KnownRoot> roots_;
  std::uint64_t next_id_ = 0;  ///< every id below was used
  Part part_;
  std::vector<Cases> cases_;
  std::vector<double> multipliers_;
};

}  // namespace gcslab::verifier
