#pragma once

// Judges what a result file lists: certificates, points, inequalities, and the words that sum it up.
//
// The roots of one polynomial in one variable are counted exactly (root_counter.h): that proves
// multiplicities, and that nothing is missing, without a proof file.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "verifier/json_place.h"
#include "verifier/miranda.h"
#include "verifier/proof_replay.h"
#include "verifier/root_counter.h"
#include "verifier/verifier.h"

namespace gcslab::verifier {

class ResultJudge {
 public:
  /// All must outlive it.
  ResultJudge(const EquationSystem& system, const Box& search_box, JudgedSystem& judged,
              VerificationReport& report);

  /// Judges everything but completeness. What is refused goes to the report.
  void judge(const nlohmann::json& result);
  /// What the proof may refer to.
  const ListedResult& listed() const { return listed_; }
  /// Judges the words `status` and `completeness`, after the proof was replayed when there is one.
  void judge_summary(const nlohmann::json& result, bool has_proof);

 private:
  /// What the file says of a solution and what was proved.
  struct Solution {
    Box box;
    std::string claim;
    std::optional<EnclosedRoot> root;  ///< a regular one
  };

  template <class Judgement>
  void attempt(Judgement judgement);
  void count(const std::string& claim) { ++counts_[claim]; }

  void judge_hash(const JsonPlace& result);
  void judge_variables(const JsonPlace& result);
  void judge_solution(const JsonPlace& place);
  void judge_complex(const JsonPlace& place);
  void judge_certificate(const JsonPlace& place, Solution& solution);
  std::optional<EnclosedRoot> enclosed_root(const Box& box);
  bool has_no_other(const Box& box, const EnclosedRoot& root);
  void judge_all_evidence(const JsonPlace& list, const Solution& solution);
  std::string judge_evidence(const JsonPlace& evidence, const Solution& solution);
  void judge_multiplicity(const JsonPlace& place, const Solution& solution);
  void judge_point(const JsonPlace& place, const Solution& solution);
  void judge_residual(const JsonPlace& residual, const std::vector<double>& point);
  void judge_inequalities(const JsonPlace& place, const Solution& solution);
  /// Where its root is known to lie.
  static RangeBox place_of(const Solution& solution);
  void judge_distinct(const JsonPlace& solutions);
  void judge_undecided(const JsonPlace& place);
  void count_roots();
  void note_unchecked(const JsonPlace& result);

  const EquationSystem* system_;
  const Box* search_box_;
  JudgedSystem* judged_;
  VerificationReport* report_;
  RootProver prover_;
  std::optional<RootCounter> counter_;  ///< of one polynomial in one variable
  Miranda miranda_;
  ListedResult listed_;
  std::vector<Solution> solutions_;
  std::map<std::string, std::uint64_t> counts_;
};

}  // namespace gcslab::verifier
