#pragma once

// Random square systems all of whose real roots are known exactly.
//
// Variable i solves a quadratic q_i(u_i) = 0, u_i = x_i - p_i(x_{i+1}, ..., x_n), with no, one double or two
// rational roots; so the roots come from back substitution. The equations are then mixed by a nonsingular
// matrix and multiplied by a function without zeros, which leaves the roots as they are.

#include <algorithm>
#include <vector>

#include "support/planted_system.h"

namespace gcslab::planted {

struct CountedSystem {
  EquationSystem system;
  std::vector<Point> roots;    ///< all of them
  std::vector<Point> centres;  ///< the roots, or where there would be some but for a small constant
};

class CountedGenerator {
 public:
  explicit CountedGenerator(Random& random) : random_(random) {}

  CountedSystem system(int variables) {
    CountedSystem result;
    const std::vector<std::string> names = {"x", "y", "z"};
    result.system.variables.assign(names.begin(), names.begin() + variables);
    result.system.box.assign(static_cast<std::size_t>(variables), Interval(-100, 100));
    result.centres = {Point(static_cast<std::size_t>(variables))};
    is_rootless_ = false;
    std::vector<Expression> equations;
    for (int i = variables; i-- > 0;) equations.push_back(quadratic(*result.system.graph, i, result.centres));
    result.system.equations = mixed(*result.system.graph, equations);
    if (!is_rootless_) result.roots = result.centres;
    return result;
  }

 private:
  Rational number(std::int64_t bound, int denominator) {
    Rational value(random_.integer(-bound, bound), denominator);
    value.canonicalize();
    return value;
  }

  /// p as above.
  Expression shift_of(ExpressionGraph& graph, int i, std::size_t variables) {
    Expression shift = graph.constant(number(8, 4));
    for (int j = i + 1; j < static_cast<int>(variables); ++j) {
      const Expression x = graph.variable(j);
      shift = shift + graph.constant(number(4, 4)) * (random_.below(2) == 0 ? x : sqr(x));
    }
    return shift;
  }

  /// q(x_i - p) as an expression; the points, known in the later variables, get their values of x_i.
  Expression quadratic(ExpressionGraph& graph, int i, std::vector<Point>& points) {
    const Expression shift = shift_of(graph, i, points.front().size());
    const Expression u = graph.variable(i) - shift;
    const std::vector<Rational> zeros = zeros_of_quadratic();
    std::vector<Point> extended;
    for (const Point& point : points) {
      for (const Rational& zero : zeros.empty() ? std::vector<Rational>(1) : zeros) {
        extended.push_back(point);
        extended.back()[static_cast<std::size_t>(i)] = zero + exact_value(shift, point);
      }
    }
    points = extended;
    if (zeros.empty()) {
      is_rootless_ = true;
      return sqr(u) +
             graph.constant(rational_from_double(std::ldexp(1, -static_cast<int>(random_.integer(3, 45)))));
    }
    const Expression first = u - graph.constant(zeros.front());
    if (zeros.size() == 2) return first * (u - graph.constant(zeros.back()));
    return random_.below(4) == 0 ? sqr(first) : first;
  }

  std::vector<Rational> zeros_of_quadratic() {
    const Rational zero = number(12, 4);
    switch (random_.below(6)) {
      case 0:
        return {};
      case 1:
        return {zero};
      case 2:
        return {
            zero,
            Rational(zero + rational_from_double(std::ldexp(1, -static_cast<int>(random_.integer(2, 40)))))};
      default:
        return {zero, Rational(zero + Rational(random_.integer(1, 8), 4))};
    }
  }

  std::vector<Expression> mixed(ExpressionGraph& graph, const std::vector<Expression>& equations) {
    std::vector<Expression> result;
    for (std::size_t k = 0; k < equations.size(); ++k) {  // a triangular matrix with ones on its diagonal
      Expression sum = equations[k];
      for (std::size_t j = 0; j < k; ++j) sum = sum + graph.constant(number(4, 2)) * equations[j];
      if (random_.below(4) == 0) sum = sum * graph.apply(Operation::exp, graph.variable(0));
      result.push_back(sum);
    }
    const auto first = static_cast<std::ptrdiff_t>(random_.below(result.size()));
    std::rotate(result.begin(), result.begin() + first, result.end());
    return result;
  }

  Random& random_;
  bool is_rootless_ = false;
};

}  // namespace gcslab::planted
