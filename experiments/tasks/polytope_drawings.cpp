// Drawings of the Bernstein polytope and of the reduction of an interval by it (Tahari 2011, figures 5.1 to
// 5.4).

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "base/error.h"
#include "box_solver/graph_strips.h"
#include "experiments/corpus/problem.h"
#include "experiments/tasks/polytope_panel.h"
#include "experiments/tasks/space_view.h"
#include "expression/printer.h"

namespace gcslab {
namespace {

PolytopeParts parts_from(const std::string& name) {
  if (name == "products") return PolytopeParts::products;
  return name == "published" ? PolytopeParts::published : PolytopeParts::all;
}

OptionSpec parts_option(const std::string& default_choice) {
  return choice_option("inequalities",
                       "products of bound factors; published: and squares about the midpoint and of "
                       "differences; all: what the solver takes",
                       default_choice, {"products", "published", "all"});
}

std::string point_text(const std::vector<Rational>& point) {
  std::string text;
  for (const Rational& coordinate : point) text += (text.empty() ? "(" : ", ") + coordinate.get_str();
  return text + ")";
}

void tell_polytope(const ExactPolytope& polytope, Json& values) {
  constexpr std::size_t kFew = 8;
  values["half_spaces"] = polytope.half_spaces().size();
  values["volume"] = polytope.volume().get_str();
  if (polytope.vertices().size() > kFew) {
    values["vertices"] = polytope.vertices().size();
    return;
  }
  std::string text;
  for (const auto& vertex : polytope.vertices()) text += (text.empty() ? "" : ", ") + point_text(vertex);
  values["vertices"] = text;
}

// ---- a polygon around the exponential ----

bool is_exponential(const EquationSystem& system) {
  return system.variables.size() == 1 && system.equations.size() == 1 &&
         to_text(system.equations[0], system.variables) == "exp(" + system.variables[0] + ")";
}

/// The polygon around (x, exp x) that linear programs know (Tahari 2011, figure 5.4): of its strips, the
/// sides that touch a convex graph, its tangents at both ends and its chord.
Drawn draw_exponential(const Problem& problem) {
  const Box& box = problem.system.box;
  if (!is_bounded(box[0]) || !(width(box[0]) > 0)) throw NotApplicable("the box must have a width");
  const Rational u(box[0].lower), v(box[0].upper);
  const auto [at_u, at_v, chord] = [&] {
    const NumberTraits<FastInterval>::Scope scope;
    return GraphStrips(problem.system.equations[0]).around(box[0]);
  }();
  const auto above = [](const Strip& strip) {
    return HalfSpace{{-Rational(strip.slope), 1}, Rational(strip.range.lower)};
  };
  const ExactPolytope polygon({above(at_u),
                               above(at_v),
                               {{Rational(chord.slope), -1}, -Rational(chord.range.upper)},
                               {{1, 0}, u},
                               {{-1, 0}, -v}});
  const ControlPolygon corners = polygon_of(polygon);
  Drawn drawn;
  drawn.values["half_spaces"] = 3;
  Json shapes = Json::array();
  shapes.push_back(shape("polygon", "hull", points_json(corners)));
  const auto nearest = [](const Rational& x) { return Rational(std::exp(x.get_d())); };
  shapes.push_back(shape("polyline", "curve", points_json(graph_points(u, v, 64, nearest))));
  shapes.push_back(shape("points", "control", points_json(corners)));
  const std::string& x = problem.system.variables[0];
  drawn.panels.push_back(plane_panel("chord and tangents of exp", corners, x, "exp " + x, std::move(shapes)));
  return drawn;
}

// ---- the polytope ----

/// A polytope over (x, x^2): the triangle of the products stays visible behind what cuts it.
Json draw_in_plane(const ExactPolytope& polytope, const ExactPolytope& products, const Interval& side,
                   const std::vector<std::string>& names, const std::string& title) {
  const ControlPolygon corners = polygon_of(polytope);
  const ControlPolygon whole = polygon_of(products);
  Json shapes = Json::array();
  shapes.push_back(shape("polygon", "dashed", points_json(whole)));
  shapes.push_back(shape("polygon", "hull", points_json(corners)));
  shapes.push_back(shape("polyline", "curve", points_json(parabola_points(side))));
  shapes.push_back(shape("points", "control", points_json(corners)));
  return plane_panel(title, whole, names[0], names[1], std::move(shapes));
}

/// The curve or surface piece that the polytope encloses: monomials of points of the box.
std::vector<std::vector<SpacePoint>> lifted_lines(const std::vector<Exponents>& monomials, const Box& box) {
  constexpr int kLines = 10;
  constexpr int kSteps = 40;
  const auto lifted = [&](const std::vector<double>& x) {
    SpacePoint point{};
    for (std::size_t k = 0; k < 3; ++k) {
      point[k] = 1;
      for (std::size_t i = 0; i < x.size(); ++i) point[k] *= std::pow(x[i], monomials[k][i]);
    }
    return point;
  };
  const auto at = [&](std::size_t i, int s, int steps) {
    return box[i].lower + (box[i].upper - box[i].lower) * s / steps;
  };
  std::vector<std::vector<SpacePoint>> lines;
  if (box.size() == 1) {
    lines.emplace_back();
    for (int s = 0; s <= kSteps; ++s) lines.back().push_back(lifted({at(0, s, kSteps)}));
    return lines;
  }
  for (const std::size_t along : {0U, 1U}) {
    for (int line = 0; line <= kLines; ++line) {
      lines.emplace_back();
      for (int s = 0; s <= kSteps; ++s) {
        std::vector<double> x(2);
        x[along] = at(along, s, kSteps);
        x[1 - along] = at(1 - along, line, kLines);
        lines.back().push_back(lifted(x));
      }
    }
  }
  return lines;
}

/// The box around what is enclosed.
SpaceView view_around(const std::vector<std::vector<SpacePoint>>& lines) {
  SpaceView view;
  view.lower = view.upper = lines[0][0];
  for (const auto& line : lines) {
    for (const SpacePoint& point : line) {
      for (std::size_t i = 0; i < 3; ++i) {
        view.lower[i] = std::min(view.lower[i], point[i]);
        view.upper[i] = std::max(view.upper[i], point[i]);
      }
    }
  }
  return view;
}

Json draw_in_space(const ExactPolytope& polytope, const std::vector<Exponents>& monomials, const Box& box,
                   const std::vector<std::string>& names, const std::string& title) {
  const auto lines = lifted_lines(monomials, box);
  SpaceView view = view_around(lines);
  if (box.size() == 1) view.turned = 25;  // a curve of increasing powers is seen best from there
  Json shapes = Json::array(), front = Json::array();
  add_polytope(shapes, front, view, polytope);
  const char* style = box.size() == 1 ? "curve" : "mesh";
  for (const auto& line : lines) shapes.push_back(shape("polyline", style, points_json(view.seen(line))));
  for (Json& edge : front) shapes.push_back(std::move(edge));
  add_axes(shapes, view, {names[0], names[1], names[2]});
  ControlPolygon corners;
  for (const auto& vertex : polytope.vertices())
    corners.push_back(view.seen(SpacePoint{vertex[0].get_d(), vertex[1].get_d(), vertex[2].get_d()}));
  shapes.push_back(shape("points", "control", points_json(corners)));
  return space_panel(title, std::move(shapes));
}

/// The solver's polytope; drawn in two or three dimensions, counted in up to five.
Drawn draw_polytope(const std::filesystem::path& path, const Options& options) {
  const Problem problem = load_problem(path);
  if (is_exponential(problem.system)) return draw_exponential(problem);
  const SystemFunctions functions(problem.system);
  const Lifted lifted(functions, problem.system.box);
  const MonomialPolytope target = lifted.in_monomials(parts_from(options.word("inequalities")));
  if (target.monomials.size() < 2 || target.monomials.size() > 5)
    throw NotApplicable(
        fmt::format("the polytope has {} dimensions; 2 to 5 are taken", target.monomials.size()));
  const ExactPolytope polytope(target.half_spaces);
  Drawn drawn;
  tell_polytope(polytope, drawn.values);
  const std::vector<std::string> names = names_of(target.monomials, problem.system.variables);
  const std::string title = options.word("inequalities") == "products"    ? "products of bound factors"
                            : options.word("inequalities") == "published" ? "with squares about the midpoint"
                                                                          : "the solver's polytope";
  if (names.size() == 2) {
    const ExactPolytope products(lifted.in_monomials(PolytopeParts::products).half_spaces);
    drawn.panels.push_back(draw_in_plane(polytope, products, problem.system.box[0], names, title));
  } else if (names.size() == 3) {
    drawn.panels.push_back(draw_in_space(polytope, target.monomials, problem.system.box, names, title));
  }
  return drawn;
}

/// All Bernstein polynomials of the degree, not only products of two factors.
Drawn draw_simplex(const std::filesystem::path& path, const Options&) {
  const Problem problem = load_problem(path);
  const auto targets = problem.targets();
  if (problem.system.variables.size() != 1 || !targets.front().is_polynomial())
    throw NotApplicable("draws polynomials in one unknown");
  const int degree = targets.front().polynomial().total_degree();
  if (degree != 2 && degree != 3) throw NotApplicable("draws degrees 2 and 3");
  const Interval side = problem.system.box[0];
  const MonomialPolytope simplex = bernstein_simplex(Rational(side.lower), Rational(side.upper), degree);
  const ExactPolytope polytope(simplex.half_spaces);
  Drawn drawn;
  tell_polytope(polytope, drawn.values);
  const std::vector<std::string> names = names_of(simplex.monomials, problem.system.variables);
  const std::string title = fmt::format("all Bernstein polynomials of degree {}", degree);
  drawn.panels.push_back(degree == 2
                             ? draw_in_plane(polytope, polytope, side, names, title)
                             : draw_in_space(polytope, simplex.monomials, problem.system.box, names, title));
  return drawn;
}

}  // namespace

std::vector<Illustration> polytope_illustrations() {
  return {
      {"bernstein_polytope",
       "the polytope of the linear programs, in one coordinate a monomial; around exp, chord and tangents",
       draw_polytope,
       {parts_option("all")}},
      {"bernstein_simplex", "the polytope of all Bernstein polynomials of one degree in one unknown",
       draw_simplex},
      {"lp_reduction_steps",
       "the reduction of an interval by linear programs, step by step",
       draw_reduction,
       {integer_option("panels", "steps that are drawn", "steps", 3, 1, 12)}}};
}

}  // namespace gcslab
