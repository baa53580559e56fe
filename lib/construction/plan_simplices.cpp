#include "construction/plan_simplices.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "homotopy/curve_point.h"

namespace gcslab {
namespace {

using Point = std::vector<double>;

/// A vertex of the current simplex, with F there on the current branch.
struct Vertex {
  Point v;
  BranchMap::Domain domain{};
  std::vector<double> values{};
};

/// A change of branch that does not succeed.
struct Failure {
  std::string reason;
};

/// Part of the border of a domain as a hyperplane, and the branch beyond.
struct Mirror {
  Eigen::VectorXd normal;  ///< of length 1, outward
  double offset;
  Branch beyond;

  double height(const Point& v) const {
    return normal.dot(Eigen::Map<const Eigen::VectorXd>(v.data(), normal.size())) - offset;
  }
  Point image(Point v) const {
    const double twice = 2 * height(v);
    for (std::size_t i = 0; i < v.size(); ++i) v[i] -= twice * normal[static_cast<Eigen::Index>(i)];
    return v;
  }
};

class Follower {
 public:
  Follower(BranchMap& map, const PlanValues& start, const PlanSimplexOptions& options,
           const std::stop_token& stop, const SimplexObserver& observer)
      : map_(&map),
        options_(&options),
        stop_(stop),
        observer_(&observer),
        n_(map.guides() + 1),
        values_(map.guides()) {
    for (const double guide : start.guides) start_.push_back(guide / map.unit());
    start_.push_back(0);
    for (const double height : start.heights) start_branch_.push_back(height < 0);
  }

  PlanSimplexPath follow() {
    path_.end = path_.other_end = run(1);
    if (path_.end != PathEnd::cycle && path_.end != PathEnd::budget) path_.other_end = run(-1);
    return std::move(path_);
  }

 private:
  PathEnd run(int direction) {
    try {
      direction_ = direction;
      set_out(direction);
      here_ = start_;
      length_ = 0;
      while (path_.simplices < options_->maximum_simplices && !stop_.stop_requested()) {
        ++path_.simplices;
        pass();
        const Point next = on_curve();
        note_crossing(direction, next);
        const bool is_back = returns(direction, next);
        const double travelled = distance(here_, next);
        length_ += travelled;
        path_.length += travelled;
        here_ = next;
        if (options_->is_to_first_crossing && !path_.crossings.empty()) return PathEnd::budget;
        if (is_back) return PathEnd::cycle;
        if (norm(here_) > options_->infinity) return PathEnd::to_infinity;
      }
      return PathEnd::budget;
    } catch (const Failure& failure) {
      path_.failure = failure.reason;
      return PathEnd::stuck;
    }
  }

  /// The simplex above (below) a face in t = 0 that has the start in it.
  void set_out(int direction) {
    constexpr int kAttempts = 50;
    branch_ = start_branch_;
    mirror_.reset();
    vertices_.assign(n_ + 1, {start_});
    for (std::size_t i = 0; i + 1 < n_; ++i) {
      for (std::size_t k = 0; k <= n_; ++k)
        vertices_[k].v[i] += options_->mesh * ((k > i ? 1.0 : 0.0) -
                                               static_cast<double>(n_ - 1 - i) / static_cast<double>(n_));
    }
    vertices_[n_].v.back() = options_->mesh;
    columns_.clear();
    for (std::size_t k = 0; k < n_; ++k) columns_.push_back(k);
    fresh_ = n_;
    labels_.resize(index(n_), index(n_));
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      for (Vertex& vertex : vertices_) compute(vertex);
      for (std::size_t k = 0; k < n_; ++k) {
        if (!label(vertices_[k], labels_.col(index(k))))
          throw Failure{"a vertex of the first simplex is outside of the domain: take a smaller mesh"};
      }
      const Eigen::VectorXd lambda = weights();
      if (lambda.allFinite() && lambda.minCoeff() > 0.1 / static_cast<double>(n_)) {
        if (direction < 0) replace(n_);
        return;
      }
      Point zero(n_, 0.0), barycentre(n_, 0.0);
      for (std::size_t k = 0; k < n_; ++k) {
        for (std::size_t i = 0; i < n_; ++i) {
          zero[i] += lambda[index(k)] * vertices_[k].v[i];
          barycentre[i] += vertices_[k].v[i] / static_cast<double>(n_);
        }
      }
      for (Vertex& vertex : vertices_) {
        for (std::size_t i = 0; i + 1 < n_; ++i) vertex.v[i] += zero[i] - barycentre[i];
      }
    }
    throw Failure{"the mesh is too coarse at the sketch"};
  }

  /// Through the simplex to its other face.
  void pass() {
    place_mirror();
    for (std::size_t k = 0; k < n_; ++k) {
      if (!label(vertices_[columns_[k]], labels_.col(index(k))))
        throw Failure{"a mirror image is outside of the domain of the new branch"};
    }
    Eigen::VectorXd column(index(n_));
    if (!label(vertices_[fresh_], column))
      throw Failure{"a mirror image is outside of the domain of the new branch"};
    const auto factors = labels_.partialPivLu();
    const Eigen::VectorXd lambda = factors.solve(Eigen::VectorXd::Unit(index(n_), 0)),
                          direction = factors.solve(column);
    Eigen::Index leaving = -1;
    for (Eigen::Index k = 0; k < lambda.size(); ++k) {
      if (!(direction[k] > 1e-13)) continue;
      if (leaving < 0 || lambda[k] * direction[leaving] < lambda[leaving] * direction[k]) leaving = k;
    }
    if (leaving < 0) throw Failure{"the interpolated map has no zero in the next face"};
    const double along = lambda[leaving] / direction[leaving];
    weights_ = lambda - along * direction;
    weights_[leaving] = along;
    const std::size_t old = std::exchange(columns_[static_cast<std::size_t>(leaving)], fresh_);
    point_.assign(n_, 0.0);
    for (std::size_t k = 0; k < n_; ++k) {
      for (std::size_t i = 0; i < n_; ++i) point_[i] += weights_[index(k)] * vertices_[columns_[k]].v[i];
    }
    tell();
    replace(old);
    fresh_ = old;
  }

  void tell() const {
    if (!*observer_) return;
    std::vector<Point> vertices;
    std::vector<bool> is_inside;
    for (const Vertex& vertex : vertices_) {
      vertices.push_back(vertex.v);
      is_inside.push_back(vertex.domain.is_inside);
    }
    std::optional<PassedSimplex::Border> border;
    if (mirror_)
      border = {{mirror_->normal.data(), mirror_->normal.data() + mirror_->normal.size()}, mirror_->offset};
    (*observer_)({vertices, is_inside, branch_, border, point_, on_curve(), branch_on_curve(), direction_});
  }

  /// The hyperplane for the simplex as it is; none while all vertices are inside. Changes the branch when
  /// all are outside.
  void place_mirror() {
    const auto inside = static_cast<std::size_t>(
        std::ranges::count_if(vertices_, [](const Vertex& vertex) { return vertex.domain.is_inside; }));
    if (inside == n_ + 1) {
      mirror_.reset();
      return;
    }
    if (inside == 0) {
      if (!mirror_) throw Failure{"the simplex left the domain at once: take a smaller mesh"};
      branch_ = mirror_->beyond;
      for (Vertex& vertex : vertices_) {
        vertex.v = mirror_->image(vertex.v);
        compute(vertex);
        if (!vertex.domain.is_inside) throw Failure{"a vertex is outside of the domain of both branches"};
      }
      mirror_.reset();
      path_.changes.push_back({here_, branch_, length_});
      return;
    }
    const auto outside =
        std::ranges::find_if(vertices_, [](const Vertex& vertex) { return !vertex.domain.is_inside; });
    const std::optional<std::size_t> border = outside->domain.border;
    if (!border) throw Failure{"at the border of the domain no radicand vanishes"};
    Branch beyond = branch_;
    beyond[*border] = !beyond[*border];
    std::vector<Point> points;
    for (std::size_t i = 0; i <= n_ && points.size() < n_; ++i) {
      for (std::size_t j = 0; j <= n_ && points.size() < n_; ++j) {
        if (vertices_[i].domain.is_inside && !vertices_[j].domain.is_inside)
          points.push_back(border_point(vertices_[i].v, vertices_[j].v));
      }
    }
    mirror_ = hyperplane(points, vertices_, std::move(beyond));
  }

  Point border_point(Point inside, Point outside) {
    constexpr int kHalvings = 30;
    Point middle(n_);
    for (int k = 0; k < kHalvings; ++k) {
      for (std::size_t i = 0; i < n_; ++i) middle[i] = (inside[i] + outside[i]) / 2;
      (map_->values(branch_, middle, values_).is_inside ? inside : outside) = middle;
    }
    return inside;
  }

  static Mirror hyperplane(const std::vector<Point>& points, const std::vector<Vertex>& vertices,
                           Branch beyond) {
    const Eigen::Index n = index(points.front().size());
    const auto vector = [&](const Point& p) { return Eigen::Map<const Eigen::VectorXd>(p.data(), n); };
    Eigen::MatrixXd sides(index(points.size()) - 1, n);
    for (std::size_t k = 1; k < points.size(); ++k)
      sides.row(index(k) - 1) = (vector(points[k]) - vector(points[0])).transpose();
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(sides, Eigen::ComputeFullV);
    Eigen::VectorXd normal = svd.matrixV().col(n - 1);
    double offset = normal.dot(vector(points[0]));
    double outward = 0;
    for (const Vertex& vertex : vertices)
      outward += (vertex.domain.is_inside ? -1 : 1) * (normal.dot(vector(vertex.v)) - offset);
    if (outward < 0) {
      normal = -normal;
      offset = -offset;
    }
    return {normal, offset, std::move(beyond)};
  }

  void compute(Vertex& vertex) {
    vertex.values.resize(values_.size());
    vertex.domain = map_->values(branch_, vertex.v, vertex.values);
  }

  /// (1, F) at a vertex, of the branch or of the one beyond the mirror.
  bool label(const Vertex& vertex, Eigen::Ref<Eigen::VectorXd> column) {
    const bool is_inside = vertex.domain.is_inside;
    if (!is_inside &&
        !(mirror_ && map_->values(mirror_->beyond, mirror_->image(vertex.v), values_).is_inside))
      return false;
    const std::vector<double>& values = is_inside ? vertex.values : values_;
    column[0] = 1;
    for (std::size_t i = 0; i < values.size(); ++i) column[index(i) + 1] = values[i];
    return true;
  }

  Eigen::VectorXd weights() const {
    return labels_.partialPivLu().solve(Eigen::VectorXd::Unit(index(n_), 0));
  }

  /// Where the curve is: the zero of the interpolated map, or its mirror image.
  Point on_curve() const { return mirror_ && mirror_->height(point_) > 0 ? mirror_->image(point_) : point_; }
  const Branch& branch_on_curve() const {
    return mirror_ && mirror_->height(point_) > 0 ? mirror_->beyond : branch_;
  }

  void note_crossing(int direction, const Point& next) {
    const double before = here_.back() - 1, after = next.back() - 1;
    if (!(before * after < 0 || (after == 0 && before != 0))) return;
    const double part = before / (before - after);
    Point v = here_;
    for (std::size_t i = 0; i < n_; ++i) v[i] += part * (next[i] - v[i]);
    v.back() = 1;
    Branch branch = branch_on_curve();
    polish(branch, v);
    path_.crossings.push_back({v, branch, direction * (length_ + part * distance(here_, next))});
  }

  /// Newton's method for the guides, where it stays in the domain.
  void polish(const Branch& branch, Point& v) {
    Matrix<double> derivatives(map_->guides(), n_);
    for (int k = 0; k < 20; ++k) {
      if (!map_->jacobian(branch, v, values_, derivatives).is_inside) return;
      Eigen::MatrixXd matrix(index(n_) - 1, index(n_) - 1);
      for (std::size_t i = 0; i + 1 < n_; ++i) {
        for (std::size_t j = 0; j + 1 < n_; ++j) matrix(index(i), index(j)) = derivatives(i, j);
      }
      const Eigen::VectorXd change =
          matrix.partialPivLu().solve(Eigen::Map<const Eigen::VectorXd>(values_.data(), index(n_) - 1));
      if (!change.allFinite() || change.norm() > 10 * options_->mesh) return;
      Point moved = v;
      for (std::size_t i = 0; i + 1 < n_; ++i) moved[i] -= change[index(i)];
      if (!map_->values(branch, moved, values_).is_inside) return;
      v = moved;
      if (change.norm() < 1e-15 * (1 + norm(v))) return;
    }
  }

  /// Whether the path comes through the sketch again, on its branch and in the same direction.
  bool returns(int direction, const Point& next) const {
    const bool is_through = direction * here_.back() < 0 && direction * next.back() >= 0;
    const double near = 2 * std::sqrt(static_cast<double>(n_)) * options_->mesh;
    return is_through && path_.simplices > 2 * n_ && branch_on_curve() == start_branch_ &&
           distance(next, start_) < near;
  }

  void replace(std::size_t k) {
    const Point& before = vertices_[(k + n_) % (n_ + 1)].v;
    const Point& after = vertices_[(k + 1) % (n_ + 1)].v;
    for (std::size_t i = 0; i < n_; ++i) vertices_[k].v[i] = before[i] + after[i] - vertices_[k].v[i];
    compute(vertices_[k]);
  }

  static Eigen::Index index(std::size_t k) { return static_cast<Eigen::Index>(k); }

  BranchMap* map_;
  const PlanSimplexOptions* options_;
  std::stop_token stop_;
  const SimplexObserver* observer_;
  int direction_ = 1;
  std::size_t n_;
  std::vector<double> values_;
  Point start_;
  Branch start_branch_;
  Branch branch_;
  std::optional<Mirror> mirror_;
  std::vector<Vertex> vertices_;      ///< in the cyclic order
  std::vector<std::size_t> columns_;  ///< which vertex each column of the labels is of
  std::size_t fresh_ = 0;             ///< the vertex that is in no column
  Eigen::MatrixXd labels_;
  Eigen::VectorXd weights_;
  Point point_, here_;
  double length_ = 0;
  PlanSimplexPath path_;
};

}  // namespace

PlanSimplexPath follow_plan_simplices(BranchMap& map, const PlanValues& start,
                                      const PlanSimplexOptions& options, const std::stop_token& stop,
                                      const SimplexObserver& observer) {
  return Follower(map, start, options, stop, observer).follow();
}

}  // namespace gcslab
