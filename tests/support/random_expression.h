#pragma once

// Random expressions in a graph, for round trips and comparisons of evaluations.

#include <vector>

#include "base/random.h"
#include "expression/expression.h"

namespace gcslab {

/// What random expressions are built from.
enum class Vocabulary { polynomial, rational, transcendental };

class RandomExpressions {
 public:
  RandomExpressions(ExpressionGraph& graph, int variables, Vocabulary vocabulary, Random& random)
      : graph_(graph), variables_(variables), vocabulary_(vocabulary), random_(random) {}

  /// An expression with at most `depth` operations on top of each other.
  Expression draw(int depth) {
    if (depth == 0 || below(6) == 0) return leaf();
    switch (below(vocabulary_ == Vocabulary::polynomial ? 7
                  : vocabulary_ == Vocabulary::rational ? 11
                                                        : 13)) {
      case 0:
      case 1:
        return draw(depth - 1) + draw(depth - 1);
      case 2:
        return draw(depth - 1) - draw(depth - 1);
      case 3:
        return draw(depth - 1) * draw(depth - 1);
      case 4:
        return -draw(depth - 1);
      case 5:
        return pow(draw(depth - 1), 2 + below(3));
      case 6:
        return draw(depth - 1) / graph_.constant(nonzero());
      case 7:
        return graph_.apply(Operation::abs, draw(depth - 1));
      case 8:
        return graph_.apply(below(2) == 0 ? Operation::min : Operation::max, draw(depth - 1),
                            draw(depth - 1));
      case 9:
        return variable() / (sqr(variable()) + graph_.constant(1 + below(3)));
      case 10:
        return graph_.power(sqr(variable()) + graph_.constant(1), -1 - below(3));
      default:
        return transcendental(depth);
    }
  }

 private:
  Expression transcendental(int depth) {
    static const std::vector<Operation> kFunctions = {Operation::sqrt, Operation::exp,  Operation::log,
                                                      Operation::sin,  Operation::cos,  Operation::tan,
                                                      Operation::asin, Operation::acos, Operation::atan};
    const int which = below(static_cast<int>(kFunctions.size()) + 2);
    if (which == 0) return graph_.pi();
    if (which == 1) return graph_.power(draw(depth - 1), Rational(3 + 2 * below(3), 4));
    return graph_.apply(kFunctions[static_cast<std::size_t>(which - 2)], draw(depth - 1));
  }

  Expression leaf() { return below(3) == 0 ? graph_.constant(fraction()) : variable(); }
  Expression variable() { return graph_.variable(below(variables_)); }
  Rational fraction() {
    Rational value(below(41) - 20, 1 + below(7));
    value.canonicalize();
    return value;
  }
  Rational nonzero() {
    const Rational value = fraction();
    return value == 0 ? Rational(5, 3) : value;
  }
  int below(int bound) { return static_cast<int>(random_.below(static_cast<std::uint64_t>(bound))); }

  ExpressionGraph& graph_;
  int variables_;
  Vocabulary vocabulary_;
  Random& random_;
};

}  // namespace gcslab
