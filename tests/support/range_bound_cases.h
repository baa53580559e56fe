#pragma once

// Every registered range bound in every rigorous arithmetic, and random functions, boxes and points to try
// them on.

#include <map>
#include <string>
#include <vector>

#include "base/random.h"
#include "enclosure/bound_registry.h"
#include "expression/tape_evaluator.h"
#include "interval/point_numbers.h"

// A namespace of its own: other support headers have functions of the same names.
namespace gcslab::bound_cases {

/// A registered bound with one choice of arithmetic.
struct BoundChoice {
  std::string bound;
  std::string arithmetic;  ///< empty when the bound has no such option

  const BoundVariant& variant() const { return bound_registry().at(bound); }
  Options options() const {
    std::map<std::string, std::string> given;
    if (!arithmetic.empty()) given["arithmetic"] = arithmetic;
    if (arithmetic == "mpfr") given["bits"] = "80";
    return Options(variant().options, given, bound);
  }
  std::unique_ptr<RangeBound> make(const BoundTarget& target) const {
    return variant().make(target, options());
  }
  std::string name() const { return bound + (arithmetic.empty() ? "" : "_" + arithmetic); }
};

/// All rigorous choices.
inline std::vector<BoundChoice> rigorous_choices() {
  std::vector<BoundChoice> choices;
  for (const BoundVariant& variant : bound_registry().entries()) {
    std::vector<std::string> arithmetics = {""};
    for (const OptionSpec& option : variant.options) {
      if (option.name == "arithmetic") arithmetics = option.choices;
    }
    for (const std::string& arithmetic : arithmetics) {
      const BoundChoice choice{variant.name, arithmetic};
      if (variant.promise(choice.options()) == Promise::rigorous) choices.push_back(choice);
    }
  }
  return choices;
}

/// A random polynomial of low degree as an expression that mixes sums, products and powers.
inline Expression random_expression(ExpressionGraph& graph, Random& random, int variables, int depth) {
  const auto leaf = [&]() -> Expression {
    if (random.below(3) == 0) return graph.constant(Rational(random.integer(-40, 40), random.integer(1, 12)));
    return graph.variable(static_cast<int>(random.below(static_cast<std::uint64_t>(variables))));
  };
  if (depth == 0) return leaf();
  const Expression a = random_expression(graph, random, variables, depth - 1);
  switch (random.below(6)) {
    case 0:
      return a + random_expression(graph, random, variables, depth - 1);
    case 1:
      return a - random_expression(graph, random, variables, depth - 1);
    case 2:
    case 3:
      return a * random_expression(graph, random, variables, depth - 1);
    case 4:
      return pow(a, static_cast<int>(random.integer(2, 3)));
    default:
      return -a + leaf();
  }
}

inline double random_end(Random& random) {
  switch (random.below(4)) {
    case 0:
      return static_cast<double>(random.integer(-3, 3));
    case 1:
      return random.uniform(-1, 1) * 1e-8;
    case 2:
      return random.uniform(-50, 50);
    default:
      return random.uniform(-2, 2);
  }
}

inline Box random_box(Random& random, int variables) {
  Box box;
  for (int i = 0; i < variables; ++i) {
    const double a = random_end(random);
    const double b = random.below(8) == 0 ? a : random_end(random);
    box.emplace_back(std::min(a, b), std::max(a, b));
  }
  return box;
}

/// A rational point of the box: a corner now and then, else a point between.
inline std::vector<Rational> random_member(Random& random, const Box& box) {
  std::vector<Rational> point;
  for (const Interval& side : box) {
    const Rational lower = rational_from_double(side.lower), upper = rational_from_double(side.upper);
    const std::int64_t steps = random.below(4) == 0 ? 1 : 97;
    Rational t(random.integer(0, steps), steps);
    t.canonicalize();
    point.push_back(lower + (upper - lower) * t);
  }
  return point;
}

inline Rational exact_value(const Tape& tape, const std::vector<Rational>& point) {
  TapeEvaluator<Rational> evaluator(tape);
  evaluator.evaluate(point);
  return evaluator.value();
}

inline bool encloses(const Interval& bound, const Rational& value) {
  const bool above = bound.lower == Interval::entire().lower || rational_from_double(bound.lower) <= value;
  const bool below = bound.upper == Interval::entire().upper || value <= rational_from_double(bound.upper);
  return above && below;
}

}  // namespace gcslab::bound_cases
