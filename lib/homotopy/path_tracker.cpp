#include "homotopy/path_tracker.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "homotopy/charted_curve.h"
#include "homotopy/critical_point.h"
#include "homotopy/level_crossing.h"
#include "homotopy/path_certifier.h"
#include "homotopy/predictor.h"
#include "homotopy/smooth_step.h"

namespace gcslab {
namespace {

/// The curve was left, or a fixed step is too long: thrown to start again with smaller steps.
struct Jump {
  Path path;  ///< so far
};

/// What works on points of a curve of that size.
struct Tools {
  Tools(Curve& curve, const TrackerOptions& options, Curve* precise)
      : predictor(predictor_registry().at(options.predictor).make(curve)),
        corrector(curve, corrector_options(options)),
        exact_corrector(curve, {CorrectorKind::newton, 1e-12}),
        smooth_step(curve),
        precise_corrector(precise == nullptr ? curve : *precise, {CorrectorKind::newton, 1e-13}),
        at_here(curve),
        at_next(curve) {}

  static CorrectorOptions corrector_options(const TrackerOptions& options) {
    CorrectorOptions result = options.corrector;
    result.is_polished_after = options.step_control == StepControl::adaptive;
    return result;
  }

  std::unique_ptr<Predictor> predictor;
  Corrector corrector;
  Corrector exact_corrector;
  SmoothStep smooth_step;
  Corrector precise_corrector;
  TangentSolver at_here, at_next;
};

class Tracker {
 public:
  Tracker(Curve& curve, const std::vector<double>& start, const TrackerOptions& options,
          const std::stop_token& stop, const PathAids& aids)
      : curve_(&curve),
        options_(&options),
        stop_(stop),
        aids_(&aids),
        certifier_(aids.certifier),
        tools_(curve, options, aids.precise),
        start_(starting_point(curve, start)) {}

  Path follow(const PathState* from) {
    if (from != nullptr) {
      state_ = *from;
      if (!tools_.at_here.find(state_.here, std::vector(state_.here.tangent)))
        throw NotApplicable("the state to go on from is on no path of this problem");
    } else {
      set_out(1);
    }
    if (state_.direction > 0) {
      const PathEnd end = run();
      Path& path = state_.path;
      path.end = path.other_end = end;
      path.last = path.other_last = chartless(end == PathEnd::cycle ? start_.v : state_.here.v);
      if (end == PathEnd::cycle || end == PathEnd::budget) return std::move(path);
      set_out(-1);
    }
    state_.path.other_end = run();
    state_.path.other_last = chartless(state_.here.v);
    return std::move(state_.path);
  }

 private:
  void set_out(int direction) {
    if (aids_->charts != nullptr && state_.path.chart_changes > 0) {
      start_ = starting_point(*curve_, aids_->charts->begin());
      tools_ = Tools(*curve_, *options_, aids_->precise);
      is_start_in_chart_ = true;
    }
    state_.direction = direction;
    state_.here = start_;
    if (direction < 0) {
      for (double& x : state_.here.tangent) x = -x;
    }
    const std::vector<double> border = state_.here.tangent;
    tools_.at_here.find(state_.here, border);
    state_.before.reset();
    state_.step = options_->first_step;
    state_.length = 0;
    state_.landmark = state_.here;
    state_.steps_to_next_landmark = 1;
    if (certifier_ != nullptr && !certifier_->begin(state_.here))
      throw NotApplicable("nothing can be proved at the sketch: it is nearly singular");
  }

  PathEnd run() {
    const Path& path = state_.path;
    while (path.steps < options_->maximum_steps && !stop_.stop_requested()) {
      if (!attempt() && !(options_->step_control == StepControl::fixed && steps_across_a_level())) {
        ++state_.path.refused;
        if (options_->step_control == StepControl::fixed) throw Jump{std::move(state_.path)};
        state_.step /= 2;
        if (state_.step < kSmallStep && !is_exact_) improve_here();
        if (state_.step >= options_->least_step) continue;
        if (!has_moved_ || !goes_on_in_other_chart(true)) return where_no_step_succeeds();
        has_moved_ = false;
        state_.step = options_->first_step;
        continue;
      }
      const std::optional<PathEnd> end = accept();
      if (aids_->observer) aids_->observer(state_);
      if (end) return *end;
      has_moved_ = true;
      goes_on_in_other_chart(false);
    }
    return PathEnd::budget;
  }

  /// Takes the current point over to a better chart; whether there is one.
  bool goes_on_in_other_chart(bool is_stuck) {
    constexpr double kAhead = 1e-6;
    ChartedCurve* const charts = aids_->charts;
    std::vector<double> ahead = state_.here.v;
    if (charts == nullptr || !charts->change_at(ahead, is_stuck)) return false;
    for (std::size_t i = 0; i < ahead.size(); ++i) ahead[i] += kAhead * state_.here.tangent[i];
    CurvePoint moved{charts->carried_over(state_.here.v), {}};
    ahead = charts->carried_over(ahead);
    for (std::size_t i = 0; i < ahead.size(); ++i) ahead[i] -= moved.v[i];
    tools_ = Tools(*curve_, *options_, aids_->precise);
    ++state_.path.chart_changes;
    if (!tools_.at_here.find(moved, ahead)) throw Jump{std::move(state_.path)};
    tools_.exact_corrector.correct(CurvePoint(moved), tools_.at_here.matrix(), state_.step, moved.v);
    state_.here = state_.landmark = std::move(moved);
    state_.steps_to_next_landmark = state_.path.steps + 1;
    state_.before.reset();
    const std::optional<std::vector<double>> start = charts->start();
    is_start_in_chart_ = start.has_value();
    if (start) start_ = starting_point(*curve_, *start);
    return true;
  }

  std::vector<double> chartless(const std::vector<double>& v) const {
    return aids_->charts == nullptr ? v : aids_->charts->chartless(v);
  }

  Crossing crossing(const std::vector<double>& v, double length, std::size_t rank, bool is_touching) const {
    Crossing result{chartless(v), length, rank, is_touching};
    result.rank += result.v.size() - v.size();  // other coordinates, as many equations more
    return result;
  }

  PathEnd where_no_step_succeeds() const {
    constexpr double kSingular = 1e13;  // of the quotient of pivots: doubles tell no direction there
    const bool is_regular = tools_.at_here.matrix().pivot_ratio() < kSingular;
    return is_defined_ && is_regular ? PathEnd::stuck : PathEnd::to_undefined;
  }

  /// Where only small steps succeed, as near points at which the equations are not smooth, the usual
  /// tolerance is too wide, and doubles may have too few digits: moves the current point to the curve as
  /// exactly as doubles can say.
  void improve_here() {
    is_exact_ = true;
    std::vector<double> v = state_.here.v;
    if (tools_.precise_corrector.correct(state_.here, tools_.at_here.matrix(), 1, v).end !=
        Correction::End::done)
      return;
    CurvePoint better{std::move(v), {}};
    if (tools_.at_here.find(better, std::vector(state_.here.tangent))) state_.here = std::move(better);
  }

  /// Finds the next point; false where the step was too long.
  bool attempt() {
    is_turn_ = false;
    const CurvePoint& here = state_.here;
    const CurvePoint* before = state_.before ? &*state_.before : nullptr;
    is_defined_ = tools_.predictor->predict(here, before, state_.step, next_.v);
    if (!is_defined_) return false;
    const bool is_precise = aids_->precise != nullptr && state_.step < kSmallStep;
    if (is_precise) ++state_.path.precise_steps;
    Corrector& corrector = is_precise ? tools_.precise_corrector : tools_.corrector;
    const Correction correction = corrector.correct(here, tools_.at_here.matrix(), state_.step, next_.v);
    is_defined_ = correction.end != Correction::End::undefined;
    if (correction.end != Correction::End::done) return false;
    const bool is_adaptive = options_->step_control == StepControl::adaptive;
    if (is_adaptive && correction.first > kLargestDeviation * state_.step) return false;
    is_defined_ = tools_.at_next.find(next_, here.tangent);
    if (!is_defined_) return false;
    if (!is_adaptive) return true;
    if (!is_precise && !(tools_.at_next.polish(next_) <= largest_polish())) return false;
    const double cosine = dot(next_.tangent, here.tangent);
    if (!(cosine > std::cos(options_->largest_turn))) return false;
    if (!is_smooth()) return false;
    if (crosses_twice(1, here, next_)) return false;
    if (turns_near(1, here, next_) && !ends_at_turning_point()) return false;
    if (next_.orientation != here.orientation && !passes_a_branch_point()) return false;
    if (certifier_ != nullptr && !is_proved_or_a_leap()) return false;
    set_growth(correction, std::acos(std::min(cosine, 1.0)));
    return true;
  }

  /// What a correction leaves, with some room for what it cannot know.
  double largest_polish() const {
    return std::max(options_->corrector.tolerance * (1 + largest(next_.v)), 0.002 * state_.step);
  }

  /// A step to t a little beyond 0 or 1, where critical points are, when they are near: rules (i) and (ii) of
  /// Imbach 2013, section 3.2.
  bool steps_across_a_level() {
    constexpr double kBeyond = 1e-3;
    const CurvePoint& here = state_.here;
    const double t = here.v.back(), speed = here.tangent.back();
    const double predicted = t + state_.step * speed;
    for (const double level : {0.0, 1.0}) {
      const bool is_near = (t - level) * (predicted - level) <= 0 || std::abs(predicted - level) <= kBeyond;
      const double target = level + (speed > 0 ? kBeyond : -kBeyond);
      const double step = (target - t) / speed;
      if (!is_near || !(step > 0)) continue;
      next_.v = here.v;
      for (std::size_t i = 0; i < next_.v.size(); ++i) next_.v[i] += step * here.tangent[i];
      next_.v.back() = target;
      if (solve_at_level(*curve_, next_.v) && tools_.at_next.find(next_, here.tangent)) return true;
    }
    return false;
  }

  /// Whether the curve, as far as one more point tells, leads from the current point to the next.
  bool is_smooth() {
    constexpr double kLargestHalfWay = 0.002;  // in steps
    const CurvePoint& here = state_.here;
    const double rounding = options_->corrector.tolerance * (1 + largest(here.v));
    return tools_.smooth_step.distance_half_way(tools_.at_next.matrix(), here, next_) <=
           kLargestHalfWay * distance(here.v, next_.v) + rounding;
  }

  /// Cuts the step where t turns back near 1: then it is seen whether it crosses.
  bool ends_at_turning_point() {
    std::optional<CurvePoint> turn = turning_point(*curve_, state_.here, next_);
    if (!turn || !tools_.at_next.find(*turn, state_.here.tangent)) return false;
    next_ = std::move(*turn);
    is_turn_ = true;
    return true;
  }

  void set_growth(const Correction& correction, double turn) {
    const double aimed = options_->deviation * state_.step;
    const double error = std::max(correction.first, 1e-300);
    growth_ =
        std::clamp(std::pow(aimed / error, 1.0 / (state_.before ? tools_.predictor->order() : 2)), 0.5, 2.0);
    if (turn > 0) growth_ = std::min(growth_, std::max(0.5, 0.7 * options_->largest_turn / turn));
  }

  /// Whether branches cross within the step; remembers where.
  bool passes_a_branch_point() {
    constexpr double kSameBranch = 1e-13;
    const double span = distance(state_.here.v, next_.v);
    const std::optional<CriticalPoint> found =
        critical_point_near(*curve_, point_between(state_.here, next_, 0.5), span);
    if (!found || found->gap > kSameBranch) return false;
    branch_point_ = found->v;
    return true;
  }

  /// Whether the step may be taken as far as proofs go: with the proof that the curve leads there, or across
  /// a branch point without.
  bool is_proved_or_a_leap() {
    is_return_proved_ = false;
    const std::uint64_t seen = crosses(1, state_.here, next_) ? 1 : 0;
    const auto arc = certifier_->follow(next_);
    state_.path.tubes = certifier_->tubes();
    if (arc) {
      is_return_proved_ = arc->passes_beginning;
      return arc->crossings == seen;
    }
    if (!branch_point_ || !certifier_->go_on_from(next_)) return false;
    ++state_.path.unproved_steps;
    return true;
  }

  /// Makes the next point the current one; the end of the path, where it is one.
  std::optional<PathEnd> accept() {
    const CurvePoint& here = state_.here;
    Path& path = state_.path;
    ++path.steps;
    const double travelled = distance(here.v, next_.v);
    const double middle = state_.direction * (state_.length + travelled / 2);
    if (branch_point_) path.branch_points.push_back({chartless(*branch_point_), middle});
    branch_point_.reset();
    if (is_turn_ && std::abs(next_.v.back() - 1) < kTouching) {
      next_.v.back() = 1;
      path.crossings.push_back(crossing(next_.v, middle, rank_at(*curve_, next_.v), true));
    } else if (crosses(1, here, next_)) {
      if (auto point = point_at(1, *curve_, here, next_))
        path.crossings.push_back(crossing(point->v, middle, point->rank, false));
    }
    // Not in the first step from there: the point may have been improved, and lie a little before itself.
    const bool is_back = state_.length > 0 && is_start_in_chart_ && passes_through(start_, here);
    path.length += is_back ? distance(here.v, start_.v) : travelled;
    const bool is_first_from_landmark = state_.steps_to_next_landmark == path.steps;
    const bool is_loop = !is_back && state_.steps_to_next_landmark > 1 && !is_first_from_landmark &&
                         passes_through(state_.landmark, here);
    state_.length += travelled;
    state_.before = std::exchange(state_.here, next_);
    is_exact_ = false;
    std::swap(tools_.at_here, tools_.at_next);
    if (is_loop || (is_back && is_odd())) throw Jump{std::move(path)};
    path.is_return_proved = is_back && is_return_proved_;
    if (is_back) return PathEnd::cycle;
    if (norm(state_.here.v) > options_->infinity) return PathEnd::to_infinity;
    if (options_->stops_at_first_crossing && !path.crossings.empty()) return PathEnd::budget;
    move_landmark();
    if (options_->step_control == StepControl::adaptive)
      state_.step =
          std::min(state_.step * growth_, options_->largest_step * std::max(1.0, norm(state_.here.v)));
    return std::nullopt;
  }

  /// The number of crossings of t = 1 to its other side.
  bool is_odd() const {
    return std::ranges::count(state_.path.crossings, false, &Crossing::is_touching) % 2 != 0;
  }

  /// Brent's way to notice loops: the landmark moves after 1, 2, 4, ... steps.
  void move_landmark() {
    if (--state_.steps_to_next_landmark > 0) return;
    tools_.exact_corrector.correct(CurvePoint(state_.here), tools_.at_here.matrix(), 1, state_.here.v);
    state_.landmark = state_.here;
    state_.steps_to_next_landmark = state_.path.steps + 1;
  }

  /// Whether the curve between `here` and the next point passes through that point in the same direction.
  bool passes_through(const CurvePoint& point, const CurvePoint& here) {
    constexpr double kNear = 1e-7;
    const auto height = [&](const std::vector<double>& v) {
      double sum = 0;
      for (std::size_t i = 0; i < v.size(); ++i) sum += (v[i] - point.v[i]) * point.tangent[i];
      return sum;
    };
    if (!(height(here.v) < 0 && height(next_.v) >= 0)) return false;
    const double span = distance(here.v, next_.v);
    if (distance(here.v, point.v) > 2 * span) return false;
    double low = 0, high = 1;
    for (int k = 0; k < 40; ++k) {
      const double middle = (low + high) / 2;
      (height(point_between(here, next_, middle)) < 0 ? low : high) = middle;
    }
    std::vector<double> v = point_between(here, next_, high);
    tools_.exact_corrector.correct(point, tools_.at_here.matrix(), span, v);
    return distance(v, point.v) <= kNear * (1 + norm(point.v));
  }

  static constexpr double kLargestDeviation = 0.06;
  static constexpr double kSmallStep = 1e-3;
  static constexpr double kTouching = 1e-11;  ///< of t at turning points, which is 1 there then

  Curve* curve_;
  const TrackerOptions* options_;
  std::stop_token stop_;
  const PathAids* aids_;
  PathCertifier* certifier_;
  Tools tools_;
  CurvePoint start_;
  bool is_start_in_chart_ = true;
  CurvePoint next_;
  std::optional<std::vector<double>> branch_point_;
  double growth_ = 1;
  bool has_moved_ = false;         ///< since the last change of chart
  bool is_turn_ = false;           ///< of t, at the next point
  bool is_return_proved_ = false;  ///< by the last step
  bool is_exact_ = false;          ///< the current point was improved
  bool is_defined_ = true;         ///< where the equations were asked for last
  PathState state_;
};

/// What to try after a jump.
TrackerOptions with_smaller_steps(TrackerOptions options) {
  if (options.step_control == StepControl::fixed) {
    options.first_step /= 2;
    return options;
  }
  options.deviation /= 4;
  options.largest_turn /= 2;
  options.largest_step /= 2;
  return options;
}

}  // namespace

std::string_view name_of(PathEnd end) {
  switch (end) {
    case PathEnd::cycle:
      return "cycle";
    case PathEnd::to_infinity:
      return "to_infinity";
    case PathEnd::to_undefined:
      return "to_undefined";
    case PathEnd::stuck:
    case PathEnd::budget:
      break;
  }
  return "budget";
}

Path follow_path(Curve& curve, const std::vector<double>& start, const TrackerOptions& options,
                 const std::stop_token& stop, const PathAids& aids) {
  constexpr int kRestarts = 8;
  TrackerOptions attempt = options;
  for (int restarts = 0;; ++restarts) {
    if (aids.charts != nullptr) aids.charts->begin();
    try {
      Path path = Tracker(curve, start, attempt, stop, aids).follow(restarts == 0 ? aids.from : nullptr);
      path.restarts += restarts;
      return path;
    } catch (Jump& jump) {
      if (restarts < kRestarts) {
        attempt = with_smaller_steps(attempt);
        continue;
      }
      jump.path.end = jump.path.other_end = PathEnd::stuck;
      jump.path.last = jump.path.other_last = start;
      jump.path.restarts = kRestarts;
      return std::move(jump.path);
    }
  }
}

}  // namespace gcslab
