#include "verifier/verifier.h"

#include <nlohmann/json.hpp>

#include "base/content_hash.h"
#include "verifier/box_relations.h"
#include "verifier/result_judge.h"

namespace gcslab {
namespace {

using namespace verifier;

void replay(JudgedSystem& judged, const Box& search_box, const ListedResult& listed, const ProofText& proof,
            VerificationReport& report) {
  ProofReader reader(*proof.stream, proof.name);
  report.completeness_proved = false;  // a proof that is given has to hold by itself
  try {
    const ReplaySummary summary = ProofReplay(judged, search_box, listed, reader).run();
    for (const auto& [claim, count] : summary.counts) report.checked.push_back({"proof: " + claim, count});
    report.completeness_proved = summary.is_complete;
    if (!summary.is_complete) report.not_checked.push_back("completeness is not proved: " + summary.gap);
  } catch (const Refused& refused) {
    report.refusals.push_back({refused.where(), refused.what()});
  }
}

}  // namespace

VerificationReport verify(const EquationSystem& system, const Box& search_box, const nlohmann::json& result,
                          const std::optional<ProofText>& proof) {
  VerificationReport report;
  JudgedSystem judged(system);
  ResultJudge judge(system, search_box, judged, report);
  judge.judge(result);
  if (proof) replay(judged, search_box, judge.listed(), *proof, report);
  judge.judge_summary(result, proof.has_value());
  return report;
}

bool verify_root(const EquationSystem& system, const Box& box, const Box& uniqueness_box) {
  JudgedSystem judged(system);
  RootProver prover(judged);
  const std::optional<EnclosedRoot> root = prover.enclose(box);
  return root && is_subset(box, uniqueness_box) && prover.has_no_other(uniqueness_box, *root);
}

std::string result_hash(const nlohmann::json& result) {
  nlohmann::json content = result;
  if (content.is_object()) content.erase("content_hash");
  return content_hash(content.dump());
}

}  // namespace gcslab
