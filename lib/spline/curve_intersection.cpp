#include "spline/curve_intersection.h"

#include <array>

#include "box_solver/solver_method.h"
#include "certification/root_refinement.h"
#include "spline/power_form.h"

namespace gcslab {
namespace {

constexpr int kRootBits = 160;
constexpr int kFineBits = 60;      // of listed parameters
constexpr int kLargestBits = 960;  // where a root that is near the end of a piece is told from it

/// A polynomial piece, exactly.
struct Piece {
  BezierPiece<Rational> bezier;
  std::vector<PowerForm> forms;
  RationalBox box;  ///< of its control points

  Rational global(const Rational& t) const { return bezier.start + (bezier.end - bezier.start) * t; }
  RationalInterval global(const RationalInterval& t) const { return {global(t.lower), global(t.upper)}; }
};

RationalBox box_of(const Matrix<Rational>& points) {
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

std::vector<Piece> pieces_of(const BSplineCurve<double>& curve) {
  if (curve.dimension() != 2)
    throw InputError("intersection: a curve has " + std::to_string(curve.dimension()) +
                     " coordinates, expected 2");
  std::vector<Piece> pieces;
  for (BezierPiece<Rational>& bezier : bezier_pieces(converted<Rational>(curve))) {
    std::vector<PowerForm> forms = power_forms(bezier);
    RationalBox box = box_of(bezier.points);
    pieces.push_back({std::move(bezier), std::move(forms), std::move(box)});
  }
  return pieces;
}

bool are_disjoint(const RationalBox& a, const RationalBox& b) {
  for (std::size_t c = 0; c < a.size(); ++c) {
    if (a[c].upper < b[c].lower || b[c].upper < a[c].lower) return true;
  }
  return false;
}

/// An intersection at the end of a piece of at least one of the curves.
struct EndPoint {
  std::array<RationalInterval, 2> parameters;  ///< of the two curves; one of them is a number
  RationalBox point;

  bool operator==(const EndPoint& other) const {
    const auto same = [](const RationalInterval& x, const RationalInterval& y) {
      return x.lower == y.lower && x.upper == y.upper;
    };
    return std::ranges::equal(parameters, other.parameters, same) &&
           std::ranges::equal(point, other.point, same);
  }
};

/// Where a point lies on a piece: the common roots of the coordinates of b(t) - P, which are the real roots
/// of their sum of squares.
std::vector<RationalInterval> parameters_at(const Piece& piece, std::span<const Rational> point) {
  PowerForm squares;
  for (std::size_t c = 0; c < point.size(); ++c) {
    const PowerForm difference = sum(piece.forms[c], {Rational(-point[c])});
    squares = sum(squares, product(difference, difference));
  }
  return unit_roots(squares, kRootBits);
}

bool is_inside_unit(const MpfrInterval& x) {
  return mpfr_sgn(x.lower()) > 0 && mpfr_cmp_ui(x.upper(), 1) < 0;
}

bool is_outside_unit(const MpfrInterval& x) {
  return mpfr_sgn(x.upper()) < 0 || mpfr_cmp_ui(x.lower(), 1) > 0;
}

class Intersector {
 public:
  Intersector(const BSplineCurve<double>& first, const BSplineCurve<double>& second,
              const IntersectionOptions& options)
      : curves_{&first, &second},
        pieces_{pieces_of(first), pieces_of(second)},
        options_(options),
        method_(solver_method_registry().at("adaptive")),
        method_options_(method_.options(), {}, method_.name) {}

  CurveIntersections run() {
    find_end_points(0);
    find_end_points(1);
    for (const EndPoint& end : end_points_)
      result_.points.push_back({rounded(end.parameters[0]),
                                rounded(end.parameters[1]),
                                {rounded(end.point[0]), rounded(end.point[1])}});
    for (const Piece& a : pieces_[0]) {
      for (const Piece& b : pieces_[1]) {
        if (!are_disjoint(a.box, b.box)) solve(a, b);
      }
    }
    std::ranges::sort(result_.points, {},
                      [](const CurveIntersection& p) { return std::pair(p.first.lower, p.second.lower); });
    return std::move(result_);
  }

 private:
  /// Ends of pieces of one curve that lie on the other one.
  void find_end_points(std::size_t curve) {
    for (const Piece& piece : pieces_[curve]) {
      for (const bool at_end : {false, true}) {
        const auto row = piece.bezier.points.row(at_end ? piece.bezier.points.rows() - 1 : 0);
        const RationalBox point = {{row[0], row[0]}, {row[1], row[1]}};
        const Rational& u = at_end ? piece.bezier.end : piece.bezier.start;
        for (const Piece& other : pieces_[1 - curve]) {
          if (are_disjoint(point, other.box)) continue;
          for (const RationalInterval& t : parameters_at(other, row)) {
            EndPoint found{{RationalInterval{u, u}, other.global(t)}, point};
            if (curve == 1) std::swap(found.parameters[0], found.parameters[1]);
            if (std::ranges::find(end_points_, found) == end_points_.end())
              end_points_.push_back(std::move(found));
          }
        }
      }
    }
  }

  static Expression expression(ExpressionGraph& graph, const PowerForm& form, int variable) {
    Expression result = graph.constant(form[0]);
    for (std::size_t k = 1; k < form.size(); ++k)
      result = result + graph.constant(form[k]) * pow(graph.variable(variable), static_cast<int>(k));
    return result;
  }

  static EquationSystem system(const Piece& a, const Piece& b) {
    EquationSystem system;
    system.variables = {"s", "t"};
    system.box = {{0, 1}, {0, 1}};
    for (std::size_t c = 0; c < 2; ++c)
      system.equations.push_back(expression(*system.graph, a.forms[c], 0) -
                                 expression(*system.graph, b.forms[c], 1));
    return system;
  }

  void solve(const Piece& a, const Piece& b) {
    const SystemFunctions functions(system(a, b));
    SearchOptions settings = search_options(method_options_);
    settings.maximum_boxes = options_.maximum_boxes;
    settings.cluster_boxes = options_.cluster_boxes;
    const Box& box = functions.system().box;
    const SearchResult found = search(functions, box, {{box}}, contractor_maker(method_options_), settings);
    for (const Solution& solution : found.solutions) {
      if (solution.claim == Claim::unique) settle(functions, solution.root, a, b);
    }
    for (const UndecidedBox& undecided : found.undecided) leave(undecided.box, a, b, undecided.reason);
    for (const Box& pending : found.pending) leave(pending, a, b, "the budget of boxes ended");
  }

  /// A certified root of a pair: one at an end of a piece, one inside of both, or one beyond their ends.
  void settle(const SystemFunctions& functions, const CertifiedRoot& root, const Piece& a, const Piece& b) {
    if (is_end_point(root, a, b)) return;
    for (int bits = kFineBits; bits <= kLargestBits; bits *= 2) {
      const std::vector<MpfrInterval> box = refine_root(functions, root, bits).box;
      if (std::ranges::any_of(box, is_outside_unit)) return;
      if (!std::ranges::all_of(box, is_inside_unit)) continue;
      list({box[0].interval(), box[1].interval()}, a, b);
      return;
    }
    leave(root.box, a, b, "a root too near to the end of a piece to be told from it");
  }

  /// Whether the end point is one of these two pieces in their box of local parameters.
  static bool is_root_at(const EndPoint& end, const Piece& a, const Piece& b, const Box& local) {
    const std::array<const Piece*, 2> pieces = {&a, &b};
    for (std::size_t i = 0; i < 2; ++i) {
      const BezierPiece<Rational>& bezier = pieces[i]->bezier;
      const RationalInterval& u = end.parameters[i];
      const RationalInterval where = pieces[i]->global(exactly(local[i]));
      if (u.lower < std::max(bezier.start, where.lower) || std::min(bezier.end, where.upper) < u.upper)
        return false;
      if (u.lower == bezier.start && !is_at(bezier.points.row(0), end.point)) return false;
      if (u.upper == bezier.end && !is_at(bezier.points.row(bezier.points.rows() - 1), end.point))
        return false;
    }
    return true;
  }

  static bool is_at(std::span<const Rational> row, const RationalBox& point) {
    return row[0] == point[0].lower && row[1] == point[1].lower;
  }

  bool is_end_point(const CertifiedRoot& root, const Piece& a, const Piece& b) const {
    return std::ranges::any_of(
        end_points_, [&](const EndPoint& end) { return is_root_at(end, a, b, root.uniqueness_box); });
  }

  static RationalInterval exactly(const Interval& x) {
    return {rational_from_double(x.lower), rational_from_double(x.upper)};
  }

  /// The parameters of the curve on the piece, rounded outward.
  static Interval global(const Interval& local, const Piece& piece) {
    return rounded(piece.global(exactly(intersection(local, Interval(0, 1)))));
  }

  void list(const Box& local, const Piece& a, const Piece& b) {
    const NumberTraits<FastInterval>::Scope scope;
    CurveIntersection found{global(local[0], a), global(local[1], b), {}};
    const auto on_first = evaluate(converted<FastInterval>(*curves_[0]), FastInterval(found.first));
    const auto on_second = evaluate(converted<FastInterval>(*curves_[1]), FastInterval(found.second));
    for (std::size_t c = 0; c < 2; ++c)
      found.point.push_back(intersection(on_first[c].interval(), on_second[c].interval()));
    result_.points.push_back(std::move(found));
  }

  void leave(const Box& local, const Piece& a, const Piece& b, const std::string& reason) {
    result_.undecided.push_back({global(local[0], a), global(local[1], b), reason});
  }

  std::array<const BSplineCurve<double>*, 2> curves_;
  std::array<std::vector<Piece>, 2> pieces_;
  IntersectionOptions options_;
  const SolverMethod& method_;
  Options method_options_;
  std::vector<EndPoint> end_points_;
  CurveIntersections result_;
};

}  // namespace

CurveIntersections intersections(const BSplineCurve<double>& first, const BSplineCurve<double>& second,
                                 const IntersectionOptions& options) {
  return Intersector(first, second, options).run();
}

}  // namespace gcslab
