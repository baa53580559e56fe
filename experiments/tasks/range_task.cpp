#include "experiments/tasks/range_task.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "base/random.h"
#include "enclosure/bound_registry.h"
#include "enclosure/scoped_evaluator.h"
#include "experiments/corpus/problem.h"
#include "experiments/corpus/problem_loader.h"
#include "experiments/corpus/random_polynomial.h"
#include "experiments/tasks/bound_methods.h"
#include "experiments/tasks/job_result.h"
#include "experiments/tasks/stopwatch.h"
#include "interval/fast_interval.h"
#include "polynomial/horner.h"

namespace gcslab {
namespace {

/// A call is repeated until it has taken this long, so that short ones can be timed.
constexpr double kMeasuredSeconds = 0.005;

/// A member of a family: a random polynomial on a box around a random centre in [-1, 1]^n.
Problem family_member(const Problem& family, const Job& job) {
  const int degree = static_cast<int>(job.parameters.integer("degree"));
  const int dimension = static_cast<int>(job.parameters.integer("dimension"));
  if (degree < 1 || dimension < 1) {
    throw InputError("problem " + job.problem +
                     " is a family: the parameters degree and dimension must be given");
  }
  Problem member = family;
  member.system = {};
  for (int i = 0; i < dimension; ++i) member.system.variables.push_back(fmt::format("x{}", i + 1));
  const Polynomial polynomial = random_polynomial({dimension, degree, "kostlan", job.seed});
  member.system.equations = {horner_form(polynomial, *member.system.graph)};
  Random random(job.seed, "range_task_box");
  const double half_width = job.parameters.real("width") / 2;
  for (int i = 0; i < dimension; ++i) {
    const double centre = random.uniform(-1, 1);
    member.system.box.emplace_back(centre - half_width, centre + half_width);
  }
  return member;
}

Problem problem_of(const Job& job) {
  Problem problem = load_problem_of_kind(job.problem, {"function", "curve", "surface", "polynomial_family"});
  return problem.kind == "polynomial_family" ? family_member(problem, job) : problem;
}

/// A part of the range that f surely takes: hull of values at the corners and at random points.
Interval sampled_range(const Problem& problem, const Job& job) {
  constexpr int kSamples = 2000;
  const Box& box = problem.system.box;
  ScopedEvaluator<FastInterval> evaluator(problem.system.equations, static_cast<int>(box.size()), 53);
  const auto scope = evaluator.open();
  Random random(job.seed, "range_task_samples");
  Interval range;
  Box point(box.size());
  for (int sample = 0; sample < kSamples; ++sample) {
    for (std::size_t i = 0; i < box.size(); ++i) {
      const bool corner = sample >> box.size() == 0;
      point[i] = corner ? ((sample >> i & 1) != 0 ? box[i].upper : box[i].lower)
                        : random.uniform(box[i].lower, box[i].upper);
    }
    const Interval value = NumberTraits<FastInterval>::enclosure(evaluator.at(point).value());
    if (!is_empty(value)) range = hull(range, {value.upper, value.upper});
    if (!is_empty(value)) range = hull(range, {value.lower, value.lower});
  }
  return range;
}

std::string number_text(double value) { return fmt::format("{}", value); }

/// Wall and CPU seconds of one call.
void measure(RangeBound& bound, const Box& box, JobResult& result, const std::stop_token& stop) {
  int calls = 0;
  const Stopwatch watch;
  do {
    static_cast<void>(bound.over(box));
    ++calls;
  } while (watch.wall_s() < kMeasuredSeconds && !stop.stop_requested());
  result.timings["wall_s"] = watch.wall_s() / calls;
  result.timings["cpu_s"] = watch.cpu_s() / calls;
}

/// The graph of a function of one variable, for figures.
Json graph_samples(const Problem& problem) {
  constexpr int kSteps = 200;
  const Interval& side = problem.system.box.front();
  const Tape tape(problem.system.equations.front(), 1);
  TapeEvaluator<double> evaluator(tape);
  Json samples = Json::array();
  for (int i = 0; i <= kSteps; ++i) {
    const double x = side.lower + (side.upper - side.lower) * i / kSteps;
    evaluator.evaluate(std::array{x});
    samples.push_back({x, evaluator.value()});
  }
  return samples;
}

}  // namespace

std::string RangeTask::summary() const { return "bounds of the range of a function over its box"; }

std::vector<MethodInfo> RangeTask::methods() const { return bound_methods(); }

std::vector<OptionSpec> RangeTask::parameters() const {
  return {
      integer_option("degree", "total degree of a member of a family; 0 for other problems", "", 0, 0, 60),
      integer_option("dimension", "variables of a member of a family; 0 for other problems", "", 0, 0, 10),
      real_option("width", "width of the box of a member of a family", "", 0.5, 1e-6, 10)};
}

std::vector<ValueInfo> RangeTask::values() const {
  return {{"lower", "lower end of the bound"},
          {"upper", "upper end of the bound"},
          {"exact_lower",
           "lower end of the range, to the tolerance of the method exact; polynomials in 1 or 2 variables"},
          {"exact_upper", "upper end of the same"},
          {"overestimation", "width of the bound over the width of values that f takes at sampled points"}};
}

std::vector<std::string> RangeTask::problem_kinds() const {
  return {"function", "curve", "surface", "polynomial_family"};
}

void RangeTask::check(const Job& job) const { static_cast<void>(problem_of(job)); }

JobResult RangeTask::run(const Job& job, const std::stop_token& stop) const {
  const Problem problem = problem_of(job);
  const Box& box = problem.system.box;
  JobResult result;
  const Stopwatch preparation;
  const auto bounds = make_bounds(problem, job.method, job.options);
  result.timings["prepare_s"] = preparation.wall_s();
  const Interval range = bounds.equations.front()->over(box);
  measure(*bounds.equations.front(), box, result, stop);
  result.values["lower"] = number_text(range.lower);
  result.values["upper"] = number_text(range.upper);
  const Interval sampled = sampled_range(problem, job);
  result.values["overestimation"] = fmt::format("{:.4g}", width(range) / width(sampled));
  if (box.size() <= 2 && problem.targets().front().is_polynomial() && problem.kind != "polynomial_family") {
    const Interval exact =
        make_bounds(problem, "exact", Options(bound_registry().at("exact").options, {}, "exact"))
            .equations.front()
            ->over(box);
    result.values["exact_lower"] = number_text(exact.lower);
    result.values["exact_upper"] = number_text(exact.upper);
  }
  if (box.size() == 1) result.artifact = {{"graph", graph_samples(problem)}};
  const bool rigorous = bound_registry().at(job.method).promise(job.options) == Promise::rigorous;
  result.status = rigorous ? Status::complete : Status::partial;
  return result;
}

}  // namespace gcslab
