#include "experiments/tasks/ray_cast_task.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

#include "base/error.h"
#include "experiments/corpus/problem_loader.h"
#include "experiments/tasks/job_result.h"
#include "experiments/tasks/ray_camera.h"
#include "experiments/tasks/stopwatch.h"
#include "polynomial/recognise.h"
#include "univariate/first_root.h"

namespace gcslab {
namespace {

/// What the picture says of a pixel, beside the brightness of 1 to 255 of a hit.
constexpr int kBackground = 0;
constexpr int kMissed = 256;  ///< the method found nothing, but there is a hit
constexpr int kLate = 257;    ///< what it found is not the first hit

struct Pixel {
  std::optional<Segment3> segment;
  std::optional<double> found;  ///< parameter of the hit on the segment
  bool was_exact = false;
};

Point3 point_at(const Segment3& segment, double t) { return segment.from + t * (segment.to - segment.from); }

/// f and its gradient in doubles, for shading and for the baseline.
class PointEvaluator {
 public:
  explicit PointEvaluator(const Polynomial& polynomial) {
    for (const auto& [exponents, coefficient] : polynomial.terms())
      terms_.push_back({{exponents[0], exponents[1], exponents[2]}, nearest_double(coefficient)});
  }

  double value(const Point3& p) const {
    double sum = 0;
    for (const auto& [exponents, coefficient] : terms_) {
      double term = coefficient;
      for (std::size_t i = 0; i < 3; ++i) {
        for (int k = 0; k < exponents[i]; ++k) term *= p[i];
      }
      sum += term;
    }
    return sum;
  }

 private:
  std::vector<std::pair<std::array<int, 3>, double>> terms_;
};

class Surface {
 public:
  explicit Surface(const Polynomial& polynomial) : finder_(polynomial), value_(polynomial) {
    for (int i = 0; i < 3; ++i) gradient_.emplace_back(polynomial.derivative(i));
  }

  FirstRoot first_hit(const Segment3& segment) const { return finder_.find(segment.from, segment.to); }

  /// Where f changes its sign first between neighbours of equally spaced points, halved down to the width of
  /// the certified method: sheets that lie between two points are not seen.
  std::optional<double> marched_hit(const Segment3& segment, int steps) const {
    double before = 0;
    bool was_positive = is_positive(segment, 0);
    for (int i = 1; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      if (is_positive(segment, t) != was_positive) return bisected(segment, before, t);
      before = t;
    }
    return std::nullopt;
  }

  /// Lambert's cosine law with some ambient light, both sides alike.
  int brightness(const Point3& p, const Point3& view, const Point3& light) const {
    const Point3 normal = {gradient_[0].value(p), gradient_[1].value(p), gradient_[2].value(p)};
    if (!(dot(normal, normal) > 0)) return 128;
    const Point3 unit = normalised(normal);
    const double lit = dot(unit, view) < 0 ? dot(unit, light) : -dot(unit, light);
    return static_cast<int>(255 * (0.22 + 0.75 * std::max(lit, 0.0)));
  }

 private:
  bool is_positive(const Segment3& segment, double t) const { return value_.value(point_at(segment, t)) > 0; }

  double bisected(const Segment3& segment, double low, double high) const {
    const bool low_is_positive = is_positive(segment, low);
    while (high - low > 0x1p-20) {
      const double middle = (low + high) / 2;
      (is_positive(segment, middle) == low_is_positive ? low : high) = middle;
    }
    return (low + high) / 2;
  }

  FirstRootFinder finder_;
  PointEvaluator value_;
  std::vector<PointEvaluator> gradient_;
};

Polynomial polynomial_of(const Problem& problem) {
  Recognition recognition = recognise_polynomial(problem.system.equations.front(), 3);
  if (!recognition.polynomial)
    throw NotApplicable("rays are cast at algebraic surfaces: the equation " + recognition.reason);
  return *std::move(recognition.polynomial);
}

Point3 view_of(const Options& parameters) {
  return {parameters.real("view_x"), parameters.real("view_y"), parameters.real("view_z")};
}

/// All pixels of a picture, row by row from below.
class Picture {
 public:
  Picture(const Problem& problem, const Options& parameters)
      : size_(static_cast<int>(parameters.integer("pixels"))),
        camera_(problem.system.box, view_of(parameters), parameters.real("zoom"), size_),
        surface_(polynomial_of(problem)) {
    for (int row = 0; row < size_; ++row) {
      for (int column = 0; column < size_; ++column) pixels_.push_back({camera_.segment(column, row), {}});
    }
  }

  /// False when it was stopped.
  template <class Find>
  bool cast(const std::stop_token& stop, const Find& find) {
    for (Pixel& pixel : pixels_) {
      if (stop.stop_requested()) return false;
      if (pixel.segment) find(pixel);
    }
    return true;
  }

  void find_first_root(Pixel& pixel) const {
    const FirstRoot root = surface_.first_hit(*pixel.segment);
    if (root.exists) pixel.found = midpoint(root.t);
    pixel.was_exact = root.was_exact;
  }
  void march(Pixel& pixel, int steps) const { pixel.found = surface_.marched_hit(*pixel.segment, steps); }

  void add_counts(Json& values) const {
    const auto count = [this](auto holds) { return std::ranges::count_if(pixels_, holds); };
    values["rays"] = count([](const Pixel& pixel) { return pixel.segment.has_value(); });
    values["hits"] = count([](const Pixel& pixel) { return pixel.found.has_value(); });
  }
  void add_certified(Json& values) const {
    values["certified"] = values["rays"];
    values["exact"] = std::ranges::count_if(pixels_, &Pixel::was_exact);
  }

  /// Brightness, or what is wrong with the pixel.
  std::vector<int> shades() const {
    std::vector<int> result;
    for (const Pixel& pixel : pixels_) result.push_back(pixel.found ? shade(pixel) : kBackground);
    return result;
  }
  /// Compares with the certified hits, and marks where they differ.
  std::vector<int> judged_shades(Json& values) const {
    std::vector<int> result = shades();
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      if (pixels_[i].segment) judge(pixels_[i], result[i]);
    }
    values["missed"] = std::ranges::count(result, kMissed);
    values["late"] = std::ranges::count(result, kLate);
    return result;
  }

  int size() const { return size_; }

 private:
  int shade(const Pixel& pixel) const {
    const Segment3& segment = *pixel.segment;
    return surface_.brightness(point_at(segment, *pixel.found), segment.to - segment.from, camera_.light());
  }
  void judge(const Pixel& pixel, int& shade) const {
    const FirstRoot root = surface_.first_hit(*pixel.segment);
    if (root.exists && !pixel.found) shade = kMissed;
    if (root.exists && pixel.found && *pixel.found > root.t.upper + 0x1p-19) shade = kLate;
  }

  int size_;
  RayCamera camera_;
  Surface surface_;
  std::vector<Pixel> pixels_;
};

/// Rows of the picture from below, each as numbers with spaces between.
Json picture_json(const Picture& picture, const std::vector<int>& shades) {
  const auto width = static_cast<std::size_t>(picture.size());
  Json rows = Json::array();
  for (std::size_t first = 0; first < shades.size(); first += width) {
    std::string row;
    for (std::size_t i = first; i < first + width; ++i)
      row += fmt::format("{}{}", i > first ? " " : "", shades[i]);
    rows.push_back(row);
  }
  return {{"ray_picture", {{"pixels", picture.size()}, {"rows", rows}}}};
}

}  // namespace

std::string RayCastTask::summary() const { return "a picture of an implicit surface by ray casting"; }

std::vector<MethodInfo> RayCastTask::methods() const {
  return {
      {"first_root",
       "the first root along every ray, isolated with proof by Descartes' rule in the Bernstein basis: in "
       "double intervals, exactly where these cannot tell"},
      {"marching",
       "changes of sign between equally spaced points in doubles: sheets between two points are missed",
       Promise::baseline,
       1,
       {integer_option("steps", "parts of the ray inside the box", "", 100, 1, 1'000'000)}}};
}

std::vector<OptionSpec> RayCastTask::parameters() const {
  return {integer_option("pixels", "of a side of the square picture", "pixels", 160, 2, 2000),
          real_option("zoom", "1: the sphere around the box fills the picture", "", 1, 0.01, 1000),
          real_option("view_x", "direction from the middle of the box to the eye, first coordinate", "", 1.2,
                      -1e6, 1e6),
          real_option("view_y", "second coordinate", "", -2, -1e6, 1e6),
          real_option("view_z", "third coordinate, which points up", "", 1.1, -1e6, 1e6)};
}

std::vector<ValueInfo> RayCastTask::values() const {
  return {{"rays", "rays that meet the box", "rays"},
          {"hits", "of them those on which the method finds the surface", "rays"},
          {"certified", "rays whose first hit, or that there is none, is proved", "rays"},
          {"exact", "of these the ones that needed exact arithmetic", "rays"},
          {"missed", "rays that hit the surface where the method finds nothing", "rays"},
          {"late", "rays on which what the method finds is not the first hit", "rays"}};
}

std::vector<std::string> RayCastTask::problem_kinds() const { return {"surface"}; }

void RayCastTask::check(const Job& job) const {
  static_cast<void>(load_problem_of_kind(job.problem, problem_kinds()));
}

JobResult RayCastTask::run(const Job& job, const std::stop_token& stop) const {
  const Problem problem = load_problem_of_kind(job.problem, problem_kinds());
  const Stopwatch preparation;
  Picture picture(problem, job.parameters);
  JobResult result;
  result.timings["prepare_s"] = preparation.wall_s();
  const bool is_marching = job.method == "marching";
  const int steps = is_marching ? static_cast<int>(job.options.integer("steps")) : 0;
  const Stopwatch watch;
  const bool is_done = picture.cast(stop, [&](Pixel& pixel) {
    is_marching ? picture.march(pixel, steps) : picture.find_first_root(pixel);
  });
  result.timings["wall_s"] = watch.wall_s();
  result.timings["cpu_s"] = watch.cpu_s();
  if (!is_done) {
    result.status = Status::budget_exhausted;
    result.reason = "not every ray was cast when the budget ended";
    return result;
  }
  picture.add_counts(result.values);
  if (!is_marching) picture.add_certified(result.values);
  result.status = is_marching ? Status::partial : Status::complete;
  result.artifact =
      picture_json(picture, is_marching ? picture.judged_shades(result.values) : picture.shades());
  return result;
}

}  // namespace gcslab
