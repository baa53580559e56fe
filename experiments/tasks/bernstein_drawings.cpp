// Drawings of Bernstein polynomials and de Casteljau's algorithm (Tahari 2011, figures 4.1 to 4.4).

#include <algorithm>
#include <fmt/format.h>

#include "base/yaml_reader.h"
#include "experiments/corpus/problem.h"
#include "experiments/tasks/illustrate_task.h"
#include "experiments/tasks/illustration.h"
#include "polynomial/bernstein.h"

namespace gcslab {
namespace {

struct Halves {
  ControlPolygon left, right;
};

/// De Casteljau at 1/2; the rows of the triangle go to `rows` when it is given.
Halves de_casteljau(ControlPolygon row, std::vector<ControlPolygon>* rows = nullptr) {
  Halves halves;
  while (true) {
    if (rows != nullptr) rows->push_back(row);
    halves.left.push_back(row.front());
    halves.right.insert(halves.right.begin(), row.back());
    if (row.size() == 1) return halves;
    ControlPolygon next;
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      next.push_back({(row[i][0] + row[i + 1][0]) / 2, (row[i][1] + row[i + 1][1]) / 2});
    }
    row = next;
  }
}

/// The curve of a control polygon by repeated halving.
ControlPolygon curve_points(const ControlPolygon& polygon, int halvings) {
  if (halvings == 0) return {polygon.front(), polygon.back()};
  const Halves halves = de_casteljau(polygon);
  ControlPolygon points = curve_points(halves.left, halvings - 1);
  const ControlPolygon rest = curve_points(halves.right, halvings - 1);
  points.insert(points.end(), rest.begin() + 1, rest.end());
  return points;
}

/// The graph of a polynomial in one variable on its box as a control polygon: (i/d, b_i) on the box.
ControlPolygon graph_polygon(const Problem& problem) {
  const RationalBox box = rational_box(problem.system.box);
  const auto tensor = bernstein_from_polynomial<Rational>(problem.targets().front().polynomial(), box);
  const int degree = tensor.degree(0);
  ControlPolygon polygon;
  for (int i = 0; i <= degree; ++i) {
    const Rational x = box[0].lower + (box[0].upper - box[0].lower) * Rational(i, std::max(degree, 1));
    polygon.push_back({x, tensor.coefficients()[static_cast<std::size_t>(i)]});
  }
  return polygon;
}

ControlPolygon read_control_points(const std::filesystem::path& path) {
  const YamlNode file = YamlNode::load_file(path);
  file.allow_keys({"kind", "name", "title", "control_points", "origin", "licence", "notes"});
  ControlPolygon polygon;
  for (const YamlNode& item : file.at("control_points").items()) {
    const std::vector<std::string> coordinates = item.texts();
    if (coordinates.size() != 2) item.fail("must be [x, y]");
    polygon.push_back({rational_from_text(coordinates[0]), rational_from_text(coordinates[1])});
  }
  if (polygon.size() < 2) file.at("control_points").fail("must list two points or more");
  return polygon;
}

std::vector<int> read_degrees(const std::filesystem::path& path) {
  const YamlNode file = YamlNode::load_file(path);
  file.allow_keys({"kind", "name", "title", "degrees", "origin", "licence", "notes"});
  std::vector<int> degrees;
  for (const YamlNode& item : file.at("degrees").items()) {
    const std::int64_t degree = item.integer();
    if (degree < 1 || degree > 20) item.fail("must lie in [1, 20]");
    degrees.push_back(static_cast<int>(degree));
  }
  return degrees;
}

ControlPolygon polygon_of(const std::filesystem::path& path) {
  if (kind_of_file(path) == "bezier_curve") return read_control_points(path);
  const Problem problem = load_problem(path);
  if (problem.kind != "function" || problem.system.variables.size() != 1) {
    throw NotApplicable("draws polynomials in one variable and Bezier curves");
  }
  return graph_polygon(problem);
}

/// All Bernstein polynomials of a degree over the unit square (Tahari 2011, figure 4.1).
Json basis_panel(int degree) {
  constexpr int kSteps = 100;
  Json shapes = Json::array();
  for (int i = 0; i <= degree; ++i) {
    ControlPolygon graph;
    for (int s = 0; s <= kSteps; ++s) {
      const Rational x(s, kSteps);
      mpz_class binomial;
      mpz_bin_uiui(binomial.get_mpz_t(), static_cast<unsigned long>(degree), static_cast<unsigned long>(i));
      Rational value = binomial;
      for (int k = 0; k < degree; ++k) value *= k < i ? x : 1 - x;
      graph.push_back({x, value});
    }
    shapes.push_back(shape("polyline", i % 2 == 0 ? "curve" : "accent", points_json(graph)));
  }
  return {{"title", fmt::format("degree {}", degree)},
          {"aspect", "equal"},
          {"x", {0, 1}},
          {"y", {0, 1}},
          {"xlabel", "x"},
          {"shapes", shapes}};
}

Drawn draw_basis(const std::filesystem::path& path, const Options&) {
  Json panels = Json::array();
  for (const int degree : read_degrees(path)) panels.push_back(basis_panel(degree));
  return {panels};
}

/// The control polygon after 0, 1, 2 iterations, with the convex hulls of the pieces (figures 4.2 and 4.3).
Drawn draw_hulls(const std::filesystem::path& path, const Options&) {
  const ControlPolygon whole = polygon_of(path);
  const Json curve = points_json(curve_points(whole, 7));
  const bool free_curve = kind_of_file(path) == "bezier_curve";
  std::vector<ControlPolygon> pieces = {whole};
  Json panels = Json::array();
  for (int iteration = 0; iteration <= 2; ++iteration) {
    Json shapes = Json::array();
    for (const ControlPolygon& piece : pieces)
      shapes.push_back(shape("polygon", "hull", points_json(convex_hull(piece))));
    shapes.push_back(shape("polyline", "curve", curve));
    for (const ControlPolygon& piece : pieces) {
      shapes.push_back(shape("polyline", "control", points_json(piece)));
      shapes.push_back(shape("points", "control", points_json(piece)));
    }
    panels.push_back(
        {{"title", iteration == 0 ? "control points"
                                  : fmt::format("{} iteration{}", iteration, iteration > 1 ? "s" : "")},
         {"aspect", free_curve ? "equal" : "free"},
         {"x", limits_around(whole, 0)},
         {"y", limits_around(whole, 1)},
         {"xlabel", "x"},
         {"ylabel", "y"},
         {"shapes", shapes}});
    std::vector<ControlPolygon> halves;
    for (const ControlPolygon& piece : pieces) {
      const Halves both = de_casteljau(piece);
      halves.push_back(both.left);
      halves.push_back(both.right);
    }
    pieces = halves;
  }
  return {panels};
}

/// The triangle of midpoints with its numbers; the left half stands on one side, the right half on the other
/// (4.4).
Drawn draw_triangle(const std::filesystem::path& path, const Options&) {
  std::vector<ControlPolygon> rows;
  static_cast<void>(de_casteljau(polygon_of(path), &rows));
  const auto node = [&](std::size_t level, std::size_t i) {
    return RationalPoint{Rational(static_cast<long>(2 * i + level), 2), Rational(-static_cast<long>(level))};
  };
  Json shapes = Json::array();
  for (std::size_t level = 1; level < rows.size(); ++level) {
    for (std::size_t i = 0; i < rows[level].size(); ++i) {
      for (const std::size_t parent : {i, i + 1}) {
        shapes.push_back(shape("segment", "muted", points_json({node(level - 1, parent), node(level, i)})));
      }
    }
  }
  for (std::size_t level = 0; level < rows.size(); ++level) {
    for (std::size_t i = 0; i < rows[level].size(); ++i) {
      const bool left = i == 0, right = i + 1 == rows[level].size();
      const char* style = left && !right ? "curve" : right && !left ? "accent" : "axis";
      shapes.push_back(
          shape("label", style, Json::array({point_json(node(level, i))}), rows[level][i][1].get_str()));
    }
  }
  const double last = static_cast<double>(rows.size()) - 1;
  return {Json::array({{{"title", ""},
                        {"aspect", "free"},
                        {"frame", false},
                        {"x", {-0.5, last + 0.5}},
                        {"y", {-last - 0.4, 0.4}},
                        {"shapes", shapes}}})};
}

}  // namespace

std::vector<Illustration> bernstein_illustrations() {
  return {
      {"bernstein_basis", "the Bernstein polynomials of some degrees", draw_basis},
      {"de_casteljau_hulls", "two de Casteljau iterations with the hulls of the control points", draw_hulls},
      {"de_casteljau_triangle", "the triangle of midpoints, with its numbers", draw_triangle}};
}

void check_illustration(const std::filesystem::path& path) {
  const YamlNode file = YamlNode::load_file(path);
  const std::string kind = file.at("kind").text();
  if (kind == "bezier_curve") {
    static_cast<void>(read_control_points(path));
  } else if (kind == "bernstein_basis") {
    static_cast<void>(read_degrees(path));
  } else if (kind == "bernstein_family") {
    file.allow_keys({"kind", "name", "title", "origin", "licence", "notes"});
  } else {
    file.at("kind").fail("is '" + kind + "', which is no kind of problem");
  }
}

}  // namespace gcslab
