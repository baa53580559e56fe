#include "construction/plan.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "construction/plan_orders.h"
#include "expression/differentiate.h"
#include "expression/tape_evaluator.h"
#include "geometry/numeric_vector.h"
#include "geometry/sketch.h"

namespace gcslab {
namespace {

/// Loci that meet at an angle with a smaller sine are not taken for different ones.
constexpr double kLeastSine = 1e-3;

struct Candidate {
  LocusSource source;
  Locus locus;
  Numbers normal;  ///< at the point, of length 1; empty where there is none
};

class PlanMaker {
 public:
  PlanMaker(const ConstraintSystem& system, const std::vector<std::size_t>& order, bool only_distances,
            const Figure& figure)
      : system_(&system),
        variables_(system),
        only_distances_(only_distances),
        frame_(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(dimension(system.universe))),
        is_used_(system.constraints.size()) {
    point_ = coordinates_in_order(in_frame(system, frame_, figure));
    point_.resize(point_.size() + system.parameters.size(), 0.0);
    is_placed_.assign(system.points(), false);
    for (const std::size_t p : order) place(p);
    for (std::size_t c = 0; c < is_used_.size(); ++c) {
      if (!is_used_[c]) plan_.removed.push_back(c);
    }
  }

  Plan plan() && { return std::move(plan_); }

 private:
  void place(std::size_t point) {
    const std::size_t freedom = std::min(plan_.steps.size(), dimension(system_->universe));
    PlanStep step{point, {}, std::nullopt};
    std::vector<Numbers> normals;
    bool has_sphere = false;
    const auto accept = [&](Candidate& candidate) {
      if (candidate.source.guide) {
        plan_.guides.push_back({point, *candidate.source.guide});
        candidate.source.guide = plan_.guides.size() - 1;
      } else {
        is_used_[*candidate.source.constraint] = true;
      }
      has_sphere = has_sphere || candidate.locus.is_sphere;
      step.loci.push_back(candidate.source);
      normals.push_back(next_axis(candidate.normal, normals, 0));
    };
    // The locus that meets those taken at the largest angle; with it the others of the same constraint.
    const auto take = [&](std::vector<Candidate> candidates) {
      const auto angle = [&](const Candidate& candidate) { return sine(candidate.normal, normals); };
      while (step.loci.size() < freedom && !candidates.empty()) {
        const auto best = std::ranges::max_element(candidates, {}, angle);
        if (angle(*best) < kLeastSine) return;
        const auto constraint = best->source.constraint;
        const std::size_t parts = constraint ? restriction(*constraint) : 1;
        std::vector<Candidate> together;
        for (const Candidate& candidate : candidates) {
          if (constraint ? candidate.source.constraint == constraint : &candidate == &*best)
            together.push_back(candidate);
        }
        std::erase_if(candidates, [&](const Candidate& candidate) {
          return constraint ? candidate.source.constraint == constraint
                            : candidate.source.guide == together[0].source.guide;
        });
        if (step.loci.size() + parts > freedom) continue;
        for (std::size_t k = 0; k < parts; ++k) accept(*std::ranges::max_element(together, {}, angle));
      }
    };
    take(of_constraints(point, freedom));
    take(of_guides(point, freedom));
    if (step.loci.size() < freedom)
      throw NotApplicable(
          "no construction plan: " + system_->objects[point].name +
          " cannot be placed beside the points before it, where the sketch has too many of them on a "
          "line or a plane");
    if (freedom > 1 && has_sphere) step.choice = choices_++;
    plan_.steps.push_back(std::move(step));
    is_placed_[point] = true;
  }

  std::vector<Candidate> of_constraints(std::size_t point, std::size_t freedom) {
    std::vector<Candidate> result;
    for (std::size_t c = 0; c < system_->constraints.size(); ++c) {
      const Constraint& constraint = system_->constraints[c];
      if (only_distances_ && constraint.kind->name != "distance") continue;
      if (!names_only_placed(constraint, point)) continue;
      const std::vector<Locus> loci = loci_of(*system_, constraint, point, frame_, variables_);
      for (std::size_t part = 0; part < loci.size(); ++part) {
        if (freedom < dimension(system_->universe) && !loci[part].is_sphere) continue;
        result.push_back({{c, part, std::nullopt}, loci[part], normal(loci[part], point, freedom)});
      }
    }
    return result;
  }

  std::vector<Candidate> of_guides(std::size_t point, std::size_t freedom) {
    std::vector<Candidate> result;
    for (const PlanStep& before : plan_.steps) {
      const Locus locus = sphere_around(point, before.point, variables_.graph->constant(1), variables_);
      result.push_back({{std::nullopt, 0, before.point}, locus, normal(locus, point, freedom)});
    }
    return result;
  }

  std::size_t restriction(std::size_t constraint) const {
    return static_cast<std::size_t>(system_->constraints[constraint].kind->restriction(system_->universe));
  }

  bool names_only_placed(const Constraint& constraint, std::size_t point) const {
    return std::ranges::find(constraint.objects, point) != constraint.objects.end() &&
           std::ranges::all_of(constraint.objects,
                               [&](std::size_t p) { return p == point || is_placed_[p]; });
  }

  Numbers normal(const Locus& locus, std::size_t point, std::size_t freedom) const {
    Numbers result;
    for (std::size_t i = 0; i < freedom; ++i) {
      const Expression slope = differentiate(locus.equation, variables_.coordinates[point][i].variable());
      const Tape tape(slope, variables_.count);
      TapeEvaluator<double> evaluator(tape);
      evaluator.evaluate(point_);
      result.push_back(evaluator.value());
    }
    const double length = std::sqrt(dot(result, result));
    if (!(length > 0) || !std::isfinite(length)) return {};
    for (double& x : result) x /= length;
    return result;
  }

  /// Of the angle between a normal and the space of others, which are orthonormal.
  static double sine(const Numbers& normal, const std::vector<Numbers>& others) {
    double square = normal.empty() ? 0 : 1;
    for (const Numbers& other : others) {
      if (!normal.empty()) square -= dot(normal, other) * dot(normal, other);
    }
    return std::sqrt(std::max(square, 0.0));
  }

  const ConstraintSystem* system_;
  FigureVariables variables_;
  bool only_distances_;
  Frame frame_;  ///< in which the plan constructs
  std::vector<bool> is_used_;
  std::vector<double> point_;  ///< the figure, and 0 for the parameters: no normal depends on them
  std::vector<bool> is_placed_;
  std::size_t choices_ = 0;
  Plan plan_;
};

void check_applies(const ConstraintSystem& system) {
  for (const NamedObject& object : system.objects) {
    if (object.sort != Sort::point)
      throw NotApplicable("construction plans place points, and " + object.name + " is a " +
                          name_of(object.sort));
  }
  for (const Constraint& constraint : system.constraints) {
    if (constraint.kind->name.starts_with("fixed_"))
      throw NotApplicable("construction plans choose their frame, but coordinates are held by " +
                          system.describe(constraint));
  }
  if (system.points() <= dimension(system.universe))
    throw NotApplicable("construction plans need more points than the frame has");
}

std::string text_of(const LocusSource& source, const Plan& plan, const ConstraintSystem& system,
                    std::size_t point) {
  if (source.guide) {
    const Guide& guide = plan.guides[*source.guide];
    return fmt::format("sphere({}, k{})", system.objects[guide.centre].name, *source.guide);
  }
  const Constraint& constraint = system.constraints[*source.constraint];
  if (constraint.kind->name == "distance") {
    const std::size_t other = constraint.objects[constraint.objects[0] == point ? 1 : 0];
    return fmt::format("sphere({}, {})", system.objects[other].name,
                       system.parameters[*constraint.parameter]);
  }
  std::string text = constraint.kind->name;
  for (const std::size_t object : constraint.objects) text += " " + system.objects[object].name;
  if (constraint.parameter) text += " = " + system.parameters[*constraint.parameter];
  return "locus(" + text + ")";
}

Figure general_figure(ConstraintSystem system) {
  system.sketch.reset();
  system.random_sketch = 1;
  return *sketch_of(system);
}

}  // namespace

std::size_t Plan::choices() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(steps, [](const PlanStep& step) { return step.choice.has_value(); }));
}

Frame Plan::frame(Universe universe) const {
  Frame result;
  for (std::size_t k = 0; k < dimension(universe); ++k) result.push_back(steps[k].point);
  return result;
}

std::string text_of(const Plan& plan, const ConstraintSystem& system) {
  std::string text;
  for (const PlanStep& step : plan.steps) {
    std::vector<std::string> loci;
    for (const LocusSource& source : step.loci) loci.push_back(text_of(source, plan, system, step.point));
    text += fmt::format("{} = {}\n", system.objects[step.point].name,
                        loci.empty() ? "origin" : fmt::format("{}", fmt::join(loci, " * ")));
  }
  for (std::size_t g = 0; g < plan.guides.size(); ++g)
    text += fmt::format("guide k{} = distance {} {}\n", g, system.objects[plan.guides[g].point].name,
                        system.objects[plan.guides[g].centre].name);
  for (const std::size_t c : plan.removed)
    text += fmt::format("removed: {}\n", system.describe(system.constraints[c]));
  return text;
}

std::vector<std::vector<std::size_t>> plan_orders(const ConstraintSystem& system, PlanKind kind) {
  check_applies(system);
  const PlacingConstraints constraints(system, FigureVariables(system), kind == PlanKind::henneberg);
  return forward_orders(constraints, dimension(system.universe));
}

Plan make_plan(const ConstraintSystem& system, const std::vector<std::size_t>& order, PlanKind kind,
               const Figure& figure) {
  return PlanMaker(system, order, kind == PlanKind::henneberg, figure).plan();
}

Plan make_plan(const ConstraintSystem& system, PlanKind kind, const Figure& figure) {
  check_applies(system);
  const bool only_distances = kind == PlanKind::henneberg;
  const FigureVariables variables(system);
  const PlacingConstraints constraints(system, variables, only_distances);
  const std::size_t d = dimension(system.universe);
  std::vector<std::size_t> order;
  if (kind == PlanKind::gao) order = gao_order(constraints, d);
  if (kind == PlanKind::least) order = least_order(constraints, d);
  if (order.empty()) order = forward_orders(constraints, d).front();
  // Figures that satisfy coplanarities have spheres that only touch: the centres alone matter here.
  return make_plan(system, order, kind, only_distances ? general_figure(system) : figure);
}

std::optional<Plan> plan_without_guides(const ConstraintSystem& system, const Frame& frame) {
  check_applies(system);
  const PlacingConstraints constraints(system, FigureVariables(system), false);
  const auto order = order_without_guides(constraints, dimension(system.universe), frame);
  if (!order) return std::nullopt;
  return PlanMaker(system, *order, false, general_figure(system)).plan();
}

}  // namespace gcslab
