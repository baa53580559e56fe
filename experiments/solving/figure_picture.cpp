#include "experiments/solving/figure_picture.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "geometry/congruence.h"
#include "geometry/sketch.h"

namespace gcslab {
namespace {

using Json = nlohmann::ordered_json;

std::vector<double> midpoints(const Box& box) {
  std::vector<double> result;
  for (const Interval& side : box) result.push_back(midpoint(side));
  return result;
}

/// A number of a point, checked.
std::size_t point_from(const Json& json, const Wireframe& wires) {
  const auto number = json.get<std::size_t>();
  if (number >= wires.names.size()) throw InputError("a drawing names a point that it does not have");
  return number;
}

void check_places(const Figure& points, const Wireframe& wires) {
  const auto has_place = [&](const std::vector<double>& point) {
    return (point.size() == 2 || point.size() == 3) && point.size() == points.front().size();
  };
  if (points.size() != wires.names.size() || !std::ranges::all_of(points, has_place))
    throw InputError("a drawing lacks coordinates of its points");
}

PicturedFigure figure_from(const Json& json, const Wireframe& wires) {
  PicturedFigure figure{json.at("points").get<Figure>(), json.at("solutions").get<std::size_t>(),
                        json.at("certified").get<bool>()};
  check_places(figure.points, wires);
  return figure;
}

std::vector<std::vector<std::size_t>> classes_of(const GeometricSource& source,
                                                 const std::vector<FigureBox>& boxes) {
  return congruence_classes(source.equations.sorts, source.equations.universe, boxes);
}

/// The points alone.
Figure points_of(const GeometricSource& source, Figure figure) {
  figure.resize(source.system.points());
  return figure;
}

}  // namespace

FigurePicture figure_picture(const GeometricSource& source, const SearchResult& found) {
  FigurePicture picture{wireframe_of(source.system, source.system.valuation(source.valuation)), {}};
  std::vector<FigureBox> boxes;
  for (const Solution& solution : found.solutions)
    boxes.push_back(figure_box(source.equations, solution.root.box));
  for (const std::vector<std::size_t>& members : classes_of(source, boxes)) {
    const Solution& first = found.solutions[members.front()];
    const auto is_certified = [&](std::size_t k) { return found.solutions[k].claim != Claim::none; };
    picture.figures.push_back(
        {reflected_upright(points_of(source, figure_at(source.equations, midpoints(first.root.box))),
                           source.frame),
         members.size(), std::ranges::any_of(members, is_certified)});
  }
  return picture;
}

Figure sketch_points(const GeometricSource& source, const Figure& sketch) {
  return points_of(source, in_frame(source.system, source.frame, sketch));
}

bool is_flat(const Figure& figure) {
  constexpr double kFlat = 1e-7;  // of the largest coordinate
  double size = 0, height = 0;
  for (const std::vector<double>& point : figure) {
    if (point.size() != 3) return false;
    for (const double x : point) size = std::max(size, std::abs(x));
    height = std::max(height, std::abs(point[2]));
  }
  return height <= kFlat * size;
}

Json to_json(const FigurePicture& picture) {
  const Wireframe& wires = picture.wires;
  Json edges = Json::array(), angles = Json::array(), classes = Json::array();
  for (const WireEdge& edge : wires.edges)
    edges.push_back({{"from", edge.from}, {"to", edge.to}, {"label", edge.label}, {"guide", edge.is_guide}});
  for (const WireAngle& angle : wires.angles)
    angles.push_back({{"at", angle.at}, {"from", angle.from}, {"to", angle.to}, {"label", angle.label}});
  for (const PicturedFigure& figure : picture.figures) {
    classes.push_back(
        {{"points", figure.points}, {"solutions", figure.solutions}, {"certified", figure.is_certified}});
  }
  return {{"figures",
           {{"names", wires.names},
            {"edges", std::move(edges)},
            {"faces", wires.faces},
            {"angles", std::move(angles)},
            {"classes", std::move(classes)},
            {"sketch", picture.sketch}}}};
}

FigurePicture figure_picture_from_json(const Json& json) {
  try {
    const Json& figures = json.at("figures");
    FigurePicture picture;
    Wireframe& wires = picture.wires;
    wires.names = figures.at("names").get<std::vector<std::string>>();
    const auto point = [&](const Json& number) { return point_from(number, wires); };
    for (const Json& edge : figures.at("edges"))
      wires.edges.push_back({point(edge.at("from")), point(edge.at("to")),
                             edge.at("label").get<std::string>(), edge.at("guide").get<bool>()});
    for (const Json& face : figures.at("faces")) {
      wires.faces.emplace_back();
      for (const Json& number : face) wires.faces.back().push_back(point(number));
    }
    for (const Json& angle : figures.at("angles"))
      wires.angles.push_back({point(angle.at("at")), point(angle.at("from")), point(angle.at("to")),
                              angle.at("label").get<std::string>()});
    for (const Json& figure : figures.at("classes")) picture.figures.push_back(figure_from(figure, wires));
    picture.sketch = figures.at("sketch").get<Figure>();
    if (!picture.sketch.empty()) check_places(picture.sketch, wires);
    return picture;
  } catch (const Json::exception& error) {
    throw InputError(std::string("no drawing of figures: ") + error.what());
  }
}

}  // namespace gcslab
