#include "spline/curve_intersection.h"

#include <array>
#include <functional>

#include "box_solver/solver_method.h"
#include "certification/root_refinement.h"
#include "spline/power_form.h"

namespace gcslab {
namespace {

constexpr int kRootBits = 160;
constexpr std::uint64_t kFirstBoxes = 300;
constexpr int kFineBits = 60;      // of listed parameters
constexpr int kLargestBits = 960;  // where a root that is near the end of a piece is told from it

/// A piece with the box of its control points.
struct Piece : ExactPiece {
  RationalBox control_box;
};

/// A curve as the intersection needs it.
struct PlaneCurve {
  std::vector<Piece> pieces;
  std::function<Box(const Interval&)> points_at;  ///< encloses the points with parameters in the interval
};

template <class Curve>
PlaneCurve plane_curve(const Curve& curve) {
  if (curve.dimension() != 2)
    throw InputError("intersection: a curve has " + std::to_string(curve.dimension()) +
                     " coordinates, expected 2");
  PlaneCurve result;
  for (ExactPiece& piece : exact_pieces(converted<Rational>(curve))) {
    RationalBox box = piece.box();
    result.pieces.push_back({std::move(piece), std::move(box)});
  }
  const NumberTraits<FastInterval>::Scope scope;
  result.points_at = [enclosed = converted<FastInterval>(curve)](const Interval& parameters) {
    const NumberTraits<FastInterval>::Scope upward;
    Box box;
    for (const FastInterval& x : evaluate(enclosed, FastInterval(parameters))) box.push_back(x.interval());
    return box;
  };
  return result;
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

/// What vanishes where a piece b / z is at a point P: the sum of the squares of the coordinates of b(t) -
/// z(t) P, whose real roots are the common ones of these.
PowerForm squared_distance(const Piece& piece, std::span<const Rational> point) {
  PowerForm squares;
  for (std::size_t c = 0; c < point.size(); ++c) {
    const PowerForm difference = sum(piece.coordinates[c], scaled(piece.weight, -point[c]));
    squares = sum(squares, product(difference, difference));
  }
  return squares;
}

/// Whether two pieces are parts of one algebraic curve: curves of degrees d and e that are not have no more
/// than d e common points (Bezout 1779).
bool lie_on_one_curve(const Piece& a, const Piece& b) {
  const std::size_t bound = (a.points.rows() - 1) * (b.points.rows() - 1);
  for (std::size_t i = 0; i <= bound; ++i) {
    Rational t(static_cast<unsigned long>(i + 1), static_cast<unsigned long>(bound + 2));
    t.canonicalize();
    std::vector<Rational> point;
    for (const PowerForm& form : a.coordinates) point.emplace_back(value(form, t) / value(a.weight, t));
    if (!has_real_root(squared_distance(b, point))) return false;
  }
  return true;
}

bool is_inside_unit(const MpfrInterval& x) {
  return mpfr_sgn(x.lower()) > 0 && mpfr_cmp_ui(x.upper(), 1) < 0;
}

bool is_outside_unit(const MpfrInterval& x) {
  return mpfr_sgn(x.upper()) < 0 || mpfr_cmp_ui(x.lower(), 1) > 0;
}

class Intersector {
 public:
  Intersector(PlaneCurve first, PlaneCurve second, const IntersectionOptions& options)
      : curves_{std::move(first), std::move(second)},
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
    for (const Piece& a : curves_[0].pieces) {
      for (const Piece& b : curves_[1].pieces) {
        if (!are_disjoint(a.control_box, b.control_box)) solve(a, b);
      }
    }
    std::ranges::sort(result_.points, {},
                      [](const CurveIntersection& p) { return std::pair(p.first.lower, p.second.lower); });
    return std::move(result_);
  }

 private:
  /// Ends of pieces of one curve that lie on the other one.
  void find_end_points(std::size_t curve) {
    for (const Piece& piece : curves_[curve].pieces) {
      for (const bool at_end : {false, true}) {
        const auto row = at_end ? piece.last() : piece.first();
        const RationalBox point = {{row[0], row[0]}, {row[1], row[1]}};
        const Rational& u = at_end ? piece.end : piece.start;
        for (const Piece& other : curves_[1 - curve].pieces) {
          if (are_disjoint(point, other.control_box)) continue;
          for (const RationalInterval& t : unit_roots(squared_distance(other, row), kRootBits)) {
            EndPoint found{{RationalInterval{u, u}, other.parameters(t)}, point};
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
    ExpressionGraph& graph = *system.graph;
    for (std::size_t c = 0; c < 2; ++c)
      system.equations.push_back(expression(graph, a.coordinates[c], 0) * expression(graph, b.weight, 1) -
                                 expression(graph, b.coordinates[c], 1) * expression(graph, a.weight, 0));
    return system;
  }

  /// A first search settles what is simple. Only where it leaves something it is worth asking whether the
  /// pieces have an arc in common, of which no search would ever see the end.
  void solve(const Piece& a, const Piece& b) {
    const SystemFunctions functions(system(a, b));
    SearchResult found = searched(functions, {{functions.system().box}}, kFirstBoxes);
    if (!found.pending.empty() || !found.undecided.empty()) {
      if (lie_on_one_curve(a, b)) {
        leave(what_is_left(found), a, b, "the two pieces lie on one curve: they may have an arc in common");
        found.pending.clear();
        found.undecided.clear();
      } else if (!found.pending.empty()) {
        found = searched(functions, {found.pending, found.roots, found.undecided}, options_.maximum_boxes);
      }
    }
    for (const Solution& solution : found.solutions) {
      if (solution.claim == Claim::unique) settle(functions, solution.root, a, b);
    }
    for (const UndecidedBox& undecided : found.undecided) leave(undecided.box, a, b, undecided.reason);
    for (const Box& pending : found.pending) leave(pending, a, b, "the budget of boxes ended");
  }

  SearchResult searched(const SystemFunctions& functions, const SearchStart& start,
                        std::uint64_t boxes) const {
    SearchOptions settings = search_options(method_options_);
    settings.maximum_boxes = std::min(boxes, options_.maximum_boxes);
    settings.cluster_boxes = options_.cluster_boxes;
    return search(functions, functions.system().box, start, contractor_maker(method_options_), settings);
  }

  /// The hull of all boxes that are not settled.
  static Box what_is_left(const SearchResult& found) {
    Box result(2);
    const auto add = [&](const Box& box) {
      for (std::size_t i = 0; i < result.size(); ++i) result[i] = hull(result[i], box[i]);
    };
    for (const UndecidedBox& undecided : found.undecided) add(undecided.box);
    for (const Box& pending : found.pending) add(pending);
    return result;
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
      const Piece& piece = *pieces[i];
      const RationalInterval& u = end.parameters[i];
      const RationalInterval where = piece.parameters(exactly(local[i]));
      if (u.lower < std::max(piece.start, where.lower) || std::min(piece.end, where.upper) < u.upper)
        return false;
      if (u.lower == piece.start && !is_at(piece.first(), end.point)) return false;
      if (u.upper == piece.end && !is_at(piece.last(), end.point)) return false;
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
    return rounded(piece.parameters(exactly(intersection(local, Interval(0, 1)))));
  }

  void list(const Box& local, const Piece& a, const Piece& b) {
    CurveIntersection found{global(local[0], a), global(local[1], b), {}};
    const Box on_first = curves_[0].points_at(found.first);
    const Box on_second = curves_[1].points_at(found.second);
    for (std::size_t c = 0; c < 2; ++c) found.point.push_back(intersection(on_first[c], on_second[c]));
    result_.points.push_back(std::move(found));
  }

  void leave(const Box& local, const Piece& a, const Piece& b, const std::string& reason) {
    result_.undecided.push_back({global(local[0], a), global(local[1], b), reason});
  }

  std::array<PlaneCurve, 2> curves_;
  IntersectionOptions options_;
  const SolverMethod& method_;
  Options method_options_;
  std::vector<EndPoint> end_points_;
  CurveIntersections result_;
};

}  // namespace

CurveIntersections intersections(const BSplineCurve<double>& first, const BSplineCurve<double>& second,
                                 const IntersectionOptions& options) {
  return Intersector(plane_curve(first), plane_curve(second), options).run();
}

CurveIntersections intersections(const RationalCurve<double>& first, const RationalCurve<double>& second,
                                 const IntersectionOptions& options) {
  return Intersector(plane_curve(first), plane_curve(second), options).run();
}

CurveIntersections intersections(const RationalCurve<double>& first, const BSplineCurve<double>& second,
                                 const IntersectionOptions& options) {
  return Intersector(plane_curve(first), plane_curve(second), options).run();
}

}  // namespace gcslab
