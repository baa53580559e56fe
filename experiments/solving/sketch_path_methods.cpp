// Methods that follow the homotopy path of a constraint system's sketch: settings of one tracker.

#include "base/error.h"
#include "certification/root_certifier.h"
#include "experiments/solving/path_settings.h"
#include "experiments/solving/sketch_source.h"
#include "experiments/solving/solve_method.h"
#include "geometry/degrees_of_freedom.h"
#include "geometry/sketch.h"
#include "homotopy/path_certifier.h"
#include "homotopy/path_explanation.h"
#include "homotopy/precise_homotopy.h"
#include "homotopy/sketch_solver.h"

namespace gcslab {
namespace {

LinearAlgebra linear_algebra(const Options& options) {
  const std::string& name = options.word("linear_algebra");
  if (name == "dense") return LinearAlgebra::dense;
  return name == "sparse" ? LinearAlgebra::sparse : LinearAlgebra::automatic;
}

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
  SketchHomotopyOptions deforming = homotopy_options(options);
  deforming.linear_algebra = linear_algebra(options);
  SketchHomotopy homotopy(system, geometry.frame, equations, values_of(system.valuation(geometry.valuation)),
                          sketch, deforming);
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
  Tracer tracer(settings, homotopy.curve(), equations);
  StepClock clock;
  const bool is_to_first_crossing = options.word("until") == "first_crossing";
  TrackerOptions tracking = tracker_options(options, homotopy.extent() / homotopy.unit());
  tracking.stops_at_first_crossing = is_to_first_crossing;
  FollowedPath followed{
      solve_along_path(homotopy.curve(), curve, homotopy.start(), functions, tracking, certifier, stop,
                       {clock.observer(tracer.observer()), settings.path_from,
                        path_certifier ? &*path_certifier : nullptr, is_precise ? &precise : nullptr}),
      {}};
  followed.step_s = clock.median_s();
  followed.trace = tracer.traced(followed.found.path, homotopy.start(), is_to_first_crossing);
  followed.explanation = explain(followed.found.path, system, equations, homotopy.curve(), homotopy.extent());
  return outcome_of(std::move(followed), is_to_first_crossing);
}

/// What the methods that follow the sketch's path differ in.
struct Defaults {
  TrackerDefaults tracker{};
  std::string derivatives = "tape";
  std::string until = "end";
  std::string proof = "none";
  std::string precision = "rising";
};

std::vector<OptionSpec> option_specs(const Defaults& defaults) {
  std::vector<OptionSpec> specs = homotopy_option_specs();
  const auto add = [&](const std::vector<OptionSpec>& more) {
    specs.insert(specs.end(), more.begin(), more.end());
  };
  add({random_sketch_option()});
  add(tracker_option_specs(defaults.tracker));
  add({choice_option("linear_algebra",
                     "factors of Jacobians; automatic: dense below " + std::to_string(Homotopy::kSparseFrom) +
                         " unknowns, else sparse",
                     "automatic", {"automatic", "dense", "sparse"}),
       choice_option("derivatives", "how they are computed", defaults.derivatives,
                     {"tape", "forward_differences"}),
       choice_option("until", "what is followed", defaults.until, {"end", "first_crossing"}),
       choice_option("precision", "of values where only small steps succeed: 128 bits, or doubles everywhere",
                     defaults.precision, {"rising", "double"}),
       choice_option("proof", "that the path stays on one curve: a chain of tubes, or nothing",
                     defaults.proof, {"none", "tubes"}),
       certifier_option()});
  return specs;
}

SolveMethod path_method(std::string name, std::string summary, const Defaults& defaults) {
  return {std::move(name),
          std::move(summary),
          5,
          option_specs(defaults),
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
                  {.tracker = {"euler", "newton", "fixed", 0.1, 1e-10},
                   .derivatives = "forward_differences",
                   .precision = "double"}),
      path_method("certified_sketch_path",
                  "the same with a proof, by a chain of tubes in outward rounded arithmetic, that the path "
                  "stays on one curve between branch points (Kearfott, Xing 1994)",
                  {.proof = "tubes"}),
      path_method("sketch_first_crossing",
                  "the same path as far as its first solution (Lamure, Michelucci 1996)",
                  {.until = "first_crossing"})};
}

}  // namespace gcslab
