#include "spline/closest_point.h"

#include "interval/fast_interval.h"
#include "spline/power_form.h"

namespace gcslab {
namespace {

constexpr int kRootBits = 160;

/// A parameter that may be closest.
struct Candidate {
  RationalInterval parameter;
  std::vector<RationalInterval> point;
  RationalInterval square;  ///< of the distance
};

void check(const BSplineCurve<double>& curve, std::span<const double> point, double tolerance) {
  if (point.size() != curve.dimension())
    throw InputError("closest point: the point has " + std::to_string(point.size()) +
                     " coordinates, expected " + std::to_string(curve.dimension()) + " as the curve");
  for (const double x : point) {
    if (!std::isfinite(x))
      throw InputError("closest point: coordinate " + number_text(x) + ", expected a finite number");
  }
  if (!(tolerance >= 0)) throw InputError("tolerance " + number_text(tolerance) + ": expected 0 or more");
}

/// The root of the squares, rounded outward; below 0 counts as 0.
Interval root(const RationalInterval& square) {
  const NumberTraits<FastInterval>::Scope scope;
  return sqrt(FastInterval(rounded(square))).interval();
}

/// The least squared distance of the box of a piece's control points.
Rational square_of_distance_of_box(const BezierPiece<Rational>& piece, const std::vector<Rational>& target) {
  Rational sum = 0;
  for (std::size_t c = 0; c < target.size(); ++c) {
    Rational lower = piece.points(0, c);
    Rational upper = lower;
    for (std::size_t i = 1; i < piece.points.rows(); ++i) {
      lower = std::min(lower, piece.points(i, c));
      upper = std::max(upper, piece.points(i, c));
    }
    const Rational gap =
        max(Rational(max(Rational(lower - target[c]), Rational(target[c] - upper))), Rational(0));
    sum += gap * gap;
  }
  return sum;
}

Candidate end_candidate(const BezierPiece<Rational>& piece, bool at_end,
                        const std::vector<Rational>& target) {
  const Rational& u = at_end ? piece.end : piece.start;
  const auto row = piece.points.row(at_end ? piece.points.rows() - 1 : 0);
  Candidate result{{u, u}, {}, {0, 0}};
  for (std::size_t c = 0; c < target.size(); ++c) {
    result.point.push_back({row[c], row[c]});
    result.square.lower += sqr(Rational(row[c] - target[c]));
  }
  result.square.upper = result.square.lower;
  return result;
}

/// The critical points strictly inside a piece.
std::vector<Candidate> critical_candidates(const BezierPiece<Rational>& piece,
                                           const std::vector<Rational>& target) {
  const std::vector<PowerForm> forms = power_forms(piece);
  PowerForm square;
  for (std::size_t c = 0; c < forms.size(); ++c) {
    const PowerForm difference = sum(forms[c], {Rational(-target[c])});
    square = sum(square, product(difference, difference));
  }
  std::vector<Candidate> result;
  const Rational width = piece.end - piece.start;
  for (const RationalInterval& t : unit_roots(derivative(square), kRootBits)) {
    if (t.lower == t.upper && (t.lower == 0 || t.lower == 1)) continue;
    Candidate candidate{
        {piece.start + width * t.lower, piece.start + width * t.upper}, {}, range_on(square, t)};
    for (const PowerForm& form : forms) candidate.point.push_back(range_on(form, t));
    result.push_back(std::move(candidate));
  }
  return result;
}

/// The same end of two pieces that meet there.
bool is_same_end(const Candidate& a, const Candidate& b) {
  const auto same = [](const RationalInterval& x, const RationalInterval& y) {
    return x.lower == y.lower && x.upper == y.upper;
  };
  return same(a.parameter, b.parameter) && std::ranges::equal(a.point, b.point, same);
}

ClosestPoint rounded_point(const Candidate& candidate) {
  ClosestPoint result{rounded(candidate.parameter), {}, root(candidate.square)};
  for (const RationalInterval& x : candidate.point) result.point.push_back(rounded(x));
  return result;
}

}  // namespace

std::vector<ClosestPoint> closest_points(const BSplineCurve<double>& curve, std::span<const double> point,
                                         double tolerance) {
  check(curve, point, tolerance);
  std::vector<Rational> target;
  for (const double x : point) target.push_back(rational_from_double(x));
  const auto pieces = bezier_pieces(converted<Rational>(curve));
  std::vector<Candidate> candidates;
  for (const auto& piece : pieces) {
    candidates.push_back(end_candidate(piece, false, target));
    candidates.push_back(end_candidate(piece, true, target));
  }
  double least = std::numeric_limits<double>::infinity();
  for (const Candidate& candidate : candidates) least = std::min(least, root(candidate.square).upper);
  const NumberTraits<FastInterval>::Scope scope;
  const auto limit = [&] { return rounded_add(least, tolerance); };
  for (const auto& piece : pieces) {
    const Rational square = square_of_distance_of_box(piece, target);
    if (root({square, square}).lower > limit()) continue;
    for (Candidate& candidate : critical_candidates(piece, target)) {
      least = std::min(least, root(candidate.square).upper);
      candidates.push_back(std::move(candidate));
    }
  }
  std::erase_if(candidates,
                [&](const Candidate& candidate) { return root(candidate.square).lower > limit(); });
  std::ranges::sort(candidates, {}, [](const Candidate& c) { return c.parameter.lower; });
  candidates.erase(std::unique(candidates.begin(), candidates.end(), is_same_end), candidates.end());
  std::vector<ClosestPoint> result;
  for (const Candidate& candidate : candidates) result.push_back(rounded_point(candidate));
  return result;
}

}  // namespace gcslab
