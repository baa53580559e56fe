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

void check(std::size_t dimension, std::span<const double> point, double tolerance) {
  if (point.size() != dimension)
    throw InputError("closest point: the point has " + std::to_string(point.size()) +
                     " coordinates, expected " + std::to_string(dimension) + " as the curve");
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
Rational square_of_distance_of_box(const ExactPiece& piece, const std::vector<Rational>& target) {
  const RationalBox box = piece.box();
  Rational sum = 0;
  for (std::size_t c = 0; c < target.size(); ++c) {
    const Rational outside = max(Rational(box[c].lower - target[c]), Rational(target[c] - box[c].upper));
    if (outside > 0) sum += outside * outside;
  }
  return sum;
}

Candidate end_candidate(const Rational& parameter, std::span<const Rational> end,
                        const std::vector<Rational>& target) {
  Candidate result{{parameter, parameter}, {}, {0, 0}};
  for (std::size_t c = 0; c < target.size(); ++c) {
    result.point.push_back({end[c], end[c]});
    result.square.lower += sqr(Rational(end[c] - target[c]));
  }
  result.square.upper = result.square.lower;
  return result;
}

/// The critical points strictly inside a piece: where (s / w^2)' w^3 = s' w - 2 s w' vanishes, s / w^2 the
/// square of the distance.
std::vector<Candidate> critical_candidates(const ExactPiece& piece, const std::vector<Rational>& target) {
  const PowerForm& weight = piece.weight;
  PowerForm square;
  for (std::size_t c = 0; c < target.size(); ++c) {
    const PowerForm difference = sum(piece.coordinates[c], scaled(weight, -target[c]));
    square = sum(square, product(difference, difference));
  }
  const PowerForm slope =
      sum(product(derivative(square), weight), scaled(product(square, derivative(weight)), -2));
  std::vector<Candidate> result;
  for (const RationalInterval& t : unit_roots(slope, kRootBits)) {
    if (t.lower == t.upper && t.lower.get_den() == 1) continue;  // an end
    Candidate candidate{piece.parameters(t), {}, range_on(square, product(weight, weight), t)};
    for (const PowerForm& form : piece.coordinates) candidate.point.push_back(range_on(form, weight, t));
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

std::vector<ClosestPoint> closest_on(const std::vector<ExactPiece>& pieces, std::span<const double> point,
                                     double tolerance) {
  check(pieces.front().dimension(), point, tolerance);
  std::vector<Rational> target;
  for (const double x : point) target.push_back(rational_from_double(x));
  std::vector<Candidate> candidates;
  for (const ExactPiece& piece : pieces) {
    candidates.push_back(end_candidate(piece.start, piece.first(), target));
    candidates.push_back(end_candidate(piece.end, piece.last(), target));
  }
  double least = std::numeric_limits<double>::infinity();
  for (const Candidate& candidate : candidates) least = std::min(least, root(candidate.square).upper);
  const auto limit = [&] {
    const UpwardRounding upward;
    return rounded_add(least, tolerance);
  };
  for (const ExactPiece& piece : pieces) {
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

}  // namespace

std::vector<ClosestPoint> closest_points(const BSplineCurve<double>& curve, std::span<const double> point,
                                         double tolerance) {
  return closest_on(exact_pieces(converted<Rational>(curve)), point, tolerance);
}

std::vector<ClosestPoint> closest_points(const RationalCurve<double>& curve, std::span<const double> point,
                                         double tolerance) {
  return closest_on(exact_pieces(converted<Rational>(curve)), point, tolerance);
}

}  // namespace gcslab
