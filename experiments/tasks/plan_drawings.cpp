// Drawings of construction plans: the branches of an evaluation, paths in guide parameters, and how they pass
// from branch to branch (Imbach 2013, figures 4.2 and 4.8 to 4.10).

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "base/error.h"
#include "experiments/corpus/problem_loader.h"
#include "experiments/tasks/illustration.h"
#include "experiments/tasks/plan_path_view.h"
#include "geometry/numeric_vector.h"
#include "geometry/sketch.h"

namespace gcslab {
namespace {

Json json_of(const GuideLine& line) {
  Json points = Json::array();
  for (const GuidePoint& p : line) points.push_back({p[0], p[1]});
  return points;
}

Json text_at(const char* style, const GuidePoint& place, const std::string& text,
             const char* anchor = "corner") {
  Json result = shape("label", style, json_of({place}), text);
  result["anchor"] = anchor;
  return result;
}

/// The range of some points with room around them, as a share of their extent.
GuideRange range_of(const std::vector<GuideLine>& lines, double room) {
  GuideRange range{{1e300, 1e300}, {-1e300, -1e300}};
  for (const GuideLine& line : lines) {
    for (const GuidePoint& p : line) {
      for (std::size_t k = 0; k < 2; ++k) {
        range.low[k] = std::min(range.low[k], p[k]);
        range.high[k] = std::max(range.high[k], p[k]);
      }
    }
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const double margin = room * (range.high[k] - range.low[k]);
    range.low[k] -= margin;
    range.high[k] += margin;
  }
  return range;
}

/// Points that a drawing can tell apart.
GuideLine thinned(const GuideLine& line, const GuideRange& range) {
  constexpr double kShare = 1.0 / 400;
  GuideLine result;
  for (const GuidePoint& p : line) {
    const auto is_far = [&](std::size_t k) {
      return std::abs(p[k] - result.back()[k]) > kShare * (range.high[k] - range.low[k]);
    };
    if (result.empty() || &p == &line.back() || is_far(0) || is_far(1)) result.push_back(p);
  }
  return result;
}

Json panel_of(const GuideRange& range, const std::string& guide, Json shapes, const std::string& title = "") {
  return {{"title", title},
          {"x", {range.low[0], range.high[0]}},
          {"y", {range.low[1], range.high[1]}},
          {"xlabel", guide},
          {"ylabel", "t"},
          {"shapes", std::move(shapes)}};
}

// ---- the branches of an evaluation (figure 4.2) ----

class BranchTree {
 public:
  explicit BranchTree(const std::filesystem::path& path)
      : problem_(load_system(path.string())), system_(problem_.geometry->system) {
    const std::optional<Figure> sketch = sketch_of(system_);
    if (!sketch) throw NotApplicable("the problem has no sketch");
    program_.emplace(system_, make_plan(system_, PlanKind::henneberg, *sketch));
    evaluator_.emplace(*program_);
    values_ = evaluator_->read(in_frame(system_, program_->plan(), *sketch), parameters_of(system_, *sketch));
    chosen_ = evaluator_->branch(values_);
    first_ = system_.universe == Universe::space ? 1 : 0;
    for (const PlanStep& step : program_->plan().steps) {
      if (step.choice && *step.choice >= first_) choices_.push_back(step.point);
    }
    if (choices_.empty() || choices_.size() > 4)
      throw NotApplicable(fmt::format("a tree of {} choices is not drawn", choices_.size()));
  }

  Drawn draw() {
    Branch branch = chosen_;
    descend(branch, 0, 0, 1);
    Json shapes = Json::array();
    for (const Json* layer : {&impossible_, &edges_, &bold_, &labels_}) {
      for (const Json& item : *layer) shapes.push_back(item);
    }
    const double depth = static_cast<double>(choices_.size());
    Json panel = {{"title", "branch " + numbers_of(chosen_)},
                  {"frame", false},
                  {"x", {-0.02, 1.02}},
                  {"y", {-depth - 0.35, 0.3}},
                  {"shapes", std::move(shapes)}};
    return {Json::array({std::move(panel)}), {{"figures", figures_}}};
  }

 private:
  /// (1, 2, 1): the place with the positive height is number 1.
  std::string numbers_of(const Branch& branch) const {
    std::string text;
    for (std::size_t k = first_; k < branch.size(); ++k)
      text += (text.empty() ? "" : ", ") + std::string(branch[k] ? "2" : "1");
    return "(" + text + ")";
  }

  /// The step of the plan at which the evaluation fails.
  std::optional<std::size_t> failing_step(const Branch& branch) {
    const PlanPlace place = evaluator_->evaluate(values_, branch);
    if (place.failure == PlanFailure::none) return std::nullopt;
    return place.step;
  }

  bool reaches(const Branch& branch, std::size_t level) {
    const std::optional<std::size_t> failing = failing_step(branch);
    if (!failing) return true;
    const auto& steps = program_->plan().steps;
    for (std::size_t k = 0; k <= *failing; ++k) {
      if (steps[k].point == choices_[level]) return k < *failing;
    }
    return true;
  }

  void descend(Branch& branch, std::size_t level, double left, double right) {
    const GuidePoint here = {(left + right) / 2, -static_cast<double>(level)};
    if (level == choices_.size()) {
      ++figures_;
      return;
    }
    const auto number = first_ + level;
    const bool own = branch[number];
    for (const bool is_second : {false, true}) {
      const double middle = (left + right) / 2;
      const double l = is_second ? middle : left, r = is_second ? right : middle;
      const GuidePoint place = {(l + r) / 2, here[1] - 1};
      branch[number] = is_second;
      const bool is_possible = reaches(branch, level);
      const bool is_chosen = std::equal(
          branch.begin(), branch.begin() + static_cast<std::ptrdiff_t>(number) + 1, chosen_.begin());
      Json line = shape("polyline",
                        !is_possible ? "dashed"
                        : is_chosen  ? "bold"
                                     : "mesh",
                        json_of({here, place}));
      (!is_possible ? impossible_ : is_chosen ? bold_ : edges_).push_back(std::move(line));
      const std::string& name = system_.objects[choices_[level]].name;
      labels_.push_back(text_at(is_possible ? "curve" : "dashed", place,
                                is_possible ? fmt::format("{}, {}", name, is_second ? 2 : 1) : "none",
                                "centre"));
      if (is_possible) descend(branch, level + 1, l, r);
    }
    branch[number] = own;
  }

  Problem problem_;
  const ConstraintSystem& system_;
  std::optional<PlanProgram> program_;
  std::optional<PlanEvaluator> evaluator_;
  PlanValues values_;
  Branch chosen_;
  std::size_t first_ = 0;             ///< choice that is not one of where the frame is
  std::vector<std::size_t> choices_;  ///< points
  Json impossible_ = Json::array(), edges_ = Json::array(), bold_ = Json::array(), labels_ = Json::array();
  int figures_ = 0;
};

// ---- a path from branch to branch (figure 4.8) ----

// In sizes of the sketch; where the path touches a border, simplices show as steps.
constexpr double kMesh = 1e-3, kFineMesh = 3e-4;

Drawn guide_path(const std::filesystem::path& path, const Options&) {
  PlanPathView view(path);
  const PlanPathView::Followed followed = view.follow(kMesh);
  std::vector<GuideLine> lines;
  for (const BranchArc& arc : followed.arcs) lines.push_back(arc.points);
  const GuideRange range = range_of(lines, 0.06);
  Json shapes = Json::array();
  for (const double t : {0.0, 1.0})
    shapes.push_back(shape("segment", "muted", json_of({{range.low[0], t}, {range.high[0], t}})));
  GuideLine changes;
  const Branch& own = followed.arcs.front().branch;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const bool is_own =
        k == 0 || (followed.is_cycle && k + 1 == lines.size() && followed.arcs[k].branch == own);
    shapes.push_back(shape("polyline", is_own ? "bold" : "first", json_of(thinned(lines[k], range))));
    if (k > 0) changes.push_back(lines[k].front());
  }
  shapes.push_back(shape("points", "bold", json_of(changes)));
  shapes.push_back(shape("points", "disc", json_of(followed.crossings)));
  shapes.push_back(shape("points", "square", json_of({followed.sketch})));
  return {Json::array({panel_of(range, view.guide_text(), std::move(shapes))}),
          {{"branch_changes", changes.size()},
           {"crossings", followed.crossings.size()},
           {"simplices", followed.simplices}}};
}

// ---- a change of branch (figure 4.9) ----

/// A circle in the plane of a section, its centre on the horizontal axis.
struct Section {
  double centre, radius;
};

/// The spheres that place a point, cut by a plane through both of its places: circles around points of the
/// line in which the plane cuts that of the centres.
struct Situation {
  std::vector<Section> circles;
  double height;  ///< of the place that is taken over that line
};

struct Spheres {
  std::vector<Numbers> centres;
  Numbers point;
};

Spheres spheres_of(const PlanPathView& view, const PlanStep& step, const Figure& figure) {
  Spheres result{{}, figure[step.point]};
  for (const LocusSource& source : step.loci) {
    std::size_t centre = 0;
    if (source.guide) {
      centre = view.plan().guides[*source.guide].centre;
    } else {
      const Constraint& constraint = view.system().constraints[*source.constraint];
      if (constraint.kind->name != "distance")
        throw NotApplicable("the changing instruction has other loci than spheres");
      centre = constraint.objects[constraint.objects[0] == step.point ? 1 : 0];
    }
    result.centres.push_back(figure[centre]);
  }
  if (result.centres.size() != 3 || result.point.size() != 3)
    throw NotApplicable("only instructions of three spheres are drawn");
  return result;
}

/// Cut along the direction of the plane of the centres at this angle to the first two.
Situation cut(const Spheres& spheres, double angle, bool is_below) {
  std::vector<Numbers> axes;
  for (const std::size_t k : {1U, 2U}) {
    Numbers side = difference(spheres.centres[k], spheres.centres[0]);
    for (const Numbers& axis : axes) {
      const double along = dot(side, axis);
      for (std::size_t i = 0; i < 3; ++i) side[i] -= along * axis[i];
    }
    const double length = std::sqrt(dot(side, side));
    for (double& x : side) x /= length;
    axes.push_back(side);
  }
  const Numbers from = difference(spheres.point, spheres.centres[0]);
  const double along[] = {dot(from, axes[0]), dot(from, axes[1])};
  const double square = dot(from, from) - along[0] * along[0] - along[1] * along[1];
  const double height = std::sqrt(std::max(square, 0.0));
  Situation result{{}, is_below ? -height : height};
  for (const Numbers& centre : spheres.centres) {
    const Numbers side = difference(centre, spheres.centres[0]);
    const double x =
        std::cos(angle) * (dot(side, axes[0]) - along[0]) + std::sin(angle) * (dot(side, axes[1]) - along[1]);
    result.circles.push_back({x, std::hypot(x, height)});
  }
  return result;
}

/// The angle at which the circles of a situation are told apart best.
double best_angle(const Spheres& spheres) {
  double best = 0, widest = -1;
  for (int degrees = 0; degrees < 180; degrees += 2) {
    const double angle = degrees * std::numbers::pi / 180;
    std::vector<double> x;
    for (const Section& circle : cut(spheres, angle, false).circles) x.push_back(circle.centre);
    const double largest = std::max({std::abs(x[0]), std::abs(x[1]), std::abs(x[2])});
    const double least = std::min({std::abs(x[0]), std::abs(x[1]), std::abs(x[2]), std::abs(x[0] - x[1]),
                                   std::abs(x[0] - x[2]), std::abs(x[1] - x[2])});
    if (least / largest > widest) {
      widest = least / largest;
      best = angle;
    }
  }
  return best;
}

Json situation_panel(const Situation& situation, const std::string& title, const std::string& name) {
  Json shapes = Json::array();
  double low = 0, high = 0, tall = 0;
  for (const Section& circle : situation.circles) {
    GuideLine round;
    for (int degrees = 0; degrees <= 360; degrees += 4) {
      const double a = degrees * std::numbers::pi / 180;
      round.push_back({circle.centre + circle.radius * std::cos(a), circle.radius * std::sin(a)});
    }
    shapes.push_back(shape("polyline", "edge", json_of(round)));
    low = std::min(low, circle.centre - circle.radius);
    high = std::max(high, circle.centre + circle.radius);
    tall = std::max(tall, circle.radius);
  }
  shapes.push_back(shape("segment", "dashed", json_of({{low, 0}, {high, 0}})));
  shapes.push_back(shape("points", "disc", json_of({{0, situation.height}})));
  shapes.push_back(text_at("second", {0, situation.height}, name));
  const double room = 0.05 * (high - low), half = std::max(tall + room, 0.0);
  return {{"title", title},     {"frame", false},
          {"aspect", "equal"},  {"x", {low - room, high + room}},
          {"y", {-half, half}}, {"shapes", std::move(shapes)}};
}

/// The point of a line in the order of its points that is at a distance from its first.
std::size_t index_at(const GuideLine& line, double distance) {
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (std::hypot(line[k][0] - line[0][0], line[k][1] - line[0][1]) >= distance) return k;
  }
  return line.size() - 1;
}

Drawn border_crossing(const std::filesystem::path& path, const Options& options) {
  PlanPathView view(path);
  const PlanPathView::Followed followed = view.follow(kFineMesh);
  const auto number = static_cast<std::size_t>(options.integer("change"));
  if (number >= followed.arcs.size() - 1)
    throw NotApplicable(fmt::format("the path changes its branch {} times", followed.arcs.size() - 1));
  GuideLine before = followed.arcs[number].points, after = followed.arcs[number + 1].points;
  std::ranges::reverse(before);
  const GuidePoint b = after.front();
  const double reach = options.real("reach");
  before.resize(index_at(before, reach) + 1);
  after.resize(index_at(after, reach) + 1);
  const Branch& first = followed.arcs[number].branch;
  const Branch& second = followed.arcs[number + 1].branch;
  const auto choice = static_cast<std::size_t>(std::ranges::mismatch(first, second).in1 - first.begin());
  // The path touches the border at B: the tangent there stands for the border.
  const std::size_t near = std::min({before.size(), after.size(), std::size_t{8}}) - 1;
  double nx = -(after[near][1] - before[near][1]), ny = after[near][0] - before[near][0];
  const double length = std::hypot(nx, ny);
  nx /= length;
  ny /= length;
  GuideLine image;
  for (const GuidePoint& p : after) {
    const double twice = 2 * ((p[0] - b[0]) * nx + (p[1] - b[1]) * ny);
    image.push_back({p[0] - twice * nx, p[1] - twice * ny});
  }
  const GuideRange range = range_of({before, after, image}, 0.1);
  Json shapes = Json::array();
  for (const GuideLine& line : view.border(first, range, 200))
    shapes.push_back(shape("polyline", "control", json_of(thinned(line, range))));
  shapes.push_back(shape("polyline", "bold", json_of(thinned(before, range))));
  shapes.push_back(shape("polyline", "first", json_of(thinned(after, range))));
  shapes.push_back(shape("polyline", "hidden", json_of(thinned(image, range))));
  const GuidePoint a = before[before.size() * 3 / 5], c = after[after.size() * 3 / 5];
  shapes.push_back(shape("points", "bold", json_of({a, b, c})));
  for (const auto& [place, name] : {std::pair{a, "A"}, std::pair{b, "B"}, std::pair{c, "C"}})
    shapes.push_back(text_at("curve", place, name));
  const auto& steps = view.plan().steps;
  const auto step = std::ranges::find_if(steps, [&](const PlanStep& s) { return s.choice == choice; });
  const std::string& name = view.system().objects[step->point].name;
  Json panels = Json::array({panel_of(range, view.guide_text(), std::move(shapes), "guide and t")});
  const double angle = best_angle(spheres_of(view, *step, view.figure(first, a)));
  const auto add = [&](const std::string& title, const Branch& branch, const GuidePoint& place) {
    panels.push_back(situation_panel(
        cut(spheres_of(view, *step, view.figure(branch, place)), angle, branch[choice]), title, name));
  };
  add("(a) at A", first, a);
  add("(b) at B", first, before[1]);
  add("(c) at C", second, c);
  return {std::move(panels), {{"branch_changes", followed.arcs.size() - 1}}};
}

// ---- simplices across a change of branch (figure 4.10) ----

Drawn simplices_across(const std::filesystem::path& path, const Options& options) {
  PlanPathView view(path);
  const auto change = static_cast<std::size_t>(options.integer("change"));
  const std::vector<DrawnSimplex> simplices = view.simplices_around(change, options.real("mesh"), 24, 4);
  std::vector<GuideLine> corners;
  for (const DrawnSimplex& simplex : simplices)
    corners.emplace_back(simplex.corners.begin(), simplex.corners.end());
  const GuideRange range = range_of(corners, 0.08);
  Json shapes = Json::array();
  const Branch first = simplices.front().branch;
  for (const DrawnSimplex& simplex : simplices) {
    const bool is_beyond = simplex.branch != first;
    const bool is_across = std::ranges::count(simplex.is_inside, true) < 3;
    shapes.push_back(shape("polygon",
                           is_beyond   ? "body"
                           : is_across ? "accent"
                                       : "cell",
                           json_of({simplex.corners.begin(), simplex.corners.end()})));
  }
  for (const GuideLine& line : view.border(first, range, 200))
    shapes.push_back(shape("polyline", "control", json_of(thinned(line, range))));
  GuideLine interpolated, outside;
  for (const DrawnSimplex& simplex : simplices) {
    if (simplex.branch == first) interpolated.push_back(simplex.exit);
    for (std::size_t k = 0; k < 3; ++k) {
      if (!simplex.is_inside[k]) outside.push_back(simplex.corners[k]);
    }
  }
  const PlanPathView::Followed followed = view.follow(kFineMesh);
  for (std::size_t k : {change, change + 1}) {
    if (k < followed.arcs.size())
      shapes.push_back(shape("polyline", k == change ? "curve" : "first",
                             json_of(thinned(followed.arcs[k].points, range))));
  }
  shapes.push_back(shape("polyline", "hidden", json_of(interpolated)));
  shapes.push_back(shape("points", "disc", json_of(outside)));
  return {Json::array({panel_of(range, view.guide_text(), std::move(shapes))}),
          {{"simplices", simplices.size()}}};
}

OptionSpec change_option() {
  return integer_option("change", "which change of branch, along the path from the sketch", "", 0, 0, 10'000);
}

}  // namespace

std::vector<Illustration> plan_illustrations() {
  return {{"branch_tree",
           "the branches of a plan by distances, evaluated with the values of the problem's sketch; the "
           "sketch's own branch is bold, dashed lines lead to where the loci do not meet",
           [](const std::filesystem::path& path, const Options&) { return BranchTree(path).draw(); }},
          {"guide_path",
           "the path of the problem's sketch in the plane of one guide parameter and t: the sketch's branch "
           "bold, black points changes of branch, discs solutions, a square the sketch",
           guide_path},
          {"border_crossing",
           "a change of branch at the border of a plan's domain, and the spheres there",
           border_crossing,
           {change_option(),
            real_option("reach", "of the path that is drawn on either side", "", 0.1, 1e-6, 1e6)}},
          {"simplices_across",
           "simplices of a path across a change of branch",
           simplices_across,
           {change_option(), real_option("mesh", "edges of the simplices along the axes",
                                         "in sizes of the sketch and t", 0.02, 1e-6, 1)}}};
}

}  // namespace gcslab
