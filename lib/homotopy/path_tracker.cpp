#include "homotopy/path_tracker.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "homotopy/bordered_matrix.h"

namespace gcslab {
namespace {

using Point = std::vector<double>;

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

double norm(std::span<const double> a) { return std::sqrt(dot(a, a)); }

double largest(std::span<const double> a) {
  double result = 0;
  for (const double x : a) result = std::max(result, std::abs(x));
  return result;
}

/// A cubic on [0, 1] by its ends and its derivatives there.
struct Cubic {
  double start, start_slope, end, end_slope;

  double at(double u) const {
    const double w = 1 - u;
    return w * w * (1 + 2 * u) * start + u * w * w * start_slope + u * u * (3 - 2 * u) * end -
           u * u * w * end_slope;
  }
  double slope(double u) const {
    const double w = 1 - u;
    return 6 * u * w * (end - start) + w * (w - 2 * u) * start_slope + u * (u - 2 * w) * end_slope;
  }
};

/// A point of the curve with its unit tangent and, once factorised, (J; border) there.
struct CurvePoint {
  Point v;
  Point tangent;
};

class Tracker {
 public:
  Tracker(Homotopy& homotopy, std::span<const double> sketch, const TrackerOptions& options,
          const std::stop_token& stop)
      : homotopy_(&homotopy),
        options_(&options),
        stop_(stop),
        m_(homotopy.size()),
        sketch_(sketch.begin(), sketch.end()),
        values_(m_),
        zero_(m_, 0.0),
        change_(m_ + 1),
        jacobian_(m_, m_ + 1) {
    size_ = std::max(norm(sketch_), 1e-300);
  }

  SketchPath follow() {
    start_ = starting_point();
    path_.end = path_.other_end = run(1);
    if (path_.end == PathEnd::cycle || path_.steps >= options_->maximum_steps || stop_.stop_requested())
      return std::move(path_);
    path_.other_end = run(-1);
    return std::move(path_);
  }

 private:
  enum class Correction { done, failed, undefined };

  CurvePoint starting_point() {
    CurvePoint start{sketch_, Point(m_ + 1, 0.0)};
    start.v.push_back(0);
    if (!homotopy_->jacobian(start.v, values_, jacobian_))
      throw NotApplicable("the sketch has points at which the equations are undefined");
    Point border(m_ + 1, 0.0);
    border[m_] = 1;
    if (!matrix_.factorise(jacobian_, border) && !matrix_.factorise(jacobian_, direction_of_kernel()))
      throw NotApplicable(
          "the sketch is singular: its constraints depend on each other there, draw it otherwise");
    matrix_.solve(zero_, 1, start.tangent);
    scale(start.tangent, 1 / norm(start.tangent));
    return start;
  }

  /// Of the kernel of the Jacobian, by its smallest singular vector.
  Point direction_of_kernel() const {
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const auto rows = static_cast<Eigen::Index>(m_);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(Eigen::Map<const RowMajor>(jacobian_.data(), rows, rows + 1),
                                                Eigen::ComputeFullV);
    const Eigen::VectorXd last = svd.matrixV().col(rows);
    return {last.data(), last.data() + last.size()};
  }

  static void scale(Point& a, double factor) {
    for (double& x : a) x *= factor;
  }

  PathEnd run(int direction) {
    direction_ = direction;
    length_ = 0;
    CurvePoint here = start_;
    if (direction < 0) scale(here.tangent, -1);
    previous_.reset();
    if (!factorise_at(here.v, here.tangent)) return given_up();
    double step = options_->first_step;
    while (path_.steps < options_->maximum_steps && !stop_.stop_requested()) {
      predict(here, step);
      const std::optional<CurvePoint> next = corrected(here, step);
      if (!next || misses_a_crossing(here, *next)) {
        ++path_.refused;
        step /= 2;
        if (step < options_->least_step) return given_up();
        if (!factorise_at(here.v, here.tangent)) return given_up();
        continue;
      }
      ++path_.steps;
      const double travelled = distance(here.v, next->v);
      note_crossing(here, *next, travelled);
      length_ += travelled;
      path_.length += travelled;
      if (has_returned(here, *next)) return PathEnd::cycle;
      if (norm(next->v) > options_->infinity * size_) return PathEnd::to_infinity;
      previous_ = Previous{here, travelled};
      here = *next;
      step = std::min(step * growth_, options_->largest_step);
    }
    return PathEnd::budget;
  }

  static double distance(const Point& a, const Point& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum);
  }

  /// Why no step succeeds.
  PathEnd given_up() const { return is_defined_ ? PathEnd::budget : PathEnd::to_undefined; }

  bool factorise_at(const Point& v, const Point& border) {
    is_defined_ = homotopy_->jacobian(v, values_, jacobian_);
    return is_defined_ && matrix_.factorise(jacobian_, border);
  }

  void predict(const CurvePoint& here, double step) {
    predicted_.resize(m_ + 1);
    for (std::size_t i = 0; i <= m_; ++i) {
      predicted_[i] = here.v[i] + step * here.tangent[i];
      if (!previous_) continue;
      const double span = previous_->length;
      const Cubic cubic{previous_->point.v[i], span * previous_->point.tangent[i], here.v[i],
                        span * here.tangent[i]};
      predicted_[i] = cubic.at(1 + step / span);
    }
  }

  /// The curve's point in the hyperplane through the prediction, with its tangent; sets the growth of the
  /// next step. Nothing where the step was too large.
  std::optional<CurvePoint> corrected(const CurvePoint& here, double step) {
    constexpr int kCorrections = 8;
    constexpr double kLargestRate = 0.5;
    constexpr double kAimedRate = 0.2;
    CurvePoint next{predicted_, Point(m_ + 1)};
    double before = 0, first = 0, rate = 0;
    bool is_done = false;
    for (int k = 0; k < kCorrections && !is_done; ++k) {
      is_defined_ = homotopy_->values(next.v, values_);
      if (!is_defined_) return std::nullopt;
      matrix_.solve(values_, 0, change_);
      const double change = norm(change_);
      if (k == 0) first = change;
      if (k > 0) rate = std::max(rate, change / before);
      if (!std::isfinite(change) || rate > kLargestRate || first > 0.25 * step) return std::nullopt;
      for (std::size_t i = 0; i <= m_; ++i) next.v[i] -= change_[i];
      is_done = change <= options_->tolerance * (size_ + largest(next.v));
      before = change;
    }
    if (!is_done || !factorise_at(next.v, here.tangent)) return std::nullopt;
    matrix_.solve(zero_, 1, next.tangent);
    scale(next.tangent, 1 / norm(next.tangent));
    const double cosine = dot(next.tangent, here.tangent);
    if (!(cosine > std::cos(options_->largest_turn))) return std::nullopt;
    const double aimed = options_->deviation * step;
    growth_ = std::clamp(std::pow(aimed / std::max(first, 1e-300), previous_ ? 0.25 : 0.5), 0.5, 2.0);
    // The chord method's rate grows in proportion to the step.
    if (rate > 0) growth_ = std::min(growth_, std::max(0.5, kAimedRate / rate));
    const double turn = std::acos(std::min(cosine, 1.0));
    if (turn > 0) growth_ = std::min(growth_, std::max(0.5, 0.7 * options_->largest_turn / turn));
    return next;
  }

  /// Whether t turns back between the points beyond 0 or 1, on whose other side both of them lie.
  bool misses_a_crossing(const CurvePoint& here, const CurvePoint& next) const {
    const double span = distance(here.v, next.v);
    const Cubic t{here.v[m_], span * here.tangent[m_], next.v[m_], span * next.tangent[m_]};
    if (t.start_slope * t.end_slope >= 0) return false;
    double low = 0, high = 1;
    for (int k = 0; k < 30; ++k) {
      const double middle = (low + high) / 2;
      (t.slope(middle) * t.start_slope > 0 ? low : high) = middle;
    }
    const double extreme = t.at(low);
    const auto is_beyond = [&](double level) {
      return (t.start - level) * (t.end - level) > 0 && (extreme - level) * (t.start - level) < 0;
    };
    return span > 1e-6 && (is_beyond(0) || is_beyond(1));
  }

  /// The point with t = level between two, on the cubic through them, then by Newton's method with t fixed.
  std::optional<Point> point_at(double level, const CurvePoint& here, const CurvePoint& next) {
    const double span = distance(here.v, next.v);
    const auto cubic = [&](std::size_t i) {
      return Cubic{here.v[i], span * here.tangent[i], next.v[i], span * next.tangent[i]};
    };
    const Cubic t = cubic(m_);
    double low = 0, high = 1;
    for (int k = 0; k < 40; ++k) {
      const double middle = (low + high) / 2;
      ((t.at(middle) - level) * (t.start - level) > 0 ? low : high) = middle;
    }
    Point v;
    for (std::size_t i = 0; i <= m_; ++i) v.push_back(cubic(i).at(low));
    v[m_] = level;
    return polished(std::move(v));
  }

  std::optional<Point> polished(Point v) {
    constexpr int kIterations = 8;
    Point border(m_ + 1, 0.0);
    border[m_] = 1;
    BorderedMatrix matrix;
    for (int k = 0; k < kIterations; ++k) {
      if (!homotopy_->jacobian(v, values_, jacobian_) || !matrix.factorise(jacobian_, border))
        return std::nullopt;
      matrix.solve(values_, 0, change_);
      for (std::size_t i = 0; i < m_; ++i) v[i] -= change_[i];
      if (norm(change_) <= 1e-15 * (size_ + largest(v))) break;
    }
    return v;
  }

  static bool is_between(double level, double a, double b) {
    return (a - level) * (b - level) < 0 || b == level;
  }

  void note_crossing(const CurvePoint& here, const CurvePoint& next, double travelled) {
    if (!is_between(1, here.v[m_], next.v[m_])) return;
    const std::optional<Point> found = point_at(1, here, next);
    Point v = found ? *found : next.v;
    const bool is_defined = homotopy_->values(v, values_);
    const double residual = is_defined ? largest(values_) : HUGE_VAL;
    v.pop_back();
    path_.crossings.push_back({std::move(v), direction_ * (length_ + travelled / 2), residual});
  }

  bool has_returned(const CurvePoint& here, const CurvePoint& next) {
    constexpr double kNear = 1e-6;
    if (here.v[m_] == 0 || !is_between(0, here.v[m_], next.v[m_])) return false;
    const std::optional<Point> found = point_at(0, here, next);
    return found && distance(*found, start_.v) <= kNear * size_;
  }

  struct Previous {
    CurvePoint point;
    double length;
  };

  Homotopy* homotopy_;
  const TrackerOptions* options_;
  std::stop_token stop_;
  std::size_t m_;
  Point sketch_;
  double size_ = 1;
  int direction_ = 1;
  double length_ = 0;
  double growth_ = 1;
  bool is_defined_ = true;  ///< where the equations were asked for last
  CurvePoint start_;
  std::optional<Previous> previous_;
  Point predicted_, values_, zero_, change_;
  Matrix<double> jacobian_;
  BorderedMatrix matrix_;
  SketchPath path_;
};

}  // namespace

std::string_view name_of(PathEnd end) {
  switch (end) {
    case PathEnd::cycle:
      return "cycle";
    case PathEnd::to_infinity:
      return "to_infinity";
    case PathEnd::to_undefined:
      return "to_undefined";
    case PathEnd::budget:
      break;
  }
  return "budget";
}

SketchPath follow_sketch(Homotopy& homotopy, std::span<const double> sketch, const TrackerOptions& options,
                         const std::stop_token& stop) {
  return Tracker(homotopy, sketch, options, stop).follow();
}

}  // namespace gcslab
