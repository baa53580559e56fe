// Drawings of what Bernstein solvers do with a box (Tahari 2011, figures 4.6 to 4.8).

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

#include "base/error.h"
#include "box_solver/contractor_registry.h"
#include "covering/curve_trace.h"
#include "experiments/corpus/problem.h"
#include "experiments/tasks/illustration.h"
#include "experiments/tasks/space_view.h"
#include "interval/elementary.h"
#include "linear_program/exact_basis.h"
#include "linear_program/lp_registry.h"
#include "polynomial/bernstein.h"
#include "polynomial/control_polygon.h"

namespace gcslab {
namespace {

constexpr int kTraceResolution = 300;

void append(Json& shapes, Json more) {
  for (Json& item : more) shapes.push_back(std::move(item));
}

ControlPolygon rational_points(const Polyline& line) {
  ControlPolygon points;
  for (const auto& [x, y] : line) points.push_back({Rational(x), Rational(y)});
  return points;
}

// ---- control points seen along a variable (figure 4.6) ----

/// z = f(x1, x2) on a box with its Bernstein form.
class Surface {
 public:
  explicit Surface(const Problem& problem) : box_(problem.system.box), rational_box_(rational_box(box_)) {
    const auto targets = problem.targets();
    if (box_.size() != 2 || targets.size() != 1 || !targets[0].is_polynomial())
      throw NotApplicable("draws one polynomial in two unknowns");
    polynomial_ = targets[0].polynomial();
    tensor_ = bernstein_from_polynomial<Rational>(polynomial_, rational_box_);
  }

  int degree(int variable) const { return tensor_.degree(variable); }
  const Box& box() const { return box_; }

  SpacePoint control_point(int i, int j) const {
    const auto at = [&](std::size_t v, int index) {
      return box_[v].lower + width(box_[v]) * index / std::max(degree(static_cast<int>(v)), 1);
    };
    return {at(0, i), at(1, j), coefficient(i, j).get_d()};
  }
  const Rational& coefficient(int i, int j) const {
    const auto row = static_cast<std::size_t>(i), row_length = static_cast<std::size_t>(degree(1)) + 1;
    return tensor_.coefficients()[row * row_length + static_cast<std::size_t>(j)];
  }
  SpacePoint point(double s, double t) const {
    const std::vector<Rational> x = {Rational(box_[0].lower + s * width(box_[0])),
                                     Rational(box_[1].lower + t * width(box_[1]))};
    return {x[0].get_d(), x[1].get_d(), polynomial_.evaluate(x).get_d()};
  }
  /// The values over the first variable of all coefficients.
  std::vector<Interval> layers() const {
    std::vector<Interval> result(static_cast<std::size_t>(degree(0)) + 1);
    for (int i = 0; i <= degree(0); ++i) {
      for (int j = 0; j <= degree(1); ++j)
        result[static_cast<std::size_t>(i)] =
            hull(result[static_cast<std::size_t>(i)], elementary::enclosing(coefficient(i, j)));
    }
    return result;
  }

 private:
  Box box_;
  RationalBox rational_box_;
  Polynomial polynomial_{2};
  BernsteinTensor<Rational> tensor_;
};

std::vector<std::vector<SpacePoint>> mesh_of(const Surface& surface) {
  constexpr int kLines = 10;
  constexpr int kSteps = 30;
  std::vector<std::vector<SpacePoint>> lines;
  for (const bool along_first : {true, false}) {
    for (int line = 0; line <= kLines; ++line) {
      lines.emplace_back();
      for (int step = 0; step <= kSteps; ++step) {
        const double s = static_cast<double>(step) / kSteps, t = static_cast<double>(line) / kLines;
        lines.back().push_back(along_first ? surface.point(s, t) : surface.point(t, s));
      }
    }
  }
  return lines;
}

std::vector<std::vector<SpacePoint>> net_of(const Surface& surface) {
  std::vector<std::vector<SpacePoint>> lines;
  for (int i = 0; i <= surface.degree(0); ++i) {
    lines.emplace_back();
    for (int j = 0; j <= surface.degree(1); ++j) lines.back().push_back(surface.control_point(i, j));
  }
  for (int j = 0; j <= surface.degree(1); ++j) {
    lines.emplace_back();
    for (int i = 0; i <= surface.degree(0); ++i) lines.back().push_back(surface.control_point(i, j));
  }
  return lines;
}

SpaceView view_of(const Surface& surface) {
  SpaceView view;
  for (std::size_t k = 0; k < 2; ++k) {
    view.lower[k] = surface.box()[k].lower;
    view.upper[k] = surface.box()[k].upper;
  }
  view.lower[2] = 1e300;
  view.upper[2] = -1e300;
  for (const auto& line : net_of(surface)) {
    for (const SpacePoint& point : line) {
      view.lower[2] = std::min(view.lower[2], point[2]);
      view.upper[2] = std::max(view.upper[2], point[2]);
    }
  }
  return view;
}

Json surface_panel(const Problem& problem, const Surface& surface) {
  const SpaceView view = view_of(surface);
  const auto& box = surface.box();
  Json shapes = Json::array();
  const auto on_ground = [&](double x, double y) { return SpacePoint{x, y, 0}; };
  shapes.push_back(
      shape("polygon", "cell",
            points_json(
                view.seen({on_ground(box[0].lower, box[1].lower), on_ground(box[0].upper, box[1].lower),
                           on_ground(box[0].upper, box[1].upper), on_ground(box[0].lower, box[1].upper)}))));
  for (const auto& line : mesh_of(surface))
    shapes.push_back(shape("polyline", "mesh", points_json(view.seen(line))));
  for (const auto& line : net_of(surface)) {
    shapes.push_back(shape("polyline", "control", points_json(view.seen(line))));
    shapes.push_back(shape("points", "control", points_json(view.seen(line))));
  }
  for (const Polyline& line : trace_curve(problem.system.equations[0], box, kTraceResolution)) {
    std::vector<SpacePoint> points;
    for (const auto& [x, y] : line) points.push_back(on_ground(x, y));
    shapes.push_back(shape("polyline", "curve", points_json(view.seen(points))));
  }
  add_axes(shapes, view, {problem.system.variables[0], problem.system.variables[1], "z"});
  return space_panel("surface, control points, z = 0", std::move(shapes));
}

Json side_panel(const Problem& problem, const Surface& surface, const Interval& segment) {
  const auto seen = [](const SpacePoint& p) { return RationalPoint{Rational(p[0]), Rational(p[2])}; };
  ControlPolygon points;
  Json shapes = Json::array(), mesh = Json::array();
  for (const auto& line : net_of(surface)) {
    for (const SpacePoint& p : line) points.push_back(seen(p));
  }
  for (const auto& line : mesh_of(surface)) {
    ControlPolygon flat;
    for (const SpacePoint& p : line) flat.push_back(seen(p));
    mesh.push_back(shape("polyline", "mesh", points_json(flat)));
  }
  shapes.push_back(shape("polygon", "hull", points_json(convex_hull(points))));
  append(shapes, std::move(mesh));
  const Rational left(surface.box()[0].lower), right(surface.box()[0].upper);
  shapes.push_back(shape("segment", "axis", points_json({{left, 0}, {right, 0}})));
  shapes.push_back(
      shape("segment", "accent", points_json({{Rational(segment.lower), 0}, {Rational(segment.upper), 0}})));
  shapes.push_back(shape("points", "control", points_json(points)));
  return {{"title", "seen along " + problem.system.variables[1]},
          {"aspect", "free"},
          {"x", limits_around(points, 0)},
          {"y", limits_around(points, 1)},
          {"xlabel", problem.system.variables[0]},
          {"ylabel", "z"},
          {"shapes", std::move(shapes)}};
}

Drawn draw_projection(const std::filesystem::path& path, const Options&) {
  const Problem problem = load_problem(path);
  const Surface surface(problem);
  const Interval t = hull_crossings(surface.layers());
  if (is_empty(t)) throw NotApplicable("the Bernstein coefficients have one sign: there is no zero");
  const Interval& side = surface.box()[0];
  const Interval segment(side.lower + width(side) * t.lower, side.lower + width(side) * t.upper);
  return {Json::array({surface_panel(problem, surface), side_panel(problem, surface, segment)})};
}

// ---- preconditioning (figure 4.7) ----

/// The inverse of the Jacobian of two polynomials at the middle of the box, exactly.
std::array<RationalPoint, 2> inverse_jacobian(const std::vector<Polynomial>& system, const Box& box) {
  std::vector<Rational> middle;
  for (const Interval& side : box) middle.emplace_back(midpoint(side));
  const auto slope = [&](std::size_t k, int i) { return system[k].derivative(i).evaluate(middle); };
  const Rational a = slope(0, 0), b = slope(0, 1), c = slope(1, 0), d = slope(1, 1);
  const Rational determinant = a * d - b * c;
  if (determinant == 0) throw NotApplicable("the Jacobian is singular at the middle of the box");
  return {{{d / determinant, -b / determinant}, {-c / determinant, a / determinant}}};
}

Json curves_panel(const std::string& title, const Problem& problem, const std::vector<Polynomial>& system,
                  const std::optional<Box>& reduced) {
  const Box& box = problem.system.box;
  Json shapes = Json::array();
  if (reduced) {
    const Rational x0((*reduced)[0].lower), x1((*reduced)[0].upper), y0((*reduced)[1].lower),
        y1((*reduced)[1].upper);
    shapes.push_back(shape("polygon", "hull", points_json({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}})));
  }
  ExpressionGraph graph;
  for (std::size_t k = 0; k < 2; ++k) {
    for (const Polyline& line : trace_curve(system[k].to_expression(graph), box, kTraceResolution))
      shapes.push_back(shape("polyline", k == 0 ? "first" : "second", points_json(rational_points(line))));
  }
  if (reduced) {
    const RationalPoint middle = {Rational(midpoint((*reduced)[0])), Rational(midpoint((*reduced)[1]))};
    const bool is_dot =
        width((*reduced)[0]) < width(box[0]) / 100 && width((*reduced)[1]) < width(box[1]) / 100;
    if (is_dot) shapes.push_back(shape("points", "curve", points_json({middle})));
  }
  return {{"title", title},
          {"aspect", "equal"},
          {"x", {box[0].lower, box[0].upper}},
          {"y", {box[1].lower, box[1].upper}},
          {"xlabel", problem.system.variables[0]},
          {"ylabel", problem.system.variables[1]},
          {"shapes", std::move(shapes)}};
}

Drawn draw_preconditioning(const std::filesystem::path& path, const Options&) {
  const Problem problem = load_problem(path);
  std::vector<Polynomial> given;
  for (const BoundTarget& target : problem.targets()) {
    if (!target.is_polynomial()) throw NotApplicable("draws polynomial systems");
    given.push_back(target.polynomial());
  }
  if (given.size() != 2 || problem.system.box.size() != 2)
    throw NotApplicable("draws two equations in two unknowns");
  const auto inverse = inverse_jacobian(given, problem.system.box);
  std::vector<Polynomial> preconditioned;
  for (const RationalPoint& row : inverse) preconditioned.push_back(given[0] * row[0] + given[1] * row[1]);
  const SystemFunctions functions(problem.system);
  const auto contractor = contractor_registry().at("bernstein_projection").make(functions, {});
  Box reduced = problem.system.box;
  ProofTrace trace;
  const bool has_roots = contractor->contract(reduced, trace);
  const std::optional<Box> left = has_roots ? std::optional(reduced) : std::nullopt;
  const std::string what =
      given[0].total_degree() == 1 && given[1].total_degree() == 1 ? "linear" : "nonlinear";
  return {Json::array({curves_panel(what + ", f", problem, given, std::nullopt),
                       curves_panel(what + ", M f", problem, preconditioned, left)})};
}

// ---- a positive combination (figure 4.8) ----

ControlPolygon control_points(const std::vector<Rational>& coefficients, const RationalInterval& side) {
  ControlPolygon result;
  const auto degree = static_cast<long>(coefficients.size()) - 1;
  for (long i = 0; i <= degree; ++i)
    result.push_back({side.lower + (side.upper - side.lower) * Rational(i) / Rational(degree),
                      coefficients[static_cast<std::size_t>(i)]});
  return result;
}

std::vector<Rational> bernstein_coefficients(const Polynomial& polynomial, const RationalBox& box,
                                             int degree) {
  const auto tensor = bernstein_from_polynomial<Rational>(polynomial, box, {degree});
  return {tensor.coefficients().begin(), tensor.coefficients().end()};
}

/// The multiplier l for which the least coefficient of g + l f is greatest, by an exact linear program over
/// l in [-100, 100] and the least coefficient (Tahari 2011, section 4.5.1).
Rational best_multiplier(const std::vector<Rational>& f, const std::vector<Rational>& g) {
  constexpr double kLargest = 100;
  LpModel model;
  const int multiplier = model.add_column(Interval(-kLargest, kLargest));
  const int least = model.add_column(Interval(-1e6, 1e6));
  for (std::size_t i = 0; i < f.size(); ++i) {
    const std::vector<LinearTerm> terms = {{multiplier, Interval(nearest_double(f[i]))},
                                           {least, Interval(-1)}};
    model.add_row(terms, {-nearest_double(g[i]), HUGE_VAL});
  }
  const auto backend = lp_registry().at("exact").make_with();
  backend->load(model);
  const std::vector<LinearTerm> objective = {{least, Interval(-1)}};
  return exact_vertex(model, objective, backend->minimise(objective).basis).primal.at(0);
}

Json graph_with_polygon(Json shapes, const char* style, const Polynomial& polynomial,
                        const std::vector<Rational>& coefficients, const RationalInterval& side,
                        const std::string& name, bool has_polygon) {
  ControlPolygon points;
  for (int s = 0; s <= 80; ++s) {
    const Rational x = side.lower + (side.upper - side.lower) * Rational(s) / 80;
    points.push_back({x, polynomial.evaluate(std::vector<Rational>{x})});
  }
  shapes.push_back(shape("polyline", style, points_json(points)));
  shapes.push_back(label(style, points.back(), name));
  if (has_polygon) {
    const ControlPolygon control = control_points(coefficients, side);
    shapes.push_back(shape("polyline", "control", points_json(control)));
    shapes.push_back(shape("points", "control", points_json(control)));
  }
  return shapes;
}

Drawn draw_combination(const std::filesystem::path& path, const Options&) {
  const Problem problem = load_problem(path);
  const auto equations = problem.targets();
  const auto inequalities = problem.targets(problem.system.inequalities);
  if (problem.system.variables.size() != 1 || equations.size() != 1 || inequalities.size() != 1 ||
      !equations[0].is_polynomial() || !inequalities[0].is_polynomial())
    throw NotApplicable("draws one polynomial equation and one inequality in one unknown");
  const Polynomial &f = equations[0].polynomial(), &g = inequalities[0].polynomial();
  const RationalBox box = rational_box(problem.system.box);
  const int degree = std::max(f.total_degree(), g.total_degree());
  const auto of_f = bernstein_coefficients(f, box, degree), of_g = bernstein_coefficients(g, box, degree);
  const Rational multiplier = best_multiplier(of_f, of_g);
  const Polynomial h = g + f * multiplier;
  const auto of_h = bernstein_coefficients(h, box, degree);
  if (std::ranges::any_of(of_h, [](const Rational& b) { return b <= 0; }))
    throw NotApplicable("no combination of the two has positive Bernstein coefficients");
  const std::string& x = problem.system.variables[0];
  const std::string name =
      fmt::format("g {} {} f", multiplier < 0 ? "−" : "+", Rational(abs(multiplier)).get_str());
  const auto panel = [&](const std::string& title, Json shapes) {
    ControlPolygon all = control_points(of_f, box[0]);
    for (const auto& more : {of_g, of_h}) {
      for (const RationalPoint& p : control_points(more, box[0])) all.push_back(p);
    }
    shapes.push_back(shape("segment", "axis", points_json({{box[0].lower, 0}, {box[0].upper, 0}})));
    return Json{{"title", title},
                {"aspect", "free"},
                {"x", limits_around(all, 0, 0.16)},
                {"y", limits_around(all, 1)},
                {"xlabel", x},
                {"shapes", std::move(shapes)}};
  };
  Json both = graph_with_polygon(Json::array(), "first", f, of_f, box[0], "f", true);
  both = graph_with_polygon(std::move(both), "second", g, of_g, box[0], "g", true);
  Json combined = graph_with_polygon(Json::array(), "first", f, of_f, box[0], "f", false);
  combined = graph_with_polygon(std::move(combined), "second", g, of_g, box[0], "g", false);
  combined = graph_with_polygon(std::move(combined), "curve", h, of_h, box[0], name, true);
  Drawn drawn{Json::array({panel("f = 0 and g ≤ 0", std::move(both)),
                           panel("every coefficient of " + name + " is positive", std::move(combined))})};
  drawn.values["multiplier"] = multiplier.get_str();
  return drawn;
}

}  // namespace

std::vector<Illustration> solver_illustrations() {
  return {
      {"control_point_projection",
       "a surface z = f with its control points, and their hull seen along a variable", draw_projection},
      {"preconditioning", "a system before and after it is multiplied by the inverse Jacobian",
       draw_preconditioning},
      {"positive_combination",
       "a combination of equation and inequality whose Bernstein coefficients prove that there is no root",
       draw_combination}};
}

}  // namespace gcslab
