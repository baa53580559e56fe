#include "construction/plan_atlas.h"

#include <algorithm>

#include "base/error.h"
#include "construction/plan_singularity.h"
#include "geometry/sketch.h"

namespace gcslab {
namespace {

// Of charts at a figure: the sine of the angle at which their loci meet.
constexpr double kPoor = 0.05, kGood = 0.2, kSingular = 1e-3;
constexpr std::size_t kMostTried = 40;

/// Whether the frame's third point has come to the other side of the x axis: the figure, turned about that,
/// is one of the same chart, by which it is recognised.
bool is_turned(const Frame& frame, const Figure& figure) {
  return frame.size() == 3 && figure[frame[2]][1] < 0;
}

}  // namespace

PlanAtlas::PlanAtlas(const ConstraintSystem& system, const Frame& frame, const GeometricEquations& equations,
                     const SketchHomotopy& sketched, PlanKind kind)
    : system_(&system),
      frame_(frame),
      equations_(&equations),
      sketched_(&sketched),
      kind_(kind),
      orders_(plan_orders(system, kind)),
      sketch_(figure_at(equations, sketched.curve().unknowns(sketched.start()))) {
  charts_.push_back(std::make_unique<PlanHomotopy>(system, frame, equations, sketched, kind));
}

const std::vector<double>& PlanAtlas::begin() {
  current_ = last_ = 0;
  searched_ = 1;
  return chart().curve().start();
}

double PlanAtlas::quality(const PlanHomotopy& chart, const Figure& figure, double t) const {
  const Plan& plan = chart.program().plan();
  const Frame frame = plan.frame(system_->universe);
  const double height = frame_height(frame, figure);
  if (is_frame_flat(frame, figure) || !(height > 0)) return 0;
  const auto least =
      least_general_step(chart.program(), in_frame(*system_, plan, figure), chart.motion().parameters(t));
  return least ? std::min(height, least->sine) : height;
}

bool PlanAtlas::change_at(std::span<const double> v, bool is_stuck) {
  const Figure figure = chart().curve().figure(v);
  const double t = v.back();
  if (is_turned(chart().program().plan().frame(system_->universe), figure)) {
    last_ = current_;
    return true;
  }
  const double here = quality(chart(), figure, t);
  if (!is_stuck && !(here < std::min(kPoor, searched_))) return false;
  const auto best_chart = [&] {
    return std::ranges::max_element(
        charts_, {}, [&](const std::unique_ptr<PlanHomotopy>& chart) { return quality(*chart, figure, t); });
  };
  auto best = best_chart();
  if (quality(**best, figure, t) < kGood) {
    add_chart(figure, t);
    best = best_chart();
  }
  const double there = quality(**best, figure, t);
  const auto number = static_cast<std::size_t>(best - charts_.begin());
  if (number == current_ || !(there > (is_stuck ? 1 : 2) * here)) {
    searched_ = here / 2;
    return false;
  }
  last_ = std::exchange(current_, number);
  searched_ = 1;
  return true;
}

void PlanAtlas::add_chart(const Figure& figure, double t) {
  std::unique_ptr<PlanHomotopy> best;
  double most = 0;
  std::size_t tried = 0;
  for (const std::vector<std::size_t>& order : orders_) {
    const auto size = static_cast<std::ptrdiff_t>(dimension(system_->universe));
    if (frame_height(Frame(order.begin(), order.begin() + size), figure) < kPoor) continue;
    if (++tried > kMostTried || most >= kGood) break;
    try {
      auto chart = std::make_unique<PlanHomotopy>(*system_, frame_, *equations_, *sketched_,
                                                  make_plan(*system_, order, kind_, figure), figure, t);
      const double reached = quality(*chart, figure, t);
      if (reached <= most) continue;
      most = reached;
      best = std::move(chart);
    } catch (const NotApplicable&) {
      continue;  // the order has no plan at this figure
    }
  }
  if (best) charts_.push_back(std::move(best));
}

std::vector<double> PlanAtlas::carried_over(std::span<const double> v) {
  return chart().curve().point(charts_[last_]->curve().figure(v), v.back());
}

std::optional<std::vector<double>> PlanAtlas::start() {
  if (quality(chart(), sketch_, 0) < kSingular) return std::nullopt;
  return chart().curve().point(sketch_, 0);
}

std::vector<double> PlanAtlas::chartless(std::span<const double> v) const {
  return sketched_->curve().point(unknowns(v), v.back());
}

}  // namespace gcslab
