#include "spline/power_form.h"

#include "base/check.h"

namespace gcslab {

namespace {

/// One a coordinate of a piece.
std::vector<PowerForm> power_forms(const Matrix<Rational>& points) {
  const std::size_t count = points.rows();
  std::vector<PowerForm> forms;
  for (std::size_t c = 0; c < points.columns(); ++c) {
    PowerForm differences;
    for (std::size_t i = 0; i < count; ++i) differences.push_back(points(i, c));
    for (std::size_t k = 1; k < count; ++k) {
      for (std::size_t i = count - 1; i >= k; --i) differences[i] -= differences[i - 1];
    }
    Rational binomial = 1;
    for (std::size_t k = 0; k < count; ++k) {
      differences[k] *= binomial;
      binomial *= Rational(static_cast<unsigned long>(count - 1 - k));
      binomial /= Rational(static_cast<unsigned long>(k + 1));
    }
    forms.push_back(std::move(differences));
  }
  return forms;
}

/// The polynomial times a common denominator; not for zero.
IntegerPolynomial integer_multiple(const PowerForm& a) {
  mpz_class denominator = 1;
  for (const Rational& c : a) denominator = lcm(denominator, c.get_den());
  std::vector<mpz_class> integers;
  for (const Rational& c : a) integers.emplace_back(Rational(c * denominator).get_num());
  while (integers.back() == 0) integers.pop_back();
  return IntegerPolynomial(std::move(integers));
}

Matrix<Rational> projected(const Matrix<Rational>& homogeneous) {
  Matrix<Rational> points(homogeneous.rows(), homogeneous.columns() - 1);
  for (std::size_t i = 0; i < points.rows(); ++i) {
    for (std::size_t c = 0; c < points.columns(); ++c)
      points(i, c) = homogeneous(i, c) / homogeneous(i, points.columns());
  }
  return points;
}

}  // namespace

PowerForm product(const PowerForm& a, const PowerForm& b) {
  if (a.empty() || b.empty()) return {};
  PowerForm result(a.size() + b.size() - 1, Rational(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  }
  return result;
}

PowerForm sum(const PowerForm& a, const PowerForm& b) {
  PowerForm result = a;
  result.resize(std::max(a.size(), b.size()), Rational(0));
  for (std::size_t i = 0; i < b.size(); ++i) result[i] += b[i];
  return result;
}

PowerForm scaled(const PowerForm& a, const Rational& factor) { return product(a, {factor}); }

PowerForm derivative(const PowerForm& a) {
  PowerForm result;
  for (std::size_t k = 1; k < a.size(); ++k)
    result.emplace_back(a[k] * Rational(static_cast<unsigned long>(k)));
  return result;
}

Rational value(const PowerForm& a, const Rational& t) {
  Rational result = 0;
  for (std::size_t k = a.size(); k > 0; --k) result = result * t + a[k - 1];
  return result;
}

bool is_zero(const PowerForm& a) {
  return std::ranges::all_of(a, [](const Rational& c) { return c == 0; });
}

std::vector<RationalInterval> unit_roots(const PowerForm& a, int bits) {
  if (is_zero(a)) return {};
  RealRoots roots(integer_multiple(a), {Rational(0), Rational(1)});
  const Rational width = pow(Rational(2), -bits);
  std::vector<RationalInterval> result;
  for (std::size_t i = 0; i < roots.roots().size(); ++i) {
    roots.try_exact(i, 0);
    roots.try_exact(i, 1);
    roots.refine(i, width);
    result.push_back({roots.roots()[i].lower, roots.roots()[i].upper});
  }
  return result;
}

bool has_real_root(const PowerForm& a) {
  return is_zero(a) || !RealRoots(integer_multiple(a), {}).roots().empty();
}

RationalInterval range_on(const PowerForm& a, const RationalInterval& t) {
  const Rational middle = value(a, Rational((t.lower + t.upper) / 2));
  Rational steepness = 0;
  for (const Rational& c : derivative(a)) steepness += abs(c);
  const Rational slack = steepness * (t.upper - t.lower) / 2;
  return {middle - slack, middle + slack};
}

RationalInterval range_on(const PowerForm& a, const PowerForm& b, const RationalInterval& t) {
  const RationalInterval top = range_on(a, t);
  const RationalInterval bottom = range_on(b, t);
  GCSLAB_CHECK(bottom.lower > 0);
  return {top.lower / (top.lower < 0 ? bottom.lower : bottom.upper),
          top.upper / (top.upper < 0 ? bottom.upper : bottom.lower)};
}

Interval rounded(const RationalInterval& x) {
  return {NumberTraits<Rational>::enclosure(x.lower).lower, NumberTraits<Rational>::enclosure(x.upper).upper};
}

RationalBox ExactPiece::box() const {
  RationalBox box;
  for (std::size_t c = 0; c < points.columns(); ++c) {
    box.push_back({points(0, c), points(0, c)});
    for (std::size_t i = 1; i < points.rows(); ++i) {
      box[c].lower = std::min(box[c].lower, points(i, c));
      box[c].upper = std::max(box[c].upper, points(i, c));
    }
  }
  return box;
}

std::vector<ExactPiece> exact_pieces(const BSplineCurve<Rational>& curve) {
  std::vector<ExactPiece> result;
  for (BezierPiece<Rational>& piece : bezier_pieces(curve)) {
    std::vector<PowerForm> forms = power_forms(piece.points);
    result.push_back({piece.start, piece.end, std::move(forms), {Rational(1)}, std::move(piece.points)});
  }
  return result;
}

std::vector<ExactPiece> exact_pieces(const RationalCurve<Rational>& curve) {
  std::vector<ExactPiece> result;
  for (const BezierPiece<Rational>& piece : bezier_pieces(curve.homogeneous)) {
    std::vector<PowerForm> forms = power_forms(piece.points);
    PowerForm weight = std::move(forms.back());
    forms.pop_back();
    result.push_back({piece.start, piece.end, std::move(forms), std::move(weight), projected(piece.points)});
  }
  return result;
}

}  // namespace gcslab
