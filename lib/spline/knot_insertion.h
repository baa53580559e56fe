#pragma once

// Insertion of knots: the same curve over a finer knot vector.
//
// Inserting u into span k, u_k <= u < u_{k+1}, where it has multiplicity s, replaces the points by
//   Q_i = a_i P_i + (1 - a_i) P_{i-1},  a_i = (u - u_i) / (u_{i+d} - u_i),  k - d + 1 <= i <= k - s,
// (Boehm 1980): convex combinations, so that rounding errors do not grow. Many knots are inserted from the
// right to the left, as in algorithm A5.4 of Piegl, Tiller 1997: O(n + r d) points for r knots.

#include <iterator>

#include "spline/curve.h"

namespace gcslab {

namespace spline_detail {

/// A curve in two halves: what is still to be refined, and what lies to its right, from right to left.
template <class T>
class Refinement {
 public:
  explicit Refinement(const BSplineCurve<T>& curve)
      : degree_(static_cast<std::size_t>(curve.degree())),
        dimension_(curve.dimension()),
        knots_(curve.knots.knots()),
        points_(curve.points.data(), curve.points.data() + curve.points.rows() * dimension_) {}

  /// Inserts a parameter that is no greater than those before it.
  void insert(const T& u) {
    while (surely_less(u, knots_.back())) move_back(knots_, knots_to_the_right_, 1);
    const std::size_t k = knots_.size() - 1;
    const std::size_t s = copies(u);
    const std::size_t last = k - s;
    while (points_.size() / dimension_ > last + 1) move_back(points_, points_to_the_right_, dimension_);
    for (std::size_t c = 0; c < dimension_; ++c)
      points_to_the_right_.push_back(points_[(last + 1) * dimension_ - 1 - c]);
    for (std::size_t i = last; i + degree_ > k; --i) combine(u, i, k);
    knots_.push_back(u);
  }

  BSplineCurve<T> curve() {
    std::move(knots_to_the_right_.rbegin(), knots_to_the_right_.rend(), std::back_inserter(knots_));
    std::move(points_to_the_right_.rbegin(), points_to_the_right_.rend(), std::back_inserter(points_));
    Matrix<T> points(points_.size() / dimension_, dimension_);
    std::move(points_.begin(), points_.end(), points.data());
    return BSplineCurve<T>(KnotVector<T>(static_cast<int>(degree_), std::move(knots_)), std::move(points));
  }

 private:
  static void move_back(std::vector<T>& from, std::vector<T>& to, std::size_t count) {
    for (; count > 0; --count) {
      to.push_back(std::move(from.back()));
      from.pop_back();
    }
  }

  std::size_t copies(const T& u) const {
    std::size_t count = 0;
    while (count < knots_.size() && same_knot(knots_[knots_.size() - 1 - count], u)) ++count;
    return count;
  }

  void combine(const T& u, std::size_t i, std::size_t k) {
    const T& upper = knots_to_the_right_[knots_to_the_right_.size() - (i + degree_ - k)];
    const T weight = (u - knots_[i]) / (upper - knots_[i]);
    const T complement = whole_number<T>(1) - weight;
    for (std::size_t c = i * dimension_; c < (i + 1) * dimension_; ++c)
      points_[c] = complement * points_[c - dimension_] + weight * points_[c];
  }

  std::size_t degree_;
  std::size_t dimension_;
  std::vector<T> knots_;
  std::vector<T> points_;
  std::vector<T> knots_to_the_right_;
  std::vector<T> points_to_the_right_;
};

/// What InputErrors say of knots that cannot be inserted.
template <class T>
void check_insertion(const KnotVector<T>& knots, const std::vector<T>& ascending) {
  for (std::size_t i = 0; i < ascending.size();) {
    const T& u = ascending[i];
    const auto is_other = [&](const T& other) { return !same_knot(u, other); };
    const auto next =
        std::find_if(ascending.begin() + static_cast<std::ptrdiff_t>(i), ascending.end(), is_other);
    const auto times = static_cast<std::size_t>(next - ascending.begin()) - i;
    static_cast<void>(knots.find_spans(u));
    if (knots.multiplicity(u) + static_cast<int>(times) > knots.degree() + 1)
      throw InputError("knot " + number_text(u) + " would occur " +
                       std::to_string(knots.multiplicity(u) + static_cast<int>(times)) + " times, degree " +
                       std::to_string(knots.degree()) + " allows " + std::to_string(knots.degree() + 1));
    i += times;
  }
}

}  // namespace spline_detail

/// The curve with further knots, in any order, each as often as it is listed. Throws InputError for a knot
/// outside of the domain and for a multiplicity above d + 1.
template <class T>
BSplineCurve<T> refined(const BSplineCurve<T>& curve, std::vector<T> new_knots) {
  if (!std::ranges::all_of(new_knots, [](const T& u) { return is_finite_number(u); }))
    throw InputError("knots to insert: expected finite numbers");
  std::sort(new_knots.begin(), new_knots.end(), [](const T& a, const T& b) { return surely_less(a, b); });
  spline_detail::check_insertion(curve.knots, new_knots);
  spline_detail::Refinement<T> refinement(curve);
  for (std::size_t i = new_knots.size(); i > 0; --i) refinement.insert(new_knots[i - 1]);
  return refinement.curve();
}

/// The curve with u inserted that many times, as refined. Throws InputError also for a negative number.
template <class T>
BSplineCurve<T> with_knot(const BSplineCurve<T>& curve, const T& u, int times = 1) {
  if (times < 0)
    throw InputError("knot " + number_text(u) + " to be inserted " + std::to_string(times) +
                     " times: expected 0 or more");
  return refined(curve, std::vector<T>(static_cast<std::size_t>(times), u));
}

}  // namespace gcslab
