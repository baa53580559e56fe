// Methods that follow the homotopy path of a constraint system's sketch: settings of one tracker.

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/error.h"
#include "certification/root_certifier.h"
#include "experiments/solving/sketch_source.h"
#include "experiments/solving/solve_method.h"
#include "geometry/degrees_of_freedom.h"
#include "geometry/sketch.h"
#include "homotopy/path_certifier.h"
#include "homotopy/path_explanation.h"
#include "homotopy/precise_homotopy.h"
#include "homotopy/predictor.h"
#include "homotopy/sketch_solver.h"

namespace gcslab {
namespace {

CorrectorKind corrector_kind(const std::string& name) {
  if (name == "newton") return CorrectorKind::newton;
  return name == "normal_flow" ? CorrectorKind::normal_flow : CorrectorKind::chord;
}

/// `extent`: how large figures on the way are, in sizes of the sketch.
TrackerOptions tracker_options(const Options& options, double extent) {
  TrackerOptions result;
  result.predictor = options.word("predictor");
  result.corrector = {corrector_kind(options.word("corrector")), options.real("tolerance"),
                      static_cast<int>(options.integer("corrections"))};
  result.step_control = options.word("step_control") == "fixed" ? StepControl::fixed : StepControl::adaptive;
  result.first_step = options.real("first_step");
  result.largest_step = options.real("largest_step");
  result.largest_turn = options.real("largest_turn");
  result.deviation = options.real("deviation");
  result.infinity = options.real("infinity") * extent;
  result.maximum_steps = static_cast<std::uint64_t>(options.integer("maximum_steps"));
  result.stops_at_first_crossing = options.word("until") == "first_crossing";
  return result;
}

SketchHomotopyOptions homotopy_options(const Options& options) {
  SketchHomotopyOptions result;
  if (options.word("interpolation") == "compact_support")
    result.interpolation = Interpolation::compact_support;
  const std::string& booleans = options.word("booleans");
  if (booleans == "projected") result.booleans = Booleans::projected;
  if (booleans == "kept") result.booleans = Booleans::kept;
  result.leading = options.real("leading");
  const std::string& linear_algebra = options.word("linear_algebra");
  if (linear_algebra == "dense") result.linear_algebra = LinearAlgebra::dense;
  if (linear_algebra == "sparse") result.linear_algebra = LinearAlgebra::sparse;
  return result;
}

/// How long the steps of a path take. Moments are noted after each.
class StepClock {
 public:
  PathObserver observer(PathObserver next) {
    return [this, next = std::move(next)](const PathState& state) {
      const auto now = std::chrono::steady_clock::now();
      if (state.path.steps > 1) seconds_.push_back(std::chrono::duration<double>(now - last_).count());
      if (next) next(state);
      last_ = std::chrono::steady_clock::now();
    };
  }

  /// Nothing before the second step.
  std::optional<double> median_s() {
    if (seconds_.empty()) return std::nullopt;
    const auto middle = seconds_.begin() + std::ssize(seconds_) / 2;
    std::ranges::nth_element(seconds_, middle);
    return *middle;
  }

 private:
  std::chrono::steady_clock::time_point last_;
  std::vector<double> seconds_;
};

/// Notes the path while it is followed, where a trace is asked for.
class Tracer {
 public:
  Tracer(const SolveSettings& settings, const SketchHomotopy& homotopy, const GeometricEquations& equations)
      : settings_(settings), homotopy_(homotopy), equations_(equations) {}

  PathObserver observer() {
    return settings_.traced_points > 0 ? trace_.observer() : settings_.path_observer;
  }

  std::optional<TracedPath> traced(const Path& path) {
    if (settings_.traced_points == 0) return std::nullopt;
    if (path.end == PathEnd::cycle) trace_.end_at(homotopy_.start());
    if (settings_.options.word("until") == "first_crossing" && !path.crossings.empty())
      trace_.end_at(path.crossings.front().v);
    return traced_path(trace_, path, homotopy_.curve(), equations_, settings_.traced_points);
  }

 private:
  const SolveSettings& settings_;
  const SketchHomotopy& homotopy_;
  const GeometricEquations& equations_;
  PathTrace trace_;
};

SolveOutcome solve_along_sketch(const SystemFunctions& functions, const SolveSettings& settings,
                                const std::optional<SearchStart>&, const std::stop_token& stop,
                                SearchObserver*) {
  const auto [geometry, sketch] = sketch_source(settings);
  const ConstraintSystem& system = geometry.system;
  const GeometricEquations& equations = geometry.equations;
  const Options& options = settings.options;
  if (!functions.is_square())
    throw NotApplicable(balance_text(equations) + "; " +
                        structure_text(system, structural_diagnosis(equations)));
  const std::string& certifier = options.word("certifier");
  check_certifier(certifier);
  SketchHomotopy homotopy(system, geometry.frame, equations, values_of(system.valuation(geometry.valuation)),
                          sketch, homotopy_options(options));
  std::unique_ptr<Curve> differences;
  if (options.word("derivatives") == "forward_differences")
    differences = with_forward_differences(homotopy.curve());
  Curve& curve = differences ? *differences : homotopy.curve();
  PreciseHomotopy precise(equations, homotopy.curve());
  const bool is_precise = options.word("precision") == "rising";
  const bool is_certified = options.word("proof") == "tubes";
  if (is_certified && settings.path_from != nullptr)
    throw NotApplicable(
        "a proof does not go on from where a path was stopped: start again, or say proof=none");
  std::optional<IntervalHomotopy> enclosure;
  std::optional<PathCertifier> path_certifier;
  if (is_certified) {
    enclosure.emplace(equations, homotopy.curve());
    path_certifier.emplace(homotopy.curve(), *enclosure);
  }
  Tracer tracer(settings, homotopy, equations);
  StepClock clock;
  FollowedPath followed{
      solve_along_path(homotopy.curve(), curve, homotopy.start(), functions,
                       tracker_options(options, homotopy.extent() / homotopy.unit()), certifier, stop,
                       {clock.observer(tracer.observer()), settings.path_from,
                        path_certifier ? &*path_certifier : nullptr, is_precise ? &precise : nullptr}),
      {}};
  followed.step_s = clock.median_s();
  followed.trace = tracer.traced(followed.found.path);
  followed.explanation = explain(followed.found.path, system, equations, homotopy);
  SolveOutcome outcome;
  for (const SketchSolution& solution : followed.found.solutions)
    outcome.search.solutions.push_back(found_solution(solution.unknowns, solution.root));
  const auto is_given_up = [](PathEnd end) { return end == PathEnd::budget || end == PathEnd::stuck; };
  const Path& path = followed.found.path;
  const bool is_asked_for = options.word("until") == "first_crossing" && !path.crossings.empty();
  outcome.status = !is_asked_for && (is_given_up(path.end) || is_given_up(path.other_end))
                       ? Status::budget_exhausted
                       : Status::partial;
  outcome.steps = path.steps;
  outcome.paths.push_back(std::move(followed));
  return outcome;
}

/// What the methods that follow the sketch's path differ in.
struct Defaults {
  std::string predictor = "hermite";
  std::string corrector = "chord";
  std::string step_control = "adaptive";
  std::string derivatives = "tape";
  std::string until = "end";
  std::string proof = "none";
  std::string precision = "rising";
  double first_step = 0.01;
  double tolerance = 1e-6;
};

SolveMethod path_method(std::string name, std::string summary, const Defaults& defaults) {
  return {
      std::move(name),
      std::move(summary),
      3,
      {choice_option("interpolation", "of the parameters between the sketch and what is wanted", "linear",
                     {"linear", "compact_support"}),
       choice_option(
           "booleans",
           "constraints without a parameter: hold at t = 1 only, and in a sketch that nearly satisfies "
           "them at t = 0 (perturbed); at t = 0 in any sketch, which is moved there (projected); or all "
           "along (kept)",
           "perturbed", {"perturbed", "projected", "kept"}),
       real_option("leading", "of the perturbation (1 - t) t, in sizes of the sketch", "", 0.1, -1e3, 1e3),
       random_sketch_option(),
       choice_option("predictor", "where the path is looked for", defaults.predictor,
                     predictor_registry().names()),
       choice_option("corrector", "Newton's method back to the path", defaults.corrector,
                     {"chord", "newton", "normal_flow"}),
       choice_option("linear_algebra",
                     "factors of Jacobians; automatic: dense below " + std::to_string(Homotopy::kSparseFrom) +
                         " unknowns, else sparse",
                     "automatic", {"automatic", "dense", "sparse"}),
       choice_option("derivatives", "how they are computed", defaults.derivatives,
                     {"tape", "forward_differences"}),
       choice_option("step_control", "how long steps are", defaults.step_control, {"adaptive", "fixed"}),
       real_option("first_step", "length of the first step, and of fixed ones",
                   "in sizes of the sketch and t", defaults.first_step, 1e-12, 1e6),
       real_option("largest_step", "no step is longer; far from the origin in proportion", "", 0.5, 1e-12,
                   1e6),
       real_option("tolerance", "of the last correction of a point, relative to its size", "",
                   defaults.tolerance, 1e-14, 1e-2),
       integer_option("corrections", "of a point, at most", "", 8, 1, 1000),
       real_option("deviation", "error of a prediction that is aimed at, as part of the step", "", 0.02, 1e-6,
                   1),
       real_option("largest_turn", "of the tangent in one step", "radians", 0.4, 1e-3, 1.5),
       real_option("infinity", "where a path is given up as going there", "sizes of the sketch", 1e5, 10,
                   1e12),
       integer_option("maximum_steps", "work budget", "steps", 1'000'000, 1, 1'000'000'000),
       choice_option("until", "what is followed", defaults.until, {"end", "first_crossing"}),
       choice_option("precision", "of values where only small steps succeed: 128 bits, or doubles everywhere",
                     defaults.precision, {"rising", "double"}),
       choice_option("proof", "that the path stays on one curve: a chain of tubes, or nothing",
                     defaults.proof, {"none", "tubes"}),
       OptionSpec{"certifier", "what proves solutions: names of theorems, joined by +",
                  std::string("krawczyk_slopes+kantorovich")}},
      solve_along_sketch,
      Promise::rigorous,
      {},
      "follows a path",
      true};
}

}  // namespace

std::vector<SolveMethod> sketch_path_methods() {
  return {
      path_method("sketch_path",
                  "constraint systems: the homotopy path of the sketch, followed as a whole; each crossing "
                  "of t = 1 is a solution (Imbach 2013)",
                  {}),
      path_method("sketch_path_as_published",
                  "the same with the tracker of Imbach 2013: tangent, fixed steps (halved for the whole "
                  "path where one fails), Newton's method, forward differences",
                  {"euler", "newton", "fixed", "forward_differences", "end", "none", "double", 0.1, 1e-10}),
      path_method("certified_sketch_path",
                  "the same with a proof, by a chain of tubes in outward rounded arithmetic, that the path "
                  "stays on one curve between branch points (Kearfott, Xing 1994)",
                  {.proof = "tubes"}),
      path_method("sketch_first_crossing",
                  "the same path as far as its first solution (Lamure, Michelucci 1996)",
                  {.until = "first_crossing"})};
}

}  // namespace gcslab
