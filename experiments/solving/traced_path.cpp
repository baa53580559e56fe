#include "experiments/solving/traced_path.h"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <numeric>

#include "base/error.h"

namespace gcslab {
namespace {

using Json = nlohmann::ordered_json;

/// Numbers of the unknowns, read off a figure in which each unknown is its number, from 1.
std::vector<std::vector<int>> coordinates_of(const GeometricEquations& equations) {
  std::vector<double> numbers(equations.unknowns.size());
  std::iota(numbers.begin(), numbers.end(), 1.0);
  const Figure figure = figure_at(equations, numbers);
  std::vector<std::vector<int>> result;
  for (const std::vector<double>& object : figure) {
    result.emplace_back();
    for (const double number : object) result.back().push_back(static_cast<int>(number) - 1);
  }
  return result;
}

double rounded(double number) {
  constexpr int kDigits = 8;
  return std::strtod(fmt::format("{:.{}g}", number, kDigits).c_str(), nullptr);
}

Json points_json(const std::vector<TracedPoint>& points) {
  Json list = Json::array();
  for (const TracedPoint& point : points) {
    Json numbers = Json::array();
    for (const double x : point.unknowns) numbers.push_back(rounded(x));
    numbers.push_back(rounded(point.t));
    list.push_back(std::move(numbers));
  }
  return list;
}

std::vector<TracedPoint> points_from(const Json& json, std::size_t unknowns) {
  std::vector<TracedPoint> points;
  for (const Json& entry : json) {
    auto numbers = entry.get<std::vector<double>>();
    if (numbers.size() != unknowns + 1) throw InputError("a path has a point without all its unknowns");
    const double t = numbers.back();
    numbers.pop_back();
    points.push_back({std::move(numbers), t});
  }
  return points;
}

void check(const TracedPath& path) {
  const auto is_known = [&](int number) {
    return number >= -1 && number < static_cast<int>(path.names.size());
  };
  for (const std::vector<int>& point : path.coordinates) {
    if (!std::ranges::all_of(point, is_known))
      throw InputError("a path names an unknown that it does not have");
  }
  if (path.sketch >= std::max<std::size_t>(1, path.points.size()))
    throw InputError("a path does not have the point that is its sketch");
}

}  // namespace

Figure TracedPath::figure(const TracedPoint& point) const {
  Figure result;
  for (const std::vector<int>& numbers : coordinates) {
    result.emplace_back();
    for (const int number : numbers)
      result.back().push_back(number < 0 ? 0 : point.unknowns[static_cast<std::size_t>(number)]);
  }
  return result;
}

TracedPath traced_path(const PathTrace& trace, const Path& path, const FigureCurve& curve,
                       const GeometricEquations& equations, std::size_t most) {
  const auto traced = [&](const std::vector<double>& v) { return TracedPoint{curve.unknowns(v), v.back()}; };
  TracedPath result{equations.unknowns, coordinates_of(equations), {}, 0, {}, {}};
  const PathTrace::Samples samples = trace.samples(most);
  for (const std::vector<double>& v : samples.points) result.points.push_back(traced(v));
  result.sketch = samples.start;
  for (const Crossing& crossing : path.crossings) result.crossings.push_back(traced(crossing.v));
  for (const BranchPoint& point : path.branch_points) result.critical.push_back(traced(point.v));
  return result;
}

Json to_json(const TracedPath& path) {
  return {{"unknowns", path.names},
          {"coordinates", path.coordinates},
          {"points", points_json(path.points)},
          {"sketch", path.sketch},
          {"crossings", points_json(path.crossings)},
          {"critical", points_json(path.critical)}};
}

TracedPath traced_path_from_json(const Json& json) {
  try {
    TracedPath path;
    path.names = json.at("unknowns").get<std::vector<std::string>>();
    path.coordinates = json.at("coordinates").get<std::vector<std::vector<int>>>();
    path.points = points_from(json.at("points"), path.names.size());
    path.sketch = json.at("sketch").get<std::size_t>();
    path.crossings = points_from(json.at("crossings"), path.names.size());
    path.critical = points_from(json.at("critical"), path.names.size());
    check(path);
    return path;
  } catch (const Json::exception& error) {
    throw InputError(std::string("no path: ") + error.what());
  }
}

}  // namespace gcslab
