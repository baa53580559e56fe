#include "homotopy/path_certifier.h"

#include <algorithm>
#include <cmath>

#include "certification/newton_iteration.h"

namespace gcslab {
namespace {

using Number = FastInterval;
using Scope = NumberTraits<FastInterval>::Scope;

constexpr double kSlack = 1e-9;        ///< of tubes at both ends, so that links lie inside
constexpr double kLeastWidth = 1e-13;  ///< of tubes
constexpr double kLongest = 2;         ///< arc between two points, in distances
constexpr double kShortest = 1e-6;     ///< tube that is tried

bool is_inside(const Number& a, const Number& b) { return a.lower() > b.lower() && a.upper() < b.upper(); }

bool is_part(const Number& a, const Number& b) { return a.lower() >= b.lower() && a.upper() <= b.upper(); }

double magnitude_of(const Number& x) { return std::max(-x.lower(), x.upper()); }

/// The interval with a part of its magnitude and a little more added at both ends.
Number inflated(const Number& x, double part, double least) {
  const double grow = part * magnitude_of(x) + least;
  return hull(Number(0), x) + Number(-grow, grow);
}

}  // namespace

PathCertifier::PathCertifier(Curve& curve, IntervalCurve& enclosure)
    : curve_(&curve),
      enclosure_(&enclosure),
      n_(curve.size() + 1),
      corrector_(curve, {CorrectorKind::newton, 1e-14, 20}),
      tangents_(curve),
      jacobian_(n_ - 1, n_, Number(0)),
      residual_(n_, n_, Number(0)),
      values_(n_ - 1) {}

bool PathCertifier::begin(const CurvePoint& point) {
  if (!go_on_from(point)) return false;
  beginning_ = last_;
  return true;
}

bool PathCertifier::go_on_from(const CurvePoint& point) {
  CurvePoint at = point;
  if (!improve(at) || !prepare(at)) return false;
  std::optional<Vector> box = enclosed(at, at.v, 0);
  if (!box) return false;
  at_ = std::move(at);
  last_ = std::move(*box);
  return true;
}

/// Moves the point to the curve as exactly as doubles can, across its tangent.
bool PathCertifier::improve(CurvePoint& point) {
  const Correction correction = corrector_.correct(point, {}, 1, point.v);
  return correction.end != Correction::End::undefined;
}

/// The inverse of (J; u) at a point with the tangent u.
bool PathCertifier::prepare(const CurvePoint& at) {
  Matrix<double> bordered(n_, n_);
  Matrix<double> jacobian(n_ - 1, n_);
  std::vector<double> values(n_ - 1);
  if (!curve_->jacobian(at.v, values, jacobian)) return false;
  std::copy_n(jacobian.data(), n_ * (n_ - 1), bordered.data());
  std::ranges::copy(at.tangent, bordered.row(n_ - 1).begin());
  std::optional<Matrix<double>> inverse = approximate_inverse(bordered);
  if (!inverse) return false;
  inverse_ = std::move(*inverse);
  return true;
}

/// The Jacobian and the residual over a box.
bool PathCertifier::compute_residual(const Vector& box, const std::vector<double>& u) {
  if (!enclosure_->jacobian(box, jacobian_)) return false;
  for (std::size_t i = 0; i < n_; ++i) {
    for (std::size_t j = 0; j < n_; ++j)
      residual_(i, j) = Number(i == j ? 1 : 0) - Number(inverse_(i, n_ - 1)) * Number(u[j]);
    for (std::size_t k = 0; k + 1 < n_; ++k) {
      if (inverse_(i, k) == 0) continue;
      const Number factor(inverse_(i, k));
      for (std::size_t j = 0; j < n_; ++j) {
        const Number& entry = jacobian_(k, j);
        if (entry.lower() != 0 || entry.upper() != 0) residual_(i, j) = residual_(i, j) - factor * entry;
      }
    }
  }
  return true;
}

/// inverse (values; last).
PathCertifier::Vector PathCertifier::preconditioned(const Vector& values, const Number& last) const {
  Vector result(n_, Number(0));
  for (std::size_t i = 0; i < n_; ++i) {
    Number sum = Number(inverse_(i, n_ - 1)) * last;
    for (std::size_t k = 0; k + 1 < n_; ++k) sum = sum + Number(inverse_(i, k)) * values[k];
    result[i] = sum;
  }
  return result;
}

/// Whether Krawczyk's operator, shift + residual y, maps y into its interior; `image` is where to.
bool PathCertifier::maps_inside(const Vector& shift, const Vector& y, Vector& image) const {
  bool is_inside_everywhere = true;
  for (std::size_t i = 0; i < n_; ++i) {
    image[i] = shift[i];
    for (std::size_t j = 0; j < n_; ++j) image[i] = image[i] + residual_(i, j) * y[j];
    is_inside_everywhere = is_inside_everywhere && is_inside(image[i], y[i]);
  }
  return is_inside_everywhere;
}

/// The tube of that length around the tangent at a point for which `prepare` was called.
std::optional<PathCertifier::Tube> PathCertifier::tube(const CurvePoint& at, double length) {
  constexpr int kAttempts = 4;
  const Scope scope;
  const std::vector<double>& u = at.tangent;
  Tube result{Number(-kSlack, length + kSlack), {}, Number(0), Number(0)};
  Vector axis(n_), centre(n_);
  for (std::size_t i = 0; i < n_; ++i) {
    centre[i] = Number(at.v[i]);
    axis[i] = centre[i] + result.s * Number(u[i]);
  }
  // The values on the axis: H(c) + (J u) s.
  if (!enclosure_->values(centre, values_) || !enclosure_->jacobian(axis, jacobian_)) return std::nullopt;
  for (std::size_t k = 0; k + 1 < n_; ++k) {
    Number along(0);
    for (std::size_t j = 0; j < n_; ++j) along = along + jacobian_(k, j) * Number(u[j]);
    values_[k] = values_[k] + along * result.s;
  }
  Vector shift = preconditioned(values_, Number(0));
  for (Number& x : shift) x = -x;
  Vector& y = result.y;
  for (const Number& x : shift) y.push_back(inflated(x, 0.2, kLeastWidth));
  Vector box(n_), image(n_);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    for (std::size_t i = 0; i < n_; ++i) box[i] = axis[i] + y[i];
    if (!compute_residual(box, u)) return std::nullopt;
    if (maps_inside(shift, y, image)) {
      ++tubes_;
      result.t = box.back();
      result.t_speed = speed_of_t(u);
      return result;
    }
    for (std::size_t i = 0; i < n_; ++i) {
      if (!(magnitude_of(image[i]) < 1)) return std::nullopt;
      y[i] = inflated(hull(y[i], image[i]), 0.1, kLeastWidth);
    }
  }
  return std::nullopt;
}

/// Of t by s along the arc in the box of the residual: with v' = u + y', J v' = 0 and u.y' = 0,
/// y' = -inverse (J u; 0) + residual y', hence |y'| <= |q| + |residual| |q| / (1 - |residual|), q the first
/// term.
Number PathCertifier::speed_of_t(const std::vector<double>& u) const {
  Vector along(n_ - 1, Number(0));
  for (std::size_t k = 0; k + 1 < n_; ++k) {
    for (std::size_t j = 0; j < n_; ++j) along[k] = along[k] + jacobian_(k, j) * Number(u[j]);
  }
  const Vector q = preconditioned(along, Number(0));
  Number norm(0), row_of_t(0), largest(0);
  for (std::size_t i = 0; i < n_; ++i) {
    Number sum(0);
    for (std::size_t j = 0; j < n_; ++j) sum = sum + Number(0, magnitude_of(residual_(i, j)));
    if (sum.upper() > norm.upper()) norm = sum;
    if (i + 1 == n_) row_of_t = sum;
    largest = hull(largest, Number(0, magnitude_of(q[i])));
  }
  if (!(norm.upper() < 1)) return Number(-HUGE_VAL, HUGE_VAL);
  const Number rest = row_of_t * largest / (Number(1) - Number(norm.upper()));
  const double reach = (Number(magnitude_of(q.back())) + rest).upper();
  return Number(u.back()) + Number(-reach, reach);
}

/// A box around the one point of the curve near the guess with u.(v - c) = s (u.u).
std::optional<PathCertifier::Vector> PathCertifier::enclosed(const CurvePoint& at,
                                                             const std::vector<double>& guess, double s) {
  constexpr int kAttempts = 3;
  const Scope scope;
  const std::vector<double>& u = at.tangent;
  Vector centre;
  for (const double x : guess) centre.emplace_back(x);
  if (!enclosure_->values(centre, values_)) return std::nullopt;
  Number height(0), square(0);
  for (std::size_t i = 0; i < n_; ++i) {
    height = height + Number(u[i]) * (centre[i] - Number(at.v[i]));
    square = square + sqr(Number(u[i]));
  }
  Vector shift = preconditioned(values_, height - Number(s) * square);
  for (Number& x : shift) x = -x;
  Vector y, box(n_), image(n_);
  for (const Number& x : shift) y.push_back(inflated(x, 1, 1e-15));
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    for (std::size_t i = 0; i < n_; ++i) box[i] = centre[i] + y[i];
    if (!compute_residual(box, u)) return std::nullopt;
    if (maps_inside(shift, y, image)) {
      for (std::size_t i = 0; i < n_; ++i) box[i] = centre[i] + image[i];
      return box;
    }
    for (std::size_t i = 0; i < n_; ++i) y[i] = inflated(hull(y[i], image[i]), 0.5, 1e-15);
  }
  return std::nullopt;
}

/// u.(box - c) / (u.u).
Number PathCertifier::height(const CurvePoint& at, const Vector& box) const {
  Number height(0), square(0);
  for (std::size_t i = 0; i < n_; ++i) {
    const Number u(at.tangent[i]);
    height = height + u * (box[i] - Number(at.v[i]));
    square = square + sqr(u);
  }
  return height / square;
}

bool PathCertifier::contains(const Tube& tube, const CurvePoint& at, const Vector& box) const {
  const Scope scope;
  const Number s = height(at, box);
  if (!is_part(s, tube.s)) return false;
  for (std::size_t i = 0; i < n_; ++i) {
    const Number y = box[i] - Number(at.v[i]) - s * Number(at.tangent[i]);
    if (!is_part(y, tube.y[i])) return false;
  }
  return true;
}

/// How often the arc between two points in the tube crosses t = 1; nothing where that is not clear.
std::optional<std::uint64_t> PathCertifier::crossings(const Tube& tube, const Vector& from,
                                                      const Vector& to) const {
  const auto is_clear = [](const Number& t) { return t.upper() < 1 || t.lower() > 1; };
  if (is_clear(tube.t)) return 0;
  if (!is_clear(from.back()) || !is_clear(to.back())) return std::nullopt;
  if (tube.t_speed.lower() <= 0 && tube.t_speed.upper() >= 0) return std::nullopt;
  return (from.back().upper() < 1) != (to.back().upper() < 1) ? 1 : 0;
}

std::optional<PathCertifier::Arc> PathCertifier::follow(const CurvePoint& next) {
  CurvePoint end = next;
  if (!improve(end) || !prepare(end)) return std::nullopt;
  const std::optional<Vector> target = enclosed(end, end.v, 0);
  if (!target) return std::nullopt;
  Arc arc;
  CurvePoint at = at_;
  Vector last = last_;
  double length = length_;
  bool is_prepared = false;
  double left = kLongest * distance(at.v, end.v);
  while (left > 0) {
    if (!is_prepared && !prepare(at)) return std::nullopt;
    is_prepared = true;
    length = std::min(length, 1.1 * distance(at.v, end.v));
    const std::optional<Tube> around = tube(at, length);
    std::vector<double> guess;
    Vector to;
    bool is_end = false;
    std::optional<std::uint64_t> crossed;
    if (around && contains(*around, at, last)) {
      is_end = contains(*around, at, *target);
      if (!is_end) {
        guess = at.v;
        for (std::size_t i = 0; i < n_; ++i) guess[i] += length * at.tangent[i];
        static_cast<void>(corrector_.correct(at, {}, 1, guess));
        std::optional<Vector> link = enclosed(at, guess, length);
        if (link && contains(*around, at, *link)) to = std::move(*link);
      } else {
        to = *target;
      }
      if (!to.empty()) crossed = crossings(*around, last, to);
    }
    if (!crossed) {
      length /= 2;
      if (length < kShortest) return std::nullopt;
      continue;
    }
    arc.crossings += *crossed;
    if (contains(*around, at, beginning_)) {
      const Scope scope;
      const Number s = height(at, beginning_);
      arc.passes_beginning = arc.passes_beginning ||
                             (s.lower() > height(at, last).upper() && s.upper() <= height(at, to).lower());
    }
    if (is_end) {
      at_ = std::move(end);
      last_ = *target;
      length_ = std::max(length, 100 * kShortest);
      return arc;
    }
    left -= length;
    last = std::move(to);
    CurvePoint further{std::move(guess), {}};
    if (!tangents_.find(further, at.tangent)) return std::nullopt;
    at = std::move(further);
    is_prepared = false;
    length *= 1.5;
  }
  return std::nullopt;
}

}  // namespace gcslab
