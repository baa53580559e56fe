#include "geometry/degeneracies.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "expression/tape_evaluator.h"

namespace gcslab {
namespace {

using Points = std::vector<std::size_t>;

/// Coordinates in space; those of the plane have z = 0.
struct Place {
  double x = 0, y = 0, z = 0;
};

Place operator-(const Place& a, const Place& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Place cross(const Place& a, const Place& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const Place& a, const Place& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double norm(const Place& a) { return std::sqrt(dot(a, a)); }

bool is_part_of(const Points& part, const Points& whole) { return std::ranges::includes(whole, part); }

/// Adds a set of points unless it is part of one that is there.
void add_largest(std::vector<Points>& sets, Points points) {
  std::ranges::sort(points);
  if (std::ranges::any_of(sets, [&](const Points& set) { return is_part_of(points, set); })) return;
  std::erase_if(sets, [&](const Points& set) { return is_part_of(set, points); });
  sets.push_back(std::move(points));
}

bool is_demanded(const ConstraintSystem& system, const std::string& kind, const Points& points) {
  return std::ranges::any_of(system.constraints, [&](const Constraint& constraint) {
    Points named = constraint.objects;
    std::ranges::sort(named);
    return constraint.kind->name == kind && constraint.kind->is_about_points() && named == points;
  });
}

class Search {
 public:
  Search(const ConstraintSystem& system, const Figure& figure, double near, double far)
      : system_(&system), near_(near) {
    for (std::size_t p = 0; p < system.points(); ++p)
      places_.push_back({figure[p][0], figure[p][1], figure[p].size() > 2 ? figure[p][2] : 0.0});
    for (std::size_t k = 0; k < figure.size(); ++k) {
      if (std::ranges::any_of(figure[k], [&](double x) { return std::abs(x) > far; })) {
        result_.far.push_back(k);
      } else if (k < places_.size() && !is_at_known_place(k)) {
        distinct_.push_back(k);
      }
    }
  }

  Degeneracies run() {
    std::erase_if(result_.coincident, [](const Points& set) { return set.size() < 2; });
    find_lines();
    if (system_->universe == Universe::space && distinct_.size() <= kPlanesAmong) find_planes();
    return std::move(result_);
  }

 private:
  static constexpr std::size_t kPlanesAmong = 60;

  /// Keeps the sets of points at one place.
  bool is_at_known_place(std::size_t p) {
    for (Points& set : result_.coincident) {
      if (norm(places_[p] - places_[set[0]]) > near_) continue;
      set.push_back(p);
      return true;
    }
    result_.coincident.push_back({p});
    return false;
  }

  void find_lines() {
    for (std::size_t i = 0; i < distinct_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Place from = places_[distinct_[j]], along = places_[distinct_[i]] - from;
        Points on_it;
        for (const std::size_t p : distinct_) {
          if (norm(cross(places_[p] - from, along)) <= near_ * norm(along)) on_it.push_back(p);
        }
        if (on_it.size() >= 3) add_largest(lines_, on_it);
      }
    }
    for (const Points& line : lines_) {
      if (!is_demanded(*system_, "collinear", line)) result_.collinear.push_back(line);
    }
  }

  bool are_collinear(std::size_t p, std::size_t q, std::size_t r) const {
    Points three = {p, q, r};
    std::ranges::sort(three);
    return std::ranges::any_of(lines_, [&](const Points& line) { return is_part_of(three, line); });
  }

  /// A line and one more point are always in a plane.
  bool is_line_and_point(const Points& points) const {
    return std::ranges::any_of(lines_, [&](const Points& line) {
      return std::ranges::count_if(
                 points, [&](std::size_t p) { return std::ranges::find(line, p) == line.end(); }) <= 1;
    });
  }

  void find_planes() {
    std::vector<Points> planes;
    for (std::size_t i = 0; i < distinct_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) {
          if (are_collinear(distinct_[i], distinct_[j], distinct_[k])) continue;
          const Place from = places_[distinct_[k]];
          const Place normal = cross(places_[distinct_[i]] - from, places_[distinct_[j]] - from);
          Points in_it;
          for (const std::size_t p : distinct_) {
            if (std::abs(dot(places_[p] - from, normal)) <= near_ * norm(normal)) in_it.push_back(p);
          }
          if (in_it.size() >= 4 && !is_line_and_point(in_it)) add_largest(planes, in_it);
        }
      }
    }
    result_.is_all_coplanar =
        planes.size() == 1 && planes[0].size() == distinct_.size() && distinct_.size() > 4;
    for (const Points& plane : planes) {
      if (!is_demanded(*system_, "coplanar", plane)) result_.coplanar.push_back(plane);
    }
  }

  const ConstraintSystem* system_;
  double near_;
  std::vector<Place> places_;
  Points distinct_;
  std::vector<Points> lines_;
  Degeneracies result_;
};

}  // namespace

Degeneracies degeneracies_of(const ConstraintSystem& system, const Figure& figure, double unit,
                             double tolerance, double far) {
  return Search(system, figure, tolerance * unit, far * unit).run();
}

std::string text_of(const Degeneracies& degeneracies, const ConstraintSystem& system) {
  std::vector<std::string> parts;
  const auto names = [&](const Points& points) {
    std::vector<std::string> result;
    for (const std::size_t p : points) result.push_back(system.objects[p].name);
    return fmt::format("{}", fmt::join(result, ", "));
  };
  for (const Points& set : degeneracies.coincident) parts.push_back(names(set) + " coincide");
  for (const Points& set : degeneracies.collinear) parts.push_back(names(set) + " are collinear");
  if (degeneracies.is_all_coplanar) {
    parts.emplace_back("all points are coplanar");
  } else {
    for (const Points& set : degeneracies.coplanar) parts.push_back(names(set) + " are coplanar");
  }
  if (!degeneracies.far.empty())
    parts.push_back(names(degeneracies.far) + (degeneracies.far.size() > 1 ? " go" : " goes") +
                    " to infinity");
  return fmt::format("{}", fmt::join(parts, "; "));
}

std::optional<std::size_t> constraint_not_smooth_at(const ConstraintSystem& system, const Figure& figure,
                                                    double unit, double tolerance) {
  ExpressionGraph graph;
  const std::vector<Vector> variables = coordinate_variables(system, graph);
  const std::vector<double> coordinates = coordinates_in_order(figure);
  for (std::size_t c = 0; c < system.constraints.size(); ++c) {
    const Constraint& constraint = system.constraints[c];
    const Interpretation& chosen = constraint.kind->interpretations[constraint.interpretation];
    if (!chosen.not_smooth_at) continue;
    const std::vector<Expression> vanishing = chosen.not_smooth_at(system.place(constraint, variables));
    const Tape tape(vanishing, static_cast<int>(coordinates.size()));
    TapeEvaluator<double> evaluator(tape);
    evaluator.evaluate(coordinates);
    for (std::size_t k = 0; k < vanishing.size(); ++k) {
      if (!(std::abs(evaluator.value(k)) > tolerance * tolerance * unit * unit)) return c;  // squared lengths
    }
  }
  return std::nullopt;
}

}  // namespace gcslab
