#include "experiments/tasks/reduction_task.h"

#include <algorithm>
#include <fmt/format.h>

#include "box_solver/contractor_registry.h"
#include "box_solver/polytope.h"
#include "experiments/corpus/corpus.h"
#include "experiments/corpus/problem.h"
#include "experiments/corpus/system_family.h"
#include "experiments/tasks/job_result.h"
#include "experiments/tasks/stopwatch.h"
#include "linear_program/lp_registry.h"

namespace gcslab {
namespace {

bool uses_tensors(const std::string& method) {
  return method == "bernstein_projection" || method == "mourrain_pavone";
}

std::vector<OptionSpec> options_of(const std::string& method) {
  if (method == "lp_reduction") {
    return {
        choice_option("lp", "the solver of linear programs", "simplex", lp_registry().names()),
        choice_option("lp_safety", "what is believed of its answers; tolerance and unprotected are baselines",
                      "dual", {"dual", "exact", "tolerance", "unprotected"})};
  }
  if (uses_tensors(method)) {
    return {integer_option("maximum_coefficients", "of the tensors of all equations; more are refused", "",
                           1 << 20, 1, 1 << 28)};
  }
  return {};
}

ContractorSettings settings_of(const Job& job) {
  ContractorSettings settings;
  const auto& values = job.options.values();
  if (values.contains("lp")) settings.lp = job.options.word("lp");
  if (values.contains("lp_safety")) settings.lp_safety = job.options.word("lp_safety");
  if (values.contains("maximum_coefficients"))
    settings.maximum_coefficients = static_cast<std::size_t>(job.options.integer("maximum_coefficients"));
  return settings;
}

Promise promise_of_options(const Options& options) {
  const auto safety = options.values().find("lp_safety");
  if (safety == options.values().end()) return Promise::rigorous;
  const std::string word = to_string(safety->second);
  return word == "tolerance" || word == "unprotected" ? Promise::baseline : Promise::rigorous;
}

/// Calls of one contractor on the same box until they take long enough to be timed.
struct TimedReduction {
  Box box;
  bool has_root = true;
  double wall_s = 0, cpu_s = 0;  ///< of one call
};

TimedReduction reduce(Contractor& contractor, const Box& whole) {
  constexpr double kLongEnough = 0.1;  // many ticks of a coarse processor clock
  const auto once = [&] {
    TimedReduction result{whole};
    ProofTrace trace;
    result.has_root = contractor.contract(result.box, trace);
    return result;
  };
  Stopwatch watch;
  TimedReduction result = once();  // makes what is made once for a system
  int calls = 1;
  for (int more = 1; watch.cpu_s() < kLongEnough; more *= 2) {
    if (more == 1) {
      watch = Stopwatch();
      calls = 0;
    }
    for (int i = 0; i < more; ++i) static_cast<void>(once());
    calls += more;
  }
  result.wall_s = watch.wall_s() / calls;
  result.cpu_s = watch.cpu_s() / calls;
  return result;
}

/// Sizes of the polytope's linear program and of the tensors: properties of the system.
void count_sizes(const SystemFunctions& functions, Json& values) {
  const ExpansionPlan plan(functions);
  const BernsteinPolytope polytope(plan);
  values["monomials"] = polytope.model().columns();
  values["constraints"] = polytope.model().rows();
  values["entries"] = polytope.model().entries();
  mpz_class coefficients = static_cast<unsigned long>(functions.equations().size());
  for (std::size_t i = 0; i < functions.variables(); ++i) coefficients *= 3;
  values["tensor_coefficients"] = coefficients.get_str();
}

bool keeps(const TimedReduction& reduction, const std::vector<Rational>& root) {
  if (!reduction.has_root) return false;
  for (std::size_t i = 0; i < root.size(); ++i) {
    const Interval& side = reduction.box[i];
    if (root[i] < rational_from_double(side.lower) || root[i] > rational_from_double(side.upper))
      return false;
  }
  return true;
}

/// The mean width of the sides over that before; three digits, which rounding does not reach.
std::string width_text(const Box& before, const Box& after) {
  double sum = 0;
  for (std::size_t i = 0; i < before.size(); ++i) sum += width(after[i]) / width(before[i]);
  return fmt::format("{:.3f}", sum / static_cast<double>(before.size()));
}

}  // namespace

std::string ReductionTask::summary() const {
  return "one reduction of a box by a contractor, as the unknowns grow in number";
}

std::vector<MethodInfo> ReductionTask::methods() const {
  std::vector<MethodInfo> methods;
  for (const ContractorVariant& variant : contractor_registry().entries()) {
    methods.push_back(
        {variant.name, variant.summary, Promise::rigorous, 1, options_of(variant.name), promise_of_options});
  }
  return methods;
}

std::vector<OptionSpec> ReductionTask::parameters() const {
  return {integer_option("unknowns", "unknowns and equations of the member of the family", "", 5, 2, 500)};
}

std::vector<ValueInfo> ReductionTask::values() const {
  return {{"monomials", "columns of the linear program: monomials other than 1"},
          {"constraints", "rows of the linear program"},
          {"entries", "nonzero coefficients of its rows"},
          {"tensor_coefficients", "Bernstein coefficients of all equations, n times 3 to the power n"},
          {"width", "mean width of the sides after the reduction, over that before"},
          {"keeps_root", "1 when the planted root is in the reduced box"}};
}

std::vector<std::string> ReductionTask::problem_kinds() const { return {kSystemFamilyKind}; }

void ReductionTask::check(const Job& job) const {
  const auto path = Corpus::standard().problem_path(job.problem);
  if (kind_of_file(path) != kSystemFamilyKind)
    throw InputError(path.string() + ": the task reduction takes problems of kind system_family");
  check_system_family(path);
}

JobResult ReductionTask::run(const Job& job, const std::stop_token&) const {
  const Stopwatch preparation;
  const FamilyMember member =
      load_family_member(Corpus::standard().problem_path(job.problem),
                         static_cast<int>(job.parameters.integer("unknowns")), job.seed);
  const SystemFunctions functions(member.system);
  const auto contractor = contractor_registry().at(job.method).make(functions, settings_of(job));
  JobResult result;
  result.timings["prepare_s"] = preparation.wall_s();
  const TimedReduction reduction = reduce(*contractor, functions.system().box);
  result.timings["wall_s"] = reduction.wall_s;
  result.timings["cpu_s"] = reduction.cpu_s;
  count_sizes(functions, result.values);
  const bool kept = keeps(reduction, member.root);
  result.values["keeps_root"] = kept ? 1 : 0;
  if (reduction.has_root) result.values["width"] = width_text(functions.system().box, reduction.box);
  const Promise promise = promise_of_options(job.options);
  result.status = promise == Promise::rigorous ? Status::complete : Status::partial;
  if (!kept && promise == Promise::rigorous) {
    result.status = Status::failed;
    result.reason = "the reduced box does not hold the planted root";
  }
  return result;
}

}  // namespace gcslab
