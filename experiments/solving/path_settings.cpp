#include "experiments/solving/path_settings.h"

#include <algorithm>
#include <utility>

#include "experiments/solving/sketch_source.h"
#include "homotopy/predictor.h"

namespace gcslab {
namespace {

CorrectorKind corrector_kind(const std::string& name) {
  if (name == "newton") return CorrectorKind::newton;
  return name == "normal_flow" ? CorrectorKind::normal_flow : CorrectorKind::chord;
}

}  // namespace

std::vector<OptionSpec> homotopy_option_specs() {
  return {
      choice_option("interpolation", "of the parameters between the sketch and what is wanted", "linear",
                    {"linear", "compact_support"}),
      choice_option(
          "booleans",
          "constraints without a parameter: hold at t = 1 only, and in a sketch that nearly satisfies "
          "them at t = 0 (perturbed); at t = 0 in any sketch, which is moved there (projected); or all "
          "along (kept)",
          "perturbed", {"perturbed", "projected", "kept"}),
      real_option("leading", "of the perturbation (1 - t) t, in sizes of the sketch", "", 0.1, -1e3, 1e3)};
}

std::vector<OptionSpec> tracker_option_specs(const TrackerDefaults& defaults) {
  return {choice_option("predictor", "where the path is looked for", defaults.predictor,
                        predictor_registry().names()),
          choice_option("corrector", "Newton's method back to the path", defaults.corrector,
                        {"chord", "newton", "normal_flow"}),
          choice_option("step_control", "how long steps are", defaults.step_control, {"adaptive", "fixed"}),
          real_option("first_step", "length of the first step, and of fixed ones",
                      "in sizes of the sketch and t", defaults.first_step, 1e-12, 1e6),
          real_option("largest_step", "no step is longer; far from the origin in proportion", "", 0.5, 1e-12,
                      1e6),
          real_option("tolerance", "of the last correction of a point, relative to its size", "",
                      defaults.tolerance, 1e-14, 1e-2),
          integer_option("corrections", "of a point, at most", "", 8, 1, 1000),
          real_option("deviation", "error of a prediction that is aimed at, as part of the step", "", 0.02,
                      1e-6, 1),
          real_option("largest_turn", "of the tangent in one step", "radians", 0.4, 1e-3, 1.5),
          real_option("infinity", "where a path is given up as going there", "sizes of the sketch", 1e5, 10,
                      1e12),
          integer_option("maximum_steps", "work budget", "steps", 1'000'000, 1, 1'000'000'000)};
}

OptionSpec certifier_option() {
  return {"certifier", "what proves solutions: names of theorems, joined by +",
          std::string("krawczyk_slopes+kantorovich")};
}

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
  return result;
}

PathObserver StepClock::observer(PathObserver next) {
  return [this, next = std::move(next)](const PathState& state) {
    const auto now = std::chrono::steady_clock::now();
    if (state.path.steps > 1) seconds_.push_back(std::chrono::duration<double>(now - last_).count());
    if (next) next(state);
    last_ = std::chrono::steady_clock::now();
  };
}

std::optional<double> StepClock::median_s() {
  if (seconds_.empty()) return std::nullopt;
  const auto middle = seconds_.begin() + std::ssize(seconds_) / 2;
  std::ranges::nth_element(seconds_, middle);
  return *middle;
}

PathObserver Tracer::observer() {
  return settings_->traced_points > 0 ? trace_.observer() : settings_->path_observer;
}

std::optional<TracedPath> Tracer::traced(const Path& path, const std::vector<double>& start,
                                         bool is_to_first_crossing) {
  if (settings_->traced_points == 0) return std::nullopt;
  if (path.end == PathEnd::cycle) trace_.end_at(start);
  if (is_to_first_crossing && !path.crossings.empty()) trace_.end_at(path.crossings.front().v);
  return traced_path(trace_, path, *curve_, *equations_, settings_->traced_points);
}

bool is_given_up(const Path& path) {
  const auto is = [](PathEnd end) { return end == PathEnd::budget || end == PathEnd::stuck; };
  return is(path.end) || is(path.other_end);
}

SolveOutcome outcome_of(FollowedPath followed, bool is_to_first_crossing) {
  SolveOutcome outcome;
  for (const SketchSolution& solution : followed.found.solutions) {
    followed.numbers.push_back(outcome.search.solutions.size());
    outcome.search.solutions.push_back(found_solution(solution.unknowns, solution.root));
  }
  const Path& path = followed.found.path;
  const bool is_asked_for = is_to_first_crossing && !path.crossings.empty();
  outcome.status = !is_asked_for && is_given_up(path) ? Status::budget_exhausted : Status::partial;
  outcome.steps = path.steps;
  outcome.paths.push_back(std::move(followed));
  return outcome;
}

}  // namespace gcslab
