// The reduction of an interval by linear programs, step by step (Tahari 2011, figure 5.1 and section 5.2).

#include <algorithm>
#include <fmt/format.h>

#include "base/error.h"
#include "box_solver/lp_reduction_contractor.h"
#include "experiments/corpus/problem.h"
#include "experiments/tasks/polytope_panel.h"
#include "linear_program/exact_basis.h"
#include "linear_program/lp_registry.h"

namespace gcslab {
namespace {

std::string interval_text(const Rational& lower, const Rational& upper) {
  return "[" + lower.get_str() + ", " + upper.get_str() + "]";
}

/// a x^2 + b x + c = 0.
struct Quadratic {
  Rational a, b, c;

  /// The point over x of the line a y + b x + c = 0.
  RationalPoint on_line(const Rational& x) const { return {x, -(b * x + c) / a}; }
  /// The part of the line inside the limits of a panel.
  ControlPolygon line_within(const Json& across, const Json& upwards) const {
    Rational first(across[0].get<double>()), last(across[1].get<double>());
    if (b != 0) {
      const auto over = [&](const Json& y) { return Rational(-(a * Rational(y.get<double>()) + c) / b); };
      const Rational one = over(upwards[0]), other = over(upwards[1]);
      const auto& [low, high] = std::minmax(one, other);
      first = std::max(first, low);
      last = std::min(last, high);
    }
    return {on_line(first), on_line(last)};
  }
};

Quadratic quadratic_of(const Problem& problem) {
  const auto targets = problem.targets();
  if (problem.system.variables.size() != 1 || targets.size() != 1 || !targets[0].is_polynomial() ||
      targets[0].polynomial().total_degree() != 2)
    throw NotApplicable("draws quadratic equations in one unknown");
  const Polynomial& p = targets[0].polynomial();
  return {p.coefficient({2}), p.coefficient({1}), p.coefficient({0})};
}

/// The exact minimum of the objective over the model, by the exact simplex.
Rational exact_minimum(const LpModel& model, const std::vector<LinearTerm>& objective) {
  const auto backend = lp_registry().at("exact").make_with();
  backend->load(model);
  const ExactVertex vertex = exact_vertex(model, objective, backend->minimise(objective).basis);
  if (!vertex.is_optimal()) throw NotApplicable("the linear program has no optimal vertex");
  return vertex.objective;
}

struct RationalRange {
  Rational lower, upper;
};

RationalRange exact_range(const LpModel& model, std::vector<LinearTerm> objective) {
  const Rational least = exact_minimum(model, objective);
  for (LinearTerm& term : objective)
    term.coefficient = Interval(-term.coefficient.upper, -term.coefficient.lower);
  return {least, -exact_minimum(model, objective)};
}

/// The range of the polynomial over the polytope (Tahari 2011, section 5.2.1).
RationalRange range_by_programs(const Lifted& lifted) {
  LpModel model = lifted.bernstein().model();
  model.set_sides(0, Interval::entire());
  const ExpansionRow<FastInterval>& row = lifted.expansion().row(0);
  std::vector<LinearTerm> objective;
  for (std::size_t i = 0; i < row.columns.size(); ++i)
    objective.push_back({static_cast<int>(row.columns[i]), row.values[i].interval()});
  const RationalRange range = exact_range(model, objective);
  const Rational constant(midpoint(row.constant.interval()));
  return {range.lower + constant, range.upper + constant};
}

/// Least and largest x over the polytope and the equation (section 5.2.2).
RationalRange reduction_by_programs(const Lifted& lifted) {
  const RationalRange z = exact_range(lifted.bernstein().model(), {{0, 1}});
  const Rational m(lifted.expansion().midpoints()[0]), r(lifted.expansion().radii()[0]);
  return {m + r * z.lower, m + r * z.upper};
}

Json reduction_panel(const Quadratic& quadratic, const Interval& before, const Interval& after,
                     const ExactPolytope& polytope, const std::vector<std::string>& names,
                     const std::string& title) {
  const ControlPolygon corners = polygon_of(polytope);
  const Json across = limits_around(corners, 0), upwards = limits_around(corners, 1);
  const RationalPoint ends[] = {quadratic.on_line(Rational(after.lower)),
                                quadratic.on_line(Rational(after.upper))};
  Json shapes = Json::array();
  shapes.push_back(shape("polygon", "hull", points_json(corners)));
  shapes.push_back(shape("polyline", "curve", points_json(parabola_points(before))));
  shapes.push_back(shape("segment", "line", points_json(quadratic.line_within(across, upwards))));
  for (const RationalPoint& end : ends) {
    const RationalPoint foot = {end[0], Rational(upwards[0].get<double>())};
    shapes.push_back(shape("segment", "dashed", points_json({foot, end})));
  }
  shapes.push_back(shape("segment", "accent", points_json({ends[0], ends[1]})));
  return plane_panel(title, corners, names[0], names[1], std::move(shapes));
}

}  // namespace

/// The solver's own contractor takes each step, until the interval is so narrow that its width is rounding.
Drawn draw_reduction(const std::filesystem::path& path, const Options& options) {
  const Problem problem = load_problem(path);
  const Quadratic quadratic = quadratic_of(problem);
  const SystemFunctions functions(problem.system);
  const auto contractor = make_lp_reduction_contractor(functions, {});
  const auto panels = static_cast<std::size_t>(options.integer("panels"));
  const std::vector<std::string> names = names_of({{1}, {2}}, problem.system.variables);
  Drawn drawn;
  Json widths = Json::array();
  Box box = problem.system.box;
  constexpr double kNarrow = 1e-8;
  for (int step = 1; width(box[0]) > kNarrow; ++step) {
    const Box before = box;
    ProofTrace trace;
    if (!contractor->contract(box, trace)) throw NotApplicable("the equation has no solution in the box");
    if (box == before) break;
    widths.push_back(fmt::format("{:.1e}", width(box[0])));
    const Lifted lifted(functions, before);
    if (step == 1) {
      const RationalRange range = range_by_programs(lifted), left = reduction_by_programs(lifted);
      drawn.values["range"] = interval_text(range.lower, range.upper);
      drawn.values["reduction"] = interval_text(left.lower, left.upper);
    }
    if (drawn.panels.size() >= panels) continue;
    const ExactPolytope polytope(lifted.in_monomials(PolytopeParts::all).half_spaces);
    const std::string title =
        step == 1 ? "step 1: to " + drawn.values["reduction"].get<std::string>()
                  : fmt::format("step {}: width {:.2g} to {:.1g}", step, width(before[0]), width(box[0]));
    drawn.panels.push_back(reduction_panel(quadratic, before[0], box[0], polytope, names, title));
  }
  drawn.values["widths"] = std::move(widths);
  return drawn;
}

}  // namespace gcslab
