#include "experiments/tasks/plan_path_view.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <fmt/format.h>
#include <limits>
#include <map>

#include "base/error.h"
#include "experiments/corpus/problem_loader.h"
#include "geometry/sketch.h"

namespace gcslab {
namespace {

/// The border between two kinds of points of a plane on a grid, each point of it found by halving a side of a
/// square (marching squares: Lorensen, Cline 1987, in the plane).
template <class Inside>
class BorderTrace {
 public:
  BorderTrace(const GuideRange& range, int resolution, const Inside& is_inside)
      : range_(range), resolution_(resolution), is_inside_(is_inside) {
    for (int j = 0; j <= resolution; ++j) {
      for (int i = 0; i <= resolution; ++i) flags_.push_back(is_inside_(corner(i, j)));
    }
  }

  std::vector<GuideLine> lines() {
    for (int j = 0; j < resolution_; ++j) {
      for (int i = 0; i < resolution_; ++i) add_square(i, j);
    }
    std::vector<GuideLine> result;
    for (const bool is_from_end : {true, false}) {  // closed lines have no end
      for (const auto& [side, others] : next_) {
        if (!is_visited_[side] && (!is_from_end || others.size() == 1)) result.push_back(line_from(side));
      }
    }
    return result;
  }

 private:
  /// The square's lower (left) side: i, j, and whether it is upright.
  using Side = std::array<int, 3>;

  GuidePoint corner(int i, int j) const {
    const auto at = [&](std::size_t axis, int k) {
      return range_.low[axis] + (range_.high[axis] - range_.low[axis]) * k / resolution_;
    };
    return {at(0, i), at(1, j)};
  }
  bool flag(int i, int j) const {
    return flags_[static_cast<std::size_t>(j) * static_cast<std::size_t>(resolution_ + 1) +
                  static_cast<std::size_t>(i)];
  }

  void add_square(int i, int j) {
    std::vector<Side> sides;
    if (flag(i, j) != flag(i + 1, j)) sides.push_back({i, j, 0});
    if (flag(i, j) != flag(i, j + 1)) sides.push_back({i, j, 1});
    if (flag(i, j + 1) != flag(i + 1, j + 1)) sides.push_back({i, j + 1, 0});
    if (flag(i + 1, j) != flag(i + 1, j + 1)) sides.push_back({i + 1, j, 1});
    for (std::size_t k = 0; k + 1 < sides.size(); k += 2) {
      next_[sides[k]].push_back(sides[k + 1]);
      next_[sides[k + 1]].push_back(sides[k]);
    }
  }

  GuidePoint place(const Side& side) const {
    GuidePoint a = corner(side[0], side[1]),
               b = corner(side[0] + (side[2] == 0 ? 1 : 0), side[1] + (side[2] == 1 ? 1 : 0));
    const bool is_first_inside = is_inside_(a);
    for (int k = 0; k < 40; ++k) {
      const GuidePoint middle = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
      (is_inside_(middle) == is_first_inside ? a : b) = middle;
    }
    return a;
  }

  GuideLine line_from(Side side) {
    GuideLine line;
    for (bool is_going = true; is_going;) {
      line.push_back(place(side));
      is_visited_[side] = true;
      const auto found =
          std::ranges::find_if(next_[side], [&](const Side& other) { return !is_visited_[other]; });
      is_going = found != next_[side].end();
      if (is_going) side = *found;
    }
    return line;
  }

  GuideRange range_;
  int resolution_;
  const Inside& is_inside_;
  std::vector<bool> flags_;
  std::map<Side, std::vector<Side>> next_;
  std::map<Side, bool> is_visited_;
};

}  // namespace

PlanPathView::PlanPathView(const std::filesystem::path& path) : problem_(load_system(path.string())) {
  const GeometricSource& source = *problem_.geometry;
  const std::optional<Figure> sketch = sketch_of(source.system);
  if (!sketch) throw NotApplicable("the problem has no sketch");
  const std::vector<double> wanted = values_of(source.system.valuation(source.valuation));
  sketched_.emplace(source.system, source.frame, source.equations, wanted, *sketch);
  homotopy_.emplace(source.system, source.frame, source.equations, *sketched_, PlanKind::least);
  if (plan().guides.size() != 1)
    throw NotApplicable(
        fmt::format("the plan has {} guide parameters, and one is drawn", plan().guides.size()));
  map_.emplace(homotopy_->motion());
}

std::string PlanPathView::guide_text() const {
  const Guide& guide = plan().guides.front();
  return "k0 = distance " + system().objects[guide.point].name + " " + system().objects[guide.centre].name;
}

PlanPathView::Followed PlanPathView::follow(double mesh) {
  struct Seen {
    GuidePoint point;
    Branch branch;
  };
  std::deque<Seen> seen;
  const PlanValues& start = homotopy_->start();
  Branch branch;
  for (const double height : start.heights) branch.push_back(height < 0);
  const GuidePoint sketch = {start.guides.front(), 0};
  seen.push_back({sketch, branch});
  PlanSimplexOptions options;
  options.mesh = mesh;
  const PlanSimplexPath found =
      follow_plan_simplices(*map_, start, options, {}, [&](const PassedSimplex& simplex) {
        const Seen here = {point_of(simplex.on_curve), simplex.branch};
        if (simplex.direction > 0) {
          seen.push_back(here);
        } else {
          seen.push_front(here);
        }
      });
  Followed result;
  result.sketch = sketch;
  result.simplices = found.simplices;
  result.is_cycle = found.end == PathEnd::cycle;
  if (result.simplices < 2) throw NotApplicable("the path cannot be followed: " + found.failure);
  // The follower changes its branch a little after the border, where the height that changes its sign is 0.
  std::vector<std::size_t> firsts;
  const auto border_index = [&](std::size_t k) {
    constexpr std::size_t kNear = 20;
    const Branch &before = seen[k - 1].branch, &after = seen[k].branch;
    const auto choice = static_cast<std::size_t>(std::ranges::mismatch(before, after).in1 - before.begin());
    const auto height = [&](std::size_t number) {
      return is_inside(before, seen[number].point) ? std::abs(map_->heights()[choice])
                                                   : std::numeric_limits<double>::infinity();
    };
    std::size_t best = k;
    const std::size_t least = firsts.back() + 1;
    for (std::size_t i = std::max(least, k - std::min(k, kNear)); i < std::min(seen.size(), k + kNear); ++i) {
      if (height(i) < height(best)) best = i;
    }
    return best;
  };
  for (const BranchCrossing& crossing : found.crossings) result.crossings.push_back(point_of(crossing.v));
  for (std::size_t k = 0; k < seen.size(); ++k) {
    if (k > 0 && seen[k].branch == seen[k - 1].branch) continue;
    result.arcs.push_back({seen[k].branch, {}});
    firsts.push_back(k == 0 ? 0 : border_index(k));
  }
  firsts.push_back(seen.size() - 1);
  for (std::size_t a = 0; a < result.arcs.size(); ++a) {
    for (std::size_t k = firsts[a]; k <= firsts[a + 1]; ++k) result.arcs[a].points.push_back(seen[k].point);
  }
  return result;
}

std::vector<DrawnSimplex> PlanPathView::simplices_around(std::size_t change, double mesh, std::size_t before,
                                                         std::size_t after) {
  std::deque<DrawnSimplex> simplices;
  std::size_t changes = 0, wanted_after = after;
  std::optional<Branch> last;
  std::stop_source stop;
  PlanSimplexOptions options;
  options.mesh = mesh;
  const auto keep = [&](const PassedSimplex& seen) {
    if (last && *last != seen.branch) ++changes;
    last = seen.branch;
    if (changes > change && wanted_after-- == 0) {
      stop.request_stop();
      return;
    }
    if (stop.stop_requested()) return;
    DrawnSimplex& simplex = simplices.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      simplex.corners[k] = point_of(seen.vertices[k]);
      simplex.is_inside[k] = seen.is_inside[k];
    }
    simplex.exit = point_of(seen.exit);
    simplex.branch = seen.branch;
    if (seen.border) {
      const std::vector<double>& n = seen.border->normal;
      const double c = seen.border->offset, reach = 4 * mesh;
      const double s = n[1] * seen.exit[0] - n[0] * seen.exit[1];  // along the line
      simplex.border = GuideLine{};
      for (const double side : {s - reach, s + reach})
        simplex.border->push_back(point_of({c * n[0] + side * n[1], c * n[1] - side * n[0]}));
    }
    if (changes <= change && simplices.size() > before) simplices.pop_front();
  };
  const PlanSimplexPath found =
      follow_plan_simplices(*map_, homotopy_->start(), options, stop.get_token(), keep);
  if (changes <= change)
    throw NotApplicable(fmt::format("the path changes its branch {} times{}", changes,
                                    found.failure.empty() ? "" : ": " + found.failure));
  return {simplices.begin(), simplices.end()};
}

bool PlanPathView::is_inside(const Branch& branch, const GuidePoint& point) {
  double value = 0;
  const std::array<double, 2> v = {point[0] / map_->unit(), point[1]};
  return map_->values(branch, v, {&value, 1}).is_inside;
}

std::vector<GuideLine> PlanPathView::border(const Branch& branch, const GuideRange& range, int resolution) {
  const auto inside = [&](const GuidePoint& point) { return is_inside(branch, point); };
  return BorderTrace(range, resolution, inside).lines();
}

Figure PlanPathView::figure(const Branch& branch, const GuidePoint& point) {
  if (!is_inside(branch, point)) throw NotApplicable("a figure outside of the domain of its branch");
  std::vector<double> v = {point[0] / map_->unit()};
  for (const double height : map_->heights()) v.push_back(height / map_->unit());
  v.push_back(point[1]);
  return figure_at(problem_.geometry->equations, homotopy_->curve().unknowns(v));
}

}  // namespace gcslab
