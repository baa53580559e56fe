#include "spline/bounding_box.h"

#include "spline/power_form.h"

namespace gcslab {
namespace {

constexpr int kRootBits = 128;

void include(RationalInterval& range, const RationalInterval& values) {
  range.lower = std::min(range.lower, values.lower);
  range.upper = std::max(range.upper, values.upper);
}

/// Where the derivative of a coordinate vanishes: of n / w, where n' w - n w' does.
std::vector<RationalInterval> turning_points(const ExactPiece& piece, std::size_t coordinate) {
  const PowerForm& form = piece.coordinates[coordinate];
  return unit_roots(
      sum(product(derivative(form), piece.weight), scaled(product(form, derivative(piece.weight)), -1)),
      kRootBits);
}

RationalInterval range_of(const std::vector<ExactPiece>& pieces, std::size_t coordinate) {
  const Rational& start = pieces.front().first()[coordinate];
  RationalInterval range{start, start};
  for (const ExactPiece& piece : pieces) {
    for (const auto& end : {piece.first(), piece.last()}) include(range, {end[coordinate], end[coordinate]});
  }
  for (const ExactPiece& piece : pieces) {
    const RationalInterval hull = piece.box()[coordinate];
    if (range.lower <= hull.lower && hull.upper <= range.upper) continue;
    for (const RationalInterval& t : turning_points(piece, coordinate))
      include(range, range_on(piece.coordinates[coordinate], piece.weight, t));
  }
  return range;
}

Box box_of(const std::vector<ExactPiece>& pieces) {
  Box box;
  for (std::size_t c = 0; c < pieces.front().dimension(); ++c) box.push_back(rounded(range_of(pieces, c)));
  return box;
}

/// Twice the signed area of a triangle.
Rational turn(std::span<const Rational> a, std::span<const Rational> b, std::span<const Rational> c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Whether it lies on the segment.
bool is_between(std::span<const Rational> a, std::span<const Rational> b, std::span<const Rational> p) {
  return turn(a, b, p) == 0 && (p[0] - a[0]) * (p[0] - b[0]) <= 0 && (p[1] - a[1]) * (p[1] - b[1]) <= 0;
}

/// Whether it lies inside the triangle, off its border.
bool is_in_triangle(std::span<const Rational> a, std::span<const Rational> b, std::span<const Rational> c,
                    std::span<const Rational> p) {
  const int signs[] = {sgn(turn(a, b, p)), sgn(turn(b, c, p)), sgn(turn(c, a, p))};
  const auto [least, most] = std::minmax_element(std::begin(signs), std::end(signs));
  return *least > 0 || *most < 0;
}

}  // namespace

Box bounding_box(const BSplineCurve<Rational>& curve) { return box_of(exact_pieces(curve)); }
Box bounding_box(const RationalCurve<Rational>& curve) { return box_of(exact_pieces(curve)); }

bool is_in_convex_hull(const Matrix<Rational>& points, std::span<const Rational> point) {
  if (points.columns() != 2 || point.size() != 2)
    throw InputError("convex hull: expected points of two coordinates");
  // Caratheodory 1907: a hull in the plane is the union of the triangles of its points, degenerate ones being
  // segments.
  for (std::size_t i = 0; i < points.rows(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      if (is_between(points.row(i), points.row(j), point)) return true;
      for (std::size_t k = 0; k < j; ++k) {
        if (is_in_triangle(points.row(i), points.row(j), points.row(k), point)) return true;
      }
    }
  }
  return false;
}

bool has_convex_hull_property(const BSplineCurve<Rational>& curve, const Rational& u) {
  const std::size_t span = curve.knots.find_span(u);
  const auto degree = static_cast<std::size_t>(curve.degree());
  Matrix<Rational> active(degree + 1, curve.dimension());
  const Rational* first = curve.points.row(span - degree).data();
  std::copy(first, first + active.rows() * active.columns(), active.data());
  return is_in_convex_hull(active, evaluate(curve, u));
}

}  // namespace gcslab
