#include "experiments/tasks/polytope_panel.h"

#include <fmt/format.h>

namespace gcslab {
namespace {

std::string monomial_text(const Exponents& exponents, const std::vector<std::string>& variables) {
  std::string text;
  for (std::size_t i = 0; i < exponents.size(); ++i) {
    if (exponents[i] == 0) continue;
    if (!text.empty()) text += " ";
    text += variables[i];
    if (exponents[i] > 1)
      text += exponents[i] == 2 ? "²" : exponents[i] == 3 ? "³" : fmt::format("^{}", exponents[i]);
  }
  return text;
}

}  // namespace

std::vector<std::string> names_of(const std::vector<Exponents>& monomials,
                                  const std::vector<std::string>& variables) {
  std::vector<std::string> names;
  for (const Exponents& monomial : monomials) names.push_back(monomial_text(monomial, variables));
  return names;
}

ControlPolygon polygon_of(const ExactPolytope& polytope) {
  ControlPolygon points;
  for (const auto& vertex : polytope.vertices()) points.push_back({vertex[0], vertex[1]});
  return convex_hull(points);
}

ControlPolygon graph_points(const Rational& lower, const Rational& upper, int steps,
                            const std::function<Rational(const Rational&)>& value) {
  ControlPolygon result;
  for (int s = 0; s <= steps; ++s) {
    const Rational x = lower + (upper - lower) * Rational(s) / steps;
    result.push_back({x, value(x)});
  }
  return result;
}

ControlPolygon parabola_points(const Interval& side) {
  return graph_points(Rational(side.lower), Rational(side.upper), 64,
                      [](const Rational& x) { return Rational(x * x); });
}

Json plane_panel(const std::string& title, const ControlPolygon& around, const std::string& xlabel,
                 const std::string& ylabel, Json shapes) {
  return {{"title", title},
          {"aspect", "free"},
          {"x", limits_around(around, 0)},
          {"y", limits_around(around, 1)},
          {"xlabel", xlabel},
          {"ylabel", ylabel},
          {"shapes", std::move(shapes)}};
}

}  // namespace gcslab
