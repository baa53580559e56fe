#include "homotopy/simplex_tracker.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "homotopy/level_crossing.h"

namespace gcslab {
namespace {

using Lattice = std::vector<std::int64_t>;

/// A simplex with the inverse of the matrix whose columns are (1, H(v)) of the vertices of the face through
/// which the polygon came.
class Simplices {
 public:
  Simplices(Curve& curve, const std::vector<double>& start, const SimplexOptions& options)
      : curve_(&curve), options_(&options), n_(start.size()), values_(curve.size()) {
    // The face in t = 0 has the start as its barycentre.
    const std::size_t m = n_ - 1;
    origin_.resize(n_, 0.0);
    for (std::size_t i = 0; i < m; ++i)
      origin_[i] = start[i] - options.mesh * static_cast<double>(m - i) / static_cast<double>(m + 1);
    first_.assign(n_ + 1, Lattice(n_, 0));
    for (std::size_t k = 1; k <= n_; ++k) {
      first_[k] = first_[k - 1];
      ++first_[k][k - 1];  // the last one alone has t > 0
    }
    first_face_.assign(first_.begin(), first_.begin() + static_cast<std::ptrdiff_t>(n_));
    std::ranges::sort(first_face_);
    settle();
  }

  /// Sets out from the face in t = 0 to that side. False where H is undefined at a vertex.
  bool set_out(int side) {
    vertices_ = first_;
    if (side < 0) replace(n_);
    return begin();
  }

  /// Goes through the simplex to its other face. False where H is undefined at the new vertex.
  bool pass() {
    Eigen::VectorXd column(static_cast<Eigen::Index>(n_));
    if (!label(fresh_, column)) return false;
    const Eigen::VectorXd lambda = weights(), direction = inverse_ * column;
    Eigen::Index leaving = -1;
    for (Eigen::Index k = 0; k < lambda.size(); ++k) {
      if (!(direction[k] > 1e-12)) continue;
      if (leaving < 0 || lambda[k] * direction[leaving] < lambda[leaving] * direction[k]) leaving = k;
    }
    if (leaving < 0) return false;
    // The inverse with one column of the matrix replaced.
    const Eigen::RowVectorXd pivot = inverse_.row(leaving) / direction[leaving];
    inverse_ -= direction * pivot;
    inverse_.row(leaving) = pivot;
    labels_.col(leaving) = column;
    const std::size_t old = std::exchange(columns_[static_cast<std::size_t>(leaving)], fresh_);
    if (++since_inverted_ >= kInvertEvery) invert();
    replace(old);
    fresh_ = old;
    return true;
  }

  /// The zero of the interpolated map on the face through which the polygon leaves.
  std::vector<double> point() const {
    const Eigen::VectorXd lambda = weights();
    std::vector<double> result(n_, 0.0);
    for (std::size_t k = 0; k < n_; ++k) {
      const std::vector<double> v = position(vertices_[columns_[k]]);
      for (std::size_t i = 0; i < n_; ++i) result[i] += lambda[static_cast<Eigen::Index>(k)] * v[i];
    }
    return result;
  }

  bool is_at_first_face() const {
    std::vector<Lattice> face;
    for (const std::size_t k : columns_) {
      if (vertices_[k].back() != 0) return false;
      face.push_back(vertices_[k]);
    }
    std::ranges::sort(face);
    return face == first_face_;
  }

 private:
  static constexpr int kInvertEvery = 200;

  /// Moves the lattice until the interpolated map has its zero in the first face, as H has.
  void settle() {
    constexpr int kAttempts = 50;
    vertices_ = first_;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      if (!begin()) break;
      const Eigen::VectorXd lambda = weights();
      if (!lambda.allFinite()) break;
      if (lambda.minCoeff() > 0.1 / static_cast<double>(n_)) return;
      const std::vector<double> zero = point();
      for (std::size_t i = 0; i + 1 < n_; ++i) {
        const double barycentre =
            origin_[i] + options_->mesh * static_cast<double>(n_ - 1 - i) / static_cast<double>(n_);
        origin_[i] += zero[i] - barycentre;
      }
    }
    throw NotApplicable("the mesh is too coarse: the interpolated equations have no zero beside the sketch");
  }

  /// The matrix of the face without the last vertex.
  bool begin() {
    fresh_ = n_;
    labels_.resize(static_cast<Eigen::Index>(n_), static_cast<Eigen::Index>(n_));
    columns_.clear();
    for (std::size_t k = 0; k < n_; ++k) {
      if (!label(k, labels_.col(static_cast<Eigen::Index>(k)))) return false;
      columns_.push_back(k);
    }
    invert();
    return true;
  }

  std::vector<double> position(const Lattice& vertex) const {
    std::vector<double> v(n_);
    for (std::size_t i = 0; i < n_; ++i) v[i] = origin_[i] + options_->mesh * static_cast<double>(vertex[i]);
    return v;
  }

  bool label(std::size_t vertex, Eigen::Ref<Eigen::VectorXd> column) {
    if (!curve_->values(position(vertices_[vertex]), values_)) return false;
    column[0] = 1;
    for (std::size_t i = 0; i < values_.size(); ++i) column[static_cast<Eigen::Index>(i) + 1] = values_[i];
    return column.allFinite();
  }

  void invert() {
    inverse_ = labels_.partialPivLu().inverse();
    since_inverted_ = 0;
  }

  Eigen::VectorXd weights() const { return inverse_.col(0); }

  void replace(std::size_t k) {
    const Lattice& before = vertices_[(k + n_) % (n_ + 1)];
    const Lattice& after = vertices_[(k + 1) % (n_ + 1)];
    for (std::size_t i = 0; i < n_; ++i) vertices_[k][i] = before[i] + after[i] - vertices_[k][i];
  }

  Curve* curve_;
  const SimplexOptions* options_;
  std::size_t n_;
  std::vector<double> values_, origin_;
  std::vector<Lattice> first_, vertices_;  ///< in the cyclic order
  std::vector<Lattice> first_face_;
  std::vector<std::size_t> columns_;  ///< which vertex each column is of
  std::size_t fresh_ = 0;             ///< the vertex that is in no column
  Eigen::MatrixXd labels_, inverse_;
  int since_inverted_ = 0;
};

class Follower {
 public:
  Follower(Curve& curve, const std::vector<double>& start, const SimplexOptions& options,
           const std::stop_token& stop, const PathObserver& observer)
      : curve_(&curve),
        options_(&options),
        stop_(stop),
        observer_(&observer),
        simplices_(curve, start, options),
        start_(start) {}

  Path follow() {
    Path& path = state_.path;
    path.end = path.other_end = run(1);
    path.last = path.other_last = path.end == PathEnd::cycle ? start_ : state_.here.v;
    if (path.end == PathEnd::to_infinity || path.end == PathEnd::to_undefined) {
      path.other_end = run(-1);
      path.other_last = state_.here.v;
    }
    return std::move(path);
  }

 private:
  PathEnd run(int direction) {
    Path& path = state_.path;
    state_.direction = direction;
    state_.here.v = start_;
    state_.length = 0;
    if (!simplices_.set_out(direction)) return PathEnd::to_undefined;
    while (path.steps < options_->maximum_simplices && !stop_.stop_requested()) {
      if (!simplices_.pass()) return PathEnd::to_undefined;
      ++path.steps;
      std::vector<double> next = simplices_.point();
      note_crossing(next);
      const double travelled = distance(state_.here.v, next);
      state_.length += travelled;
      path.length += travelled;
      state_.here.v = std::move(next);
      if (*observer_) (*observer_)(state_);
      if (simplices_.is_at_first_face()) return PathEnd::cycle;
      if (norm(state_.here.v) > options_->infinity) return PathEnd::to_infinity;
    }
    return PathEnd::budget;
  }

  void note_crossing(const std::vector<double>& next) {
    const double before = state_.here.v.back() - 1, after = next.back() - 1;
    if (!(before * after < 0 || (after == 0 && before != 0))) return;
    const double part = before / (before - after);
    std::vector<double> v = state_.here.v;
    for (std::size_t i = 0; i < v.size(); ++i) v[i] += part * (next[i] - v[i]);
    v.back() = 1;
    solve_at_level(*curve_, v);
    const double length = state_.direction * (state_.length + part * distance(state_.here.v, next));
    const std::size_t rank = rank_at(*curve_, v);
    state_.path.crossings.push_back({std::move(v), length, rank});
  }

  Curve* curve_;
  const SimplexOptions* options_;
  std::stop_token stop_;
  const PathObserver* observer_;
  Simplices simplices_;
  std::vector<double> start_;
  PathState state_;
};

}  // namespace

Path follow_simplices(Curve& curve, const std::vector<double>& start, const SimplexOptions& options,
                      const std::stop_token& stop, const PathObserver& observer) {
  return Follower(curve, start, options, stop, observer).follow();
}

}  // namespace gcslab
