#include "construction/plan_solver.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

#include "base/error.h"
#include "certification/root_certifier.h"
#include "polynomial/recognise.h"

namespace gcslab {
namespace {

using Numbers = std::vector<MpfrInterval>;
using Traits = NumberTraits<MpfrInterval>;

MpfrInterval dot(const Numbers& a, const Numbers& b) {
  MpfrInterval sum = MpfrInterval(Interval(0));
  for (std::size_t i = 0; i < a.size(); ++i) sum = sum + a[i] * b[i];
  return sum;
}

Numbers difference(const Numbers& a, const Numbers& b) {
  Numbers result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - b[i]);
  return result;
}

/// The part of `a` orthogonal to the axes, which are orthonormal, with length 1; nothing where it may be 0.
std::optional<Numbers> next_axis(Numbers a, const std::vector<Numbers>& axes) {
  for (const Numbers& axis : axes) {
    const MpfrInterval along = dot(a, axis);
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] - along * axis[i];
  }
  MpfrInterval square = MpfrInterval(Interval(0));
  for (const MpfrInterval& x : a) square = square + sqr(x);
  const MpfrInterval length = sqrt(square);
  if (length.is_empty() || mpfr_sgn(length.lower()) <= 0) return std::nullopt;
  for (MpfrInterval& x : a) x = x / length;
  return a;
}

/// The points moved, without a reflection, to where the first of the frame is the origin, the second on the
/// positive x axis, the third in the half plane y > 0 of the xy plane; nothing where they may be on a line
/// (at one place).
std::optional<EnclosedPoints> in_frame(const Frame& frame, const EnclosedPoints& points) {
  const Numbers& origin = points[frame[0]];
  std::vector<Numbers> axes;
  for (std::size_t k = 1; k < frame.size(); ++k) {
    std::optional<Numbers> axis = next_axis(difference(points[frame[k]], origin), axes);
    if (!axis) return std::nullopt;
    axes.push_back(std::move(*axis));
  }
  if (axes.size() == 1) {
    axes.push_back({-axes[0][1], axes[0][0]});
  } else {
    const Numbers &x = axes[0], &y = axes[1];
    axes.push_back({x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]});
  }
  EnclosedPoints result;
  for (const Numbers& point : points) {
    const Numbers side = difference(point, origin);
    Numbers& moved = result.emplace_back();
    for (const Numbers& axis : axes) moved.push_back(dot(side, axis));
  }
  return result;
}

/// The rotations that keep the x axis, and in space the xy plane: the signs of the coordinates.
std::vector<std::vector<bool>> half_turns(std::size_t dimension) {
  if (dimension == 2) return {{false, false}, {true, true}};
  return {{false, false, false}, {false, true, true}, {true, false, true}, {true, true, false}};
}

class Solver {
 public:
  Solver(const ConstraintSystem& system, const Frame& frame, const GeometricEquations& equations,
         const Valuation& valuation, const SystemFunctions& functions, const PlanSolverOptions& options,
         const std::stop_token& stop)
      : system_(&system),
        frame_(frame),
        equations_(&equations),
        valuation_(&valuation),
        functions_(&functions),
        options_(&options),
        stop_(stop),
        program_(system, plan_for(system, frame)) {
    result_.plan = program_.plan();
    is_own_frame_ = program_.plan().frame(system.universe) == frame;
    if (is_own_frame_) make_blocks();
  }

  PlanSolutions run() {
    for (int bits = options_->bits;; bits = std::min(2 * bits, options_->maximum_bits)) {
      const Traits::Scope scope(bits);
      result_.bits = bits;
      const bool is_decided = enclose();
      if (is_decided || !result_.is_finished || bits >= options_->maximum_bits) break;
    }
    for (const Found& found : found_) {
      if (stop_.stop_requested()) {
        result_.is_finished = false;
        break;
      }
      settle(found);
    }
    return std::move(result_);
  }

 private:
  /// A box of the unknowns, and what is doubtful about it.
  struct Found {
    Box box;
    std::string doubt;
  };

  static Plan plan_for(const ConstraintSystem& system, const Frame& frame) {
    std::optional<Plan> plan = plan_without_guides(system, frame);
    if (plan) return std::move(*plan);
    throw NotApplicable(
        "no construction plan places every point where loci of the constraints meet; plan_path takes plans "
        "that need guide parameters");
  }

  void make_blocks() {
    std::vector<LociBlock> blocks;
    for (const PlanStep& step : program_.plan().steps) {
      LociBlock block;
      for (const Expression& x : equations_->objects[step.point]) {
        if (x.operation() == Operation::variable)
          block.unknowns.push_back(static_cast<std::size_t>(x.variable()));
      }
      for (std::size_t k = 0; k < equations_->equations.size(); ++k) {
        const auto is_of = [&](const LocusSource& locus) {
          return locus.constraint && locus.constraint == equations_->constraint_of_equation[k];
        };
        if (std::ranges::none_of(step.loci, is_of)) continue;
        const auto variables = static_cast<int>(equations_->unknowns.size() + equations_->parameters.size());
        if (!recognise_polynomial(equations_->equations[k], variables).polynomial) return;
        block.equations.push_back(k);
      }
      if (block.unknowns.size() != block.equations.size()) return;
      if (!block.unknowns.empty()) blocks.push_back(std::move(block));
    }
    if (equations_->auxiliaries == 0) result_.blocks = std::move(blocks);
  }

  /// Whether no figure is in doubt.
  bool enclose() {
    found_.clear();
    bool is_decided = true;
    const auto& is_absorbed = framed_coordinates(*system_, frame_).is_absorbed;
    const bool absorbs_elsewhere =
        !is_own_frame_ && std::ranges::find(is_absorbed, true) != is_absorbed.end();
    PlanEnclosure enclosure(program_, valuation_->values, absorbs_elsewhere);
    result_.branches = 0;
    result_.is_finished = enclosure.each_figure(
        [&](EnclosedFigure&& figure) {
          if (result_.branches == options_->maximum_branches) return false;
          ++result_.branches;
          is_decided = is_decided && figure.doubt == PlanDoubt::none;
          place(figure);
          return true;
        },
        stop_);
    result_.empty_branches = enclosure.empty_branches();
    return is_decided;
  }

  void place(const EnclosedFigure& figure) {
    const Box& search_box = functions_->system().box;
    const std::string doubt = doubt_text(figure);
    std::optional<EnclosedPoints> placed;
    if (!figure.points.empty()) placed = is_own_frame_ ? figure.points : in_frame(frame_, figure.points);
    if (!placed) {
      found_.push_back({search_box, doubt.empty() ? "the points of the frame may be on one line" : doubt});
      return;
    }
    const EnclosedPoints& points = *placed;
    for (const std::vector<bool>& turn : half_turns(program_.dimension())) {
      Box box = search_box;
      bool is_empty_box = false;
      for (std::size_t p = 0; p < points.size(); ++p) {
        for (std::size_t i = 0; i < points[p].size(); ++i) {
          const Expression& coordinate = equations_->objects[p][i];
          if (coordinate.operation() != Operation::variable) continue;
          const Interval side = (turn[i] ? -points[p][i] : points[p][i]).interval();
          Interval& unknown = box[static_cast<std::size_t>(coordinate.variable())];
          // An empty enclosure is one of nothing that could be computed.
          if (!is_empty(side)) unknown = intersection(unknown, side);
          is_empty_box = is_empty_box || is_empty(unknown);
        }
      }
      if (is_empty_box || !fit_auxiliaries(box) || violates(box)) continue;
      found_.push_back({std::move(box), doubt});
    }
  }

  std::string doubt_text(const EnclosedFigure& figure) const {
    if (figure.doubt == PlanDoubt::none) return "";
    const std::string& name = system_->objects[program_.steps()[figure.step].point].name;
    if (figure.doubt == PlanDoubt::touching)
      return fmt::format("the loci of {} touch, or nearly, with {} bits", name, result_.bits);
    if (figure.doubt == PlanDoubt::many)
      return fmt::format("the loci of {} may meet in infinitely many points", name);
    return fmt::format(
        "{} may be at one place or on one line with the points before it, which then hold no figure", name);
  }

  /// Narrows the sides of auxiliary unknowns by equations A + B s = 0; false where one has no solution.
  bool fit_auxiliaries(Box& box) const {
    if (equations_->auxiliaries == 0) return true;
    SystemEvaluator<MpfrInterval> evaluator(*functions_);
    const std::vector<MpfrInterval> zero = values_with(evaluator, box, 0),
                                    one = values_with(evaluator, box, 1);
    const std::size_t first = box.size() - equations_->auxiliaries;
    for (std::size_t k = 0; k < zero.size(); ++k) {
      for (const std::size_t variable : functions_->equations()[k].variables) {
        if (variable < first) continue;
        const Interval side = (-zero[k] / (one[k] - zero[k])).interval();
        if (!is_empty(side)) box[variable] = intersection(box[variable], side);
        if (is_empty(box[variable])) return false;
      }
    }
    return true;
  }

  std::vector<MpfrInterval> values_with(SystemEvaluator<MpfrInterval>& evaluator, const Box& box,
                                        double auxiliaries) const {
    std::vector<MpfrInterval> x, values(functions_->equations().size());
    for (std::size_t i = 0; i < box.size(); ++i)
      x.emplace_back(i + equations_->auxiliaries < box.size() ? box[i] : Interval(auxiliaries));
    evaluator.values(x, values);
    return values;
  }

  /// Whether an equation is proved to vanish nowhere in the box.
  bool violates(const Box& box) const {
    SystemEvaluator<MpfrInterval> evaluator(*functions_);
    std::vector<MpfrInterval> x, values(functions_->equations().size());
    for (const Interval& side : box) x.emplace_back(side);
    evaluator.values(x, values);
    return std::ranges::any_of(values, [](const MpfrInterval& value) {
      return value.is_empty() || mpfr_sgn(value.lower()) > 0 || mpfr_sgn(value.upper()) < 0;
    });
  }

  void settle(const Found& found) {
    const auto covers = [&](const CertifiedRoot& root) {
      return std::ranges::equal(found.box, root.uniqueness_box,
                                [](const Interval& a, const Interval& b) { return subset(a, b); });
    };
    if (std::ranges::any_of(result_.roots, covers)) return;
    if (!std::ranges::all_of(found.box, is_bounded) || !functions_->is_square()) {
      add_undecided(found, functions_->is_square()
                               ? found.doubt
                               : "that a solution exists is not proved, since there are more equations than "
                                 "unknowns; all of them hold here, to rounding");
      return;
    }
    for (const int bits : {53, result_.bits}) {
      const std::optional<CertifiedRoot> root = certifier(bits).certify_box(found.box);
      if (!root || !covers(*root)) continue;
      if (meets_search_box(*root) && !is_listed(*root)) result_.roots.push_back(*root);
      return;
    }
    add_undecided(found, found.doubt.empty() ? "no theorem certifies the root of the branch" : found.doubt);
  }

  RootCertifier& certifier(int bits) {
    std::unique_ptr<RootCertifier>& made = certifiers_[bits];
    if (!made)
      made = make_root_certifier(options_->certifier, *functions_, std::vector(functions_->variables(), 1.0),
                                 bits);
    return *made;
  }

  bool is_listed(const CertifiedRoot& root) const {
    return std::ranges::any_of(result_.roots, [&](const CertifiedRoot& other) {
      return std::ranges::equal(root.box, other.uniqueness_box,
                                [](const Interval& a, const Interval& b) { return subset(a, b); });
    });
  }

  bool meets_search_box(const CertifiedRoot& root) const {
    return std::ranges::equal(root.box, functions_->system().box,
                              [](const Interval& a, const Interval& b) { return !disjoint(a, b); });
  }

  /// A little larger than what is known, so that less precision shows the same.
  void add_undecided(const Found& found, std::string reason) {
    constexpr double kSlack = 1e-12;
    Box box = found.box;
    for (std::size_t i = 0; i < box.size(); ++i) {
      const double slack = kSlack * std::max(1.0, magnitude(box[i]));
      if (is_bounded(box[i]))
        box[i] =
            intersection(Interval(box[i].lower - slack, box[i].upper + slack), functions_->system().box[i]);
    }
    result_.undecided.push_back({std::move(box), std::move(reason)});
  }

  const ConstraintSystem* system_;
  Frame frame_;
  const GeometricEquations* equations_;
  const Valuation* valuation_;
  const SystemFunctions* functions_;
  const PlanSolverOptions* options_;
  std::stop_token stop_;
  PlanProgram program_;
  bool is_own_frame_ = false;
  std::vector<Found> found_;
  std::map<int, std::unique_ptr<RootCertifier>> certifiers_;
  PlanSolutions result_;
};

}  // namespace

PlanSolutions solve_by_plan(const ConstraintSystem& system, const Frame& frame,
                            const GeometricEquations& equations, const Valuation& valuation,
                            const SystemFunctions& functions, const PlanSolverOptions& options,
                            const std::stop_token& stop) {
  return Solver(system, frame, equations, valuation, functions, options, stop).run();
}

}  // namespace gcslab
