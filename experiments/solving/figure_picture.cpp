#include "experiments/solving/figure_picture.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "geometry/congruence.h"

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

/// All points have two coordinates, or all three, and objects what their sort has there.
void check_places(const Figure& places, const Wireframe& wires) {
  const std::vector<Sort> sorts = wires.sorts();
  const auto fits = [&](Universe universe) {
    for (std::size_t k = 0; k < sorts.size(); ++k) {
      if (!exists_in(sorts[k], universe) || places[k].size() != coordinate_names(sorts[k], universe).size())
        return false;
    }
    return true;
  };
  if (places.size() != sorts.size() || !(fits(Universe::plane) || fits(Universe::space)))
    throw InputError("a drawing lacks coordinates of its points");
}

Sort sort_named(const std::string& name) {
  const auto found = std::ranges::find(all_sorts(), name, [](Sort sort) { return name_of(sort); });
  if (found == all_sorts().end()) throw InputError("a drawing has an object of an unknown sort, " + name);
  return *found;
}

/// Rows that were written before objects were drawn have none.
void read_objects(const Json& figures, Wireframe& wires) {
  if (!figures.contains("objects")) return;
  for (const Json& object : figures.at("objects"))
    wires.objects.push_back(
        {object.at("name").get<std::string>(), sort_named(object.at("sort").get<std::string>())});
  for (const Json& measure : figures.at("measures")) {
    wires.measures.push_back({measure.at("kind").get<std::string>(),
                              measure.at("objects").get<std::vector<std::size_t>>(),
                              measure.at("label").get<std::string>()});
    for (const std::size_t number : wires.measures.back().objects) {
      if (number >= wires.names.size() + wires.objects.size())
        throw InputError("a drawing measures an object that it does not have");
    }
  }
}

PicturedFigure figure_from(const Json& json, const Wireframe& wires) {
  PicturedFigure figure{json.at("points").get<Figure>(), json.at("solutions").get<std::size_t>(),
                        json.at("certified").get<bool>()};
  check_places(figure.places, wires);
  return figure;
}

}  // namespace

std::vector<std::vector<std::size_t>> classes_of(const GeometricSource& source, const SearchResult& found) {
  constexpr double kUncertified = 1e-7;  // as where a path's solutions are told apart
  std::vector<FigureBox> boxes;
  for (const Solution& solution : found.solutions) {
    Box box = solution.root.box;
    double size = 0;
    for (const Interval& side : box) size = std::max(size, magnitude(side));
    if (solution.claim == Claim::none) {
      for (Interval& side : box)
        side = Interval(side.lower - kUncertified * size, side.upper + kUncertified * size);
    }
    boxes.push_back(figure_box(source.equations, box));
  }
  return congruence_classes(source.equations.sorts, source.equations.universe, boxes);
}

FigurePicture figure_picture(const GeometricSource& source, const SearchResult& found) {
  FigurePicture picture{wireframe_of(source.system, source.system.valuation(source.valuation)), {}};
  for (const std::vector<std::size_t>& members : classes_of(source, found)) {
    const Solution& first = found.solutions[members.front()];
    const auto is_certified = [&](std::size_t k) { return found.solutions[k].claim != Claim::none; };
    picture.figures.push_back({reflected_upright(figure_at(source.equations, midpoints(first.root.box)),
                                                 source.equations.sorts, source.frame),
                               members.size(), std::ranges::any_of(members, is_certified)});
  }
  return picture;
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
  Json objects = Json::array(), measures = Json::array();
  for (const WireObject& object : wires.objects)
    objects.push_back({{"name", object.name}, {"sort", name_of(object.sort)}});
  for (const WireMeasure& measure : wires.measures)
    measures.push_back({{"kind", measure.kind}, {"objects", measure.objects}, {"label", measure.label}});
  for (const PicturedFigure& figure : picture.figures) {
    classes.push_back(
        {{"points", figure.places}, {"solutions", figure.solutions}, {"certified", figure.is_certified}});
  }
  Json new_sketches = Json::array();
  for (const FigurePicture::NewSketch& sketch : picture.new_sketches)
    new_sketches.push_back({{"origin", sketch.origin}, {"points", sketch.places}});
  Json result = {{"figures",
                  {{"names", wires.names},
                   {"edges", std::move(edges)},
                   {"faces", wires.faces},
                   {"angles", std::move(angles)},
                   {"objects", std::move(objects)},
                   {"measures", std::move(measures)},
                   {"classes", std::move(classes)},
                   {"sketch", picture.sketch}}}};
  if (!new_sketches.empty()) result["figures"]["new_sketches"] = std::move(new_sketches);
  return result;
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
    read_objects(figures, wires);
    for (const Json& figure : figures.at("classes")) picture.figures.push_back(figure_from(figure, wires));
    picture.sketch = figures.at("sketch").get<Figure>();
    if (!picture.sketch.empty()) check_places(picture.sketch, wires);
    if (!figures.contains("new_sketches")) return picture;
    for (const Json& sketch : figures.at("new_sketches")) {
      picture.new_sketches.push_back(
          {sketch.at("origin").get<std::string>(), sketch.at("points").get<Figure>()});
      check_places(picture.new_sketches.back().places, wires);
    }
    return picture;
  } catch (const Json::exception& error) {
    throw InputError(std::string("no drawing of figures: ") + error.what());
  }
}

}  // namespace gcslab
