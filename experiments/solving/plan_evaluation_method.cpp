// The method `plan_evaluation`: constraint systems that a construction plan solves outright
// (construction/plan_solver.h).

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "certification/root_certifier.h"
#include "construction/plan_solver.h"
#include "experiments/solving/path_settings.h"
#include "experiments/solving/plan_report.h"
#include "experiments/solving/solve_method.h"

namespace gcslab {
namespace {

void write_proof(ProofLog& proof, const PlanSolutions& found, const Box& search_box) {
  if (found.blocks.empty())
    throw NotApplicable(
        "no proof file is written where the plan starts from other points than the frame of the equations, "
        "or "
        "these are no polynomials in the coordinates; adaptive writes one");
  std::string theorem = "loci_intersection";
  for (const LociBlock& block : found.blocks) {
    theorem += fmt::format(" {} {} {}", block.unknowns.size(), fmt::join(block.unknowns, " "),
                           fmt::join(block.equations, " "));
  }
  proof.begin(search_box);
  proof.theorem(theorem);
  proof.finish();
}

SolveOutcome evaluate_plan(const SystemFunctions& functions, const SolveSettings& settings,
                           const std::optional<SearchStart>& start, const std::stop_token& stop,
                           SearchObserver*) {
  if (start) throw NotApplicable("plan_evaluation does not search, so that nothing is left to go on from");
  if (settings.geometry == nullptr) throw NotApplicable("only constraint systems have construction plans");
  const GeometricSource& source = *settings.geometry;
  const Options& options = settings.options;
  check_certifier(options.word("certifier"));
  const PlanSolutions found = solve_by_plan(
      source.system, source.frame, source.equations, source.system.valuation(source.valuation), functions,
      {.bits = static_cast<int>(options.integer("bits")),
       .maximum_bits = static_cast<int>(options.integer("maximum_bits")),
       .certifier = options.word("certifier"),
       .maximum_branches = static_cast<std::uint64_t>(options.integer("maximum_branches"))},
      stop);
  if (settings.proof != nullptr) write_proof(*settings.proof, found, functions.system().box);
  SolveOutcome outcome;
  for (const CertifiedRoot& root : found.roots) outcome.search.solutions.push_back(Solution{root});
  outcome.search.roots = found.roots;
  for (const UndecidedFigures& figures : found.undecided)
    outcome.search.undecided.push_back({figures.box, figures.reason});
  if (!found.is_finished) outcome.search.pending.push_back(functions.system().box);
  outcome.status = status_of(outcome.search, Promise::rigorous);
  outcome.completeness = "proved";
  outcome.steps = found.branches + found.empty_branches;
  outcome.plan = report_of(found.plan, source.system);
  outcome.plan->branches = found.branches;
  outcome.plan->empty_branches = found.empty_branches;
  return outcome;
}

}  // namespace

SolveMethod plan_evaluation_method() {
  return {
      "plan_evaluation",
      "constraint systems that a construction plan solves outright, without guide parameters: every branch "
      "over intervals, every root certified, nothing missing (the method of loci, LIM)",
      1,
      {integer_option("bits", "precision of the intervals at first", "bits", 128, 53, 100'000),
       integer_option("maximum_bits", "precision goes up to this where a branch is not decided", "bits", 1024,
                      53, 100'000),
       integer_option("maximum_branches", "work budget", "branches with a figure", 100'000, 1, 1'000'000'000),
       certifier_option()},
      evaluate_plan};
}

}  // namespace gcslab
