#include "experiments/corpus/figure_family.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/check.h"
#include "base/random.h"

namespace gcslab {
namespace {

using Point = std::vector<Rational>;
using Edge = std::pair<std::size_t, std::size_t>;

constexpr long kStepsPerUnit = 1 << 20;

/// What a family draws.
struct Drawing {
  Universe universe = Universe::space;
  std::vector<Point> sketch, wanted;
  std::set<Edge> edges;
  std::vector<std::vector<std::size_t>> flats;  ///< four points each, in a plane
  Frame frame;
};

/// The nearest multiple of 1 / steps.
Rational rounded(double value, long steps = kStepsPerUnit) {
  Rational result(std::lround(value * static_cast<double>(steps)), steps);
  result.canonicalize();
  return result;
}

double random_move(Random& random, double most) { return random.uniform(-most, most); }

void add_edge(Drawing& drawing, std::size_t a, std::size_t b) { drawing.edges.insert(std::minmax(a, b)); }

/// Triangulates the part of a convex polygon on one side of the diagonal from `first` to `last`.
void triangulate(Drawing& drawing, std::size_t first, std::size_t last, Random& random) {
  add_edge(drawing, first, last);
  if (last - first < 2) return;
  const std::size_t middle = first + 1 + random.below(last - first - 1);
  triangulate(drawing, first, middle, random);
  triangulate(drawing, middle, last, random);
}

Drawing polygon(std::size_t n, double perturbation, Random& random) {
  constexpr double kIrregularity = 0.2;
  Drawing drawing;
  drawing.universe = Universe::plane;
  drawing.frame = {0, 1};
  const double turn = 2 * std::numbers::pi / static_cast<double>(n);
  const auto on_circle = [&](double place) -> Point {
    return {rounded(std::cos(turn * place) / turn), rounded(std::sin(turn * place) / turn)};
  };
  for (std::size_t i = 0; i < n; ++i) {
    const double place = static_cast<double>(i) + random_move(random, kIrregularity);
    drawing.sketch.push_back(on_circle(place));
    drawing.wanted.push_back(on_circle(place + random_move(random, perturbation)));
  }
  triangulate(drawing, 0, n - 1, random);
  return drawing;
}

/// Points of a sphere on which triangles of n points have sides of about 1, in steps of 2^-10.
std::vector<std::array<std::int64_t, 3>> points_of_sphere(std::size_t n, Random& random) {
  constexpr double kIrregularity = 0.3;
  constexpr double kSteps = 1 << 10;
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  const double triangles = 2 * static_cast<double>(n) - 4;
  const double radius = std::sqrt(triangles * std::sqrt(3.0) / (16 * std::numbers::pi));
  std::vector<std::array<std::int64_t, 3>> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(n);
    const double r = std::sqrt(1 - z * z), turn = golden * static_cast<double>(i);
    std::array<double, 3> place = {radius * r * std::cos(turn), radius * r * std::sin(turn), radius * z};
    for (double& x : place) x += random_move(random, kIrregularity);
    const double length = std::hypot(place[0], place[1], place[2]);
    points.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis)
      points.back()[axis] = std::lround(place[axis] / length * radius * kSteps);
  }
  return points;
}

/// Edges of the convex hull: a triangle is a face when all other points are strictly on one side of it.
std::set<Edge> hull_edges(const std::vector<std::array<std::int64_t, 3>>& points) {
  const std::size_t n = points.size();
  const auto is_face = [&](std::size_t a, std::size_t b, std::size_t c) {
    std::array<std::int64_t, 3> u{}, v{}, w{};
    for (std::size_t k = 0; k < 3; ++k)
      u[k] = points[b][k] - points[a][k], v[k] = points[c][k] - points[a][k];
    const std::array<std::int64_t, 3> normal = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                                u[0] * v[1] - u[1] * v[0]};
    bool is_some_above = false, is_some_below = false;
    for (std::size_t d = 0; d < n; ++d) {
      if (d == a || d == b || d == c) continue;
      for (std::size_t k = 0; k < 3; ++k) w[k] = points[d][k] - points[a][k];
      const std::int64_t side = normal[0] * w[0] + normal[1] * w[1] + normal[2] * w[2];
      is_some_above = is_some_above || side >= 0;
      is_some_below = is_some_below || side <= 0;
      if (is_some_above && is_some_below) return false;
    }
    return true;
  };
  std::set<Edge> edges;
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a + 1; b < n; ++b) {
      for (std::size_t c = b + 1; c < n; ++c) {
        if (is_face(a, b, c)) edges.insert({Edge(a, b), Edge(b, c), Edge(a, c)});
      }
    }
  }
  return edges;
}

Drawing triangulated_polyhedron(std::size_t n, double perturbation, Random& random) {
  Drawing drawing;
  std::vector<std::array<std::int64_t, 3>> points;
  do {  // again where four points of the hull are in a plane, or a point is inside
    points = points_of_sphere(n, random);
    drawing.edges = hull_edges(points);
  } while (drawing.edges.size() != 3 * n - 6);
  for (const auto& point : points) {
    drawing.sketch.emplace_back();
    drawing.wanted.emplace_back();
    for (const std::int64_t x : point) {
      drawing.sketch.back().push_back(rounded(static_cast<double>(x) / (1 << 10)));
      drawing.wanted.back().push_back(drawing.sketch.back().back() +
                                      rounded(random_move(random, perturbation)));
    }
  }
  const std::size_t second = drawing.edges.begin()->second;
  const auto is_third = [&](std::size_t k) {
    return drawing.edges.contains(Edge(0, k)) && drawing.edges.contains(std::minmax(second, k));
  };
  std::size_t third = 1;
  while (!is_third(third)) ++third;
  drawing.frame = {0, second, third};
  return drawing;
}

/// normal . X = offset.
struct Plane {
  std::array<Rational, 3> normal;
  Rational offset;
};

Rational determinant(const std::array<Rational, 3>& a, const std::array<Rational, 3>& b,
                     const std::array<Rational, 3>& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// By Cramer's rule.
Point common_point(const Plane& a, const Plane& b, const Plane& c) {
  const Rational all = determinant(a.normal, b.normal, c.normal);
  GCSLAB_CHECK(all != 0);
  Point point;
  for (std::size_t k = 0; k < 3; ++k) {
    auto u = a.normal, v = b.normal, w = c.normal;
    u[k] = a.offset, v[k] = b.offset, w[k] = c.offset;
    point.push_back(determinant(u, v, w) / all);
  }
  return point;
}

Plane moved(Plane plane, double most, Random& random) {
  for (Rational& x : plane.normal) x += rounded(random_move(random, most));
  plane.offset += rounded(random_move(random, most));
  return plane;
}

/// The vertices of the base in turn, then those of the top: face k is lateral, the last two base and top.
std::vector<Point> vertices_of_prism(const std::vector<Plane>& planes) {
  const std::size_t k = planes.size() - 2;
  std::vector<Point> points;
  for (std::size_t end = k; end < k + 2; ++end) {
    for (std::size_t i = 0; i < k; ++i)
      points.push_back(common_point(planes[i], planes[(i + 1) % k], planes[end]));
  }
  return points;
}

Drawing prism(std::size_t k, double perturbation, Random& random) {
  constexpr double kIrregularity = 0.2;
  const double part = 4 / static_cast<double>(k);
  const double turn = 2 * std::numbers::pi / static_cast<double>(k);
  const double inradius = 1 / (2 * std::tan(turn / 2));
  std::vector<Plane> planes;
  for (std::size_t i = 0; i < k; ++i) {
    const double angle = turn * static_cast<double>(i);
    planes.push_back({{rounded(std::cos(angle)), rounded(std::sin(angle)), 0}, rounded(inradius)});
  }
  planes.push_back({{0, 0, 1}, 0});
  planes.push_back({{0, 0, 1}, 1});
  for (Plane& plane : planes) plane = moved(plane, part * kIrregularity, random);
  Drawing drawing;
  drawing.sketch = vertices_of_prism(planes);
  for (Plane& plane : planes) plane = moved(plane, part * perturbation, random);
  drawing.wanted = vertices_of_prism(planes);
  drawing.frame = {0, k / 3, 2 * k / 3};
  for (std::size_t i = 0; i < k; ++i) {
    const std::size_t next = (i + 1) % k;
    add_edge(drawing, i, next);
    add_edge(drawing, k + i, k + next);
    add_edge(drawing, i, k + i);
    drawing.flats.push_back({i, next, k + i, k + next});
  }
  for (const std::size_t first : {std::size_t{0}, k}) {
    for (std::size_t i = 0; i < k; ++i) {
      if (std::ranges::find(drawing.frame, i) == drawing.frame.end())
        drawing.flats.push_back({first, first + k / 3, first + 2 * k / 3, first + i});
    }
  }
  return drawing;
}

Rational squared_distance(const Point& a, const Point& b) {
  Rational sum = 0;
  for (std::size_t axis = 0; axis < a.size(); ++axis) sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
  return sum;
}

ConstraintSystem system_of(const Drawing& drawing) {
  ConstraintSystem system;
  system.universe = drawing.universe;
  for (std::size_t k = 0; k < drawing.sketch.size(); ++k)
    system.objects.push_back({"P" + std::to_string(k), Sort::point});
  Valuation wanted{"wanted", {}};
  const ConstraintKind& distance = constraint_registry().at("distance");
  for (const auto& [a, b] : drawing.edges) {
    system.constraints.push_back({&distance, {a, b}, system.parameters.size()});
    system.parameters.push_back("h" + std::to_string(system.parameters.size()));
    wanted.values.push_back(system.values_graph->apply(
        Operation::sqrt,
        system.values_graph->constant(squared_distance(drawing.wanted[a], drawing.wanted[b]))));
  }
  const ConstraintKind& coplanar = constraint_registry().at("coplanar");
  for (const auto& flat : drawing.flats) system.constraints.push_back({&coplanar, flat, std::nullopt});
  system.valuations.push_back(std::move(wanted));
  system.frame = drawing.frame;
  Figure sketch;
  for (const Point& point : drawing.sketch) {
    sketch.emplace_back();
    for (const Rational& x : point) sketch.back().push_back(nearest_double(x));
  }
  system.sketch = std::move(sketch);
  return system;
}

struct Family {
  std::string name;
  std::string size_key;
  int least_size;
  Drawing (*draw)(std::size_t size, double perturbation, Random& random);
};

const std::vector<Family>& families() {
  static const std::vector<Family> all = {
      {"polygon", "vertices", 3, polygon},
      {"prism", "sides", 3, prism},
      {"triangulated_polyhedron", "vertices", 4, triangulated_polyhedron},
  };
  return all;
}

const Family& family_named(const std::string& name) {
  const auto found = std::ranges::find(families(), name, &Family::name);
  GCSLAB_CHECK(found != families().end());
  return *found;
}

}  // namespace

const std::vector<std::string>& figure_families() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const Family& family : families()) result.push_back(family.name);
    return result;
  }();
  return names;
}

std::string size_key(const std::string& family) { return family_named(family).size_key; }

int least_size(const std::string& family) { return family_named(family).least_size; }

FamilyFigure family_figure(const FigureFamilyOptions& options) {
  const Family& family = family_named(options.family);
  GCSLAB_CHECK(options.size >= family.least_size);
  Random random(options.seed, options.family);
  Drawing drawing =
      family.draw(static_cast<std::size_t>(options.size), nearest_double(options.perturbation), random);
  return {system_of(drawing), std::move(drawing.wanted)};
}

}  // namespace gcslab
