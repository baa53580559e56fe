#pragma once

// Random systems of equations and inequalities with known exact solutions, and boxes around them.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "expression/equation_system.h"
#include "expression/parser.h"
#include "expression/printer.h"
#include "expression/substitute.h"
#include "expression/tape_evaluator.h"
#include "interval/elementary.h"
#include "interval/mpfr_interval.h"
#include "interval/point_numbers.h"

namespace gcslab::planted {

using Point = std::vector<Rational>;

/// The system that texts spell.
inline EquationSystem system_of(const std::vector<std::string>& variables,
                                const std::vector<std::string>& equations,
                                const std::vector<std::string>& inequalities = {}, const Box& box = {}) {
  EquationSystem system;
  system.variables = variables;
  for (const std::string& text : equations)
    system.equations.push_back(parse_equation(*system.graph, text, variables));
  for (const std::string& text : inequalities)
    system.inequalities.push_back(parse_inequality(*system.graph, text, variables));
  system.box = box;
  return system;
}

inline std::string to_text(const EquationSystem& system) {
  std::string text;
  for (const Expression& e : system.equations) text += gcslab::to_text(e, system.variables) + " = 0; ";
  for (const Expression& e : system.inequalities) text += gcslab::to_text(e, system.variables) + " <= 0; ";
  return text;
}

inline std::string to_text(const Box& box) {
  std::string text;
  for (const Interval& side : box) text += to_string(side) + " ";
  return text;
}

inline bool contains(const Interval& x, const Rational& member) {
  const bool above = std::isinf(x.lower) ? x.lower < 0 : rational_from_double(x.lower) <= member;
  const bool below = std::isinf(x.upper) ? x.upper > 0 : member <= rational_from_double(x.upper);
  return above && below;
}

inline bool contains(const Box& box, const Point& point) {
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (!contains(box[i], point[i])) return false;
  }
  return true;
}

/// The value at a point of an expression that is a polynomial as it is written.
inline Rational exact_value(Expression expression, const Point& point) {
  const Tape tape(expression, static_cast<int>(point.size()));
  TapeEvaluator<Rational> evaluator(tape);
  evaluator.evaluate(point);
  return evaluator.value();
}

/// A system and points that solve it exactly.
struct PlantedSystem {
  EquationSystem system;
  std::vector<Point> roots;
  bool is_polynomial = true;
};

/// What to draw.
struct PlantedKind {
  int variables = 2;
  int equations = 2;
  int roots = 1;
  bool transcendental = false;
  bool inequality = false;
};

class PlantedGenerator {
 public:
  explicit PlantedGenerator(Random& random) : random_(random) {}

  PlantedKind random_kind() {
    PlantedKind kind;
    kind.variables = static_cast<int>(random_.integer(1, 3));
    kind.equations = kind.variables;
    if (random_.below(4) == 0)
      kind.equations = std::max<int>(1, kind.variables + static_cast<int>(random_.integer(-1, 2)));
    kind.roots = random_.below(3) == 0 ? 2 : 1;
    kind.transcendental = random_.below(2) == 0;
    kind.inequality = random_.below(5) == 0;
    return kind;
  }

  PlantedSystem system(const PlantedKind& kind) {
    PlantedSystem result;
    result.is_polynomial = !kind.transcendental;
    ExpressionGraph& graph = *result.system.graph;
    const std::vector<std::string> names = {"x", "y", "z", "u", "v", "w"};
    result.system.variables.assign(names.begin(), names.begin() + kind.variables);
    result.roots = points(kind);
    for (int k = 0; k < kind.equations; ++k)
      result.system.equations.push_back(vanishing(graph, result.roots, kind.transcendental));
    if (kind.inequality) result.system.inequalities.push_back(satisfied(graph, result.roots));
    result.system.box.assign(static_cast<std::size_t>(kind.variables), Interval(-100, 100));
    return result;
  }

  /// A box around the point, which now and then lies on its border, in its corner, or a little outside.
  Box box_around(const Point& point) {
    const int common = static_cast<int>(random_.integer(0, 45));
    const bool is_cube = random_.below(2) == 0;
    Box box;
    for (const Rational& coordinate : point) {
      const Interval tight = elementary::enclosing(coordinate);
      const int exponent = is_cube ? common : static_cast<int>(random_.integer(-3, 48));
      const double size = std::ldexp(1, -exponent);
      double lower = tight.lower - extent(size), upper = tight.upper + extent(size);
      if (random_.below(60) == 0) lower = -std::numeric_limits<double>::infinity();
      if (random_.below(60) == 0) upper = std::numeric_limits<double>::infinity();
      if (random_.below(60) == 0) lower = std::min(upper, tight.upper + size * 0x1p-10);
      box.emplace_back(lower, upper);
    }
    return box;
  }

 private:
  double extent(double size) { return random_.below(6) == 0 ? 0 : size * random_.unit(); }

  Rational coordinate() {
    switch (random_.below(5)) {
      case 0:
        return random_.integer(-3, 3);
      case 1:
        return fraction(20, static_cast<int>(random_.integer(1, 12)));
      case 2:
        return fraction(40, 10);
      case 3:
        return rational_from_double(
            std::ldexp(random_.uniform(-1, 1), static_cast<int>(random_.integer(-8, 3))));
      default:
        return fraction(64, 16);
    }
  }

  Rational fraction(std::int64_t bound, int denominator) {
    Rational result(random_.integer(-bound, bound), denominator);
    result.canonicalize();
    return result;
  }

  /// Far apart, or a cluster.
  std::vector<Point> points(const PlantedKind& kind) {
    std::vector<Point> result;
    for (int r = 0; r < kind.roots; ++r) {
      Point point;
      for (int i = 0; i < kind.variables; ++i) point.push_back(coordinate());
      if (r > 0 && random_.below(2) == 0) {
        point = result.front();
        const double distance = std::ldexp(1, -static_cast<int>(random_.integer(1, 40)));
        for (Rational& x : point) x += Rational(random_.integer(-1, 1)) * rational_from_double(distance);
      }
      result.push_back(std::move(point));
    }
    return result;
  }

  /// A product of functions, each shifted so that it vanishes at one of the points; singular now and then.
  Expression vanishing(ExpressionGraph& graph, const std::vector<Point>& roots, bool transcendental) {
    Expression product = graph.constant(1);
    for (std::size_t r = 0; r < roots.size(); ++r) {
      const Expression factor = shifted(graph, roots, r, transcendental);
      product = product * (random_.below(10) == 0 ? sqr(factor) : factor);
    }
    return product;
  }

  /// h(x) - h(root number r), where h is defined at all roots.
  Expression shifted(ExpressionGraph& graph, const std::vector<Point>& roots, std::size_t r,
                     bool transcendental) {
    for (;;) {
      try {
        const Expression h = function(graph, static_cast<int>(roots[r].size()), 2, transcendental);
        const auto at = [&](const Point& point) { return value_at(graph, h, point); };
        const bool is_good =
            std::ranges::all_of(roots, [&](const Point& root) { return is_defined(at(root)); });
        if (!h.is_constant() && is_good) return h - at(roots[r]);
      } catch (const InputError&) {  // a division by the constant 0 on the way
      }
    }
  }

  static Expression value_at(ExpressionGraph& graph, Expression h, const Point& point) {
    std::vector<Expression> constants;
    for (const Rational& x : point) constants.push_back(graph.constant(x));
    return substitute(h, graph, constants);
  }

  static bool is_defined(Expression constant) {
    const NumberTraits<MpfrInterval>::Scope scope(200);
    const Tape tape(constant, 0);
    TapeEvaluator<MpfrInterval> evaluator(tape);
    evaluator.evaluate({});
    return is_bounded(evaluator.value().interval());
  }

  /// g(x) - (the largest g at the roots) or a little less, so that every root satisfies <= 0.
  Expression satisfied(ExpressionGraph& graph, const std::vector<Point>& roots) {
    const Expression g = function(graph, static_cast<int>(roots.front().size()), 2, false);
    Rational largest = exact_value(g, roots.front());
    for (const Point& root : roots) largest = std::max(largest, exact_value(g, root));
    return g - graph.constant(random_.below(2) == 0 ? largest : Rational(largest + Rational(1, 3)));
  }

  Expression leaf(ExpressionGraph& graph, int variables) {
    if (random_.below(4) == 0) return graph.constant(fraction(30, static_cast<int>(random_.integer(1, 9))));
    return graph.variable(static_cast<int>(random_.below(static_cast<std::uint64_t>(variables))));
  }

  Expression function(ExpressionGraph& graph, int variables, int depth, bool transcendental) {
    if (depth == 0) return leaf(graph, variables);
    const Expression a = function(graph, variables, depth - 1, transcendental);
    if (transcendental && random_.below(2) == 0) return special(graph, a, variables, depth);
    const auto b = [&] { return function(graph, variables, depth - 1, transcendental); };
    switch (random_.below(7)) {
      case 0:
      case 1:
        return a + b();
      case 2:
        return a - b();
      case 3:
      case 4:
        return a * b();
      case 5:
        return pow(a, static_cast<int>(random_.integer(2, 3)));
      default:
        return a + leaf(graph, variables);
    }
  }

  Expression special(ExpressionGraph& graph, Expression a, int variables, int depth) {
    static constexpr Operation kUnary[] = {Operation::sqrt, Operation::cbrt, Operation::exp,  Operation::log,
                                           Operation::sin,  Operation::cos,  Operation::tan,  Operation::asin,
                                           Operation::acos, Operation::atan, Operation::abs,  Operation::sin,
                                           Operation::exp,  Operation::sqrt, Operation::atan, Operation::cos};
    const auto b = [&] { return function(graph, variables, depth - 1, true); };
    switch (random_.below(8)) {
      case 0:
        return a / b();
      case 1:
        return graph.apply(Operation::min, a, b());
      case 2:
        return graph.apply(Operation::max, a, b());
      case 3:
        return graph.power(a, fraction(3, static_cast<int>(random_.integer(1, 3))));
      default:
        return graph.apply(kUnary[random_.below(std::size(kUnary))], a);
    }
  }

  Random& random_;
};

}  // namespace gcslab::planted
