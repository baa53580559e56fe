#pragma once

// Small random linear programs with awkward features: degenerate vertices, nearly infeasible pairs of rows,
// equations, interval coefficients.

#include <cmath>
#include <limits>
#include <vector>

#include "base/random.h"
#include "interval/rational.h"
#include "linear_program/lp_model.h"

namespace gcslab {

struct RandomProgram {
  LpModel model;
  std::vector<LinearTerm> objective;
};

namespace random_lp_detail {

inline std::vector<LinearTerm> random_terms(Random& random, int columns) {
  std::vector<LinearTerm> terms;
  for (int column = 0; column < columns; ++column) {
    if (random.below(3) == 0) continue;
    terms.push_back({column, static_cast<double>(random.integer(-4, 4))});
  }
  return terms;
}

inline double value_at(const std::vector<LinearTerm>& terms, const std::vector<double>& point) {
  double total = 0;
  for (const LinearTerm& term : terms) {
    total += term.coefficient.lower * point[static_cast<std::size_t>(term.column)];
  }
  return total;
}

/// Sides around the value at a point: an equation, one-sided or ranged, touching the point half of the time.
inline Interval sides_around(Random& random, double value) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double below = value - static_cast<double>(random.below(2) * random.below(4));
  const double above = value + static_cast<double>(random.below(2) * random.below(4));
  switch (random.below(5)) {
    case 0:
      return {value, value};
    case 1:
      return {below, infinity};
    case 2:
      return {-infinity, above};
    case 3:
      return {below, above};
    default:
      return {static_cast<double>(random.integer(-6, 2)), infinity};
  }
}

}  // namespace random_lp_detail

/// Thin integer data (one in eight with a pair of rows that misses or overlaps by 2^-20 to 2^-60), often
/// degenerate, about one in three infeasible.
inline RandomProgram random_program(Random& random) {
  using namespace random_lp_detail;
  RandomProgram program;
  const int columns = static_cast<int>(random.integer(1, 6));
  const int rows = static_cast<int>(random.integer(0, 10));
  std::vector<double> point;
  for (int column = 0; column < columns; ++column) {
    program.model.add_column(
        {static_cast<double>(random.integer(-2, 0)), static_cast<double>(random.integer(0, 2))});
    const Interval& bounds = program.model.column(column);
    point.push_back(static_cast<double>(
        random.integer(static_cast<std::int64_t>(bounds.lower), static_cast<std::int64_t>(bounds.upper))));
  }
  for (int row = 0; row < rows; ++row) {
    const auto terms = random_terms(random, columns);
    program.model.add_row(terms, sides_around(random, value_at(terms, point)));
  }
  if (random.below(8) == 0) {
    const auto terms = random_terms(random, columns);
    const double value = value_at(terms, point);
    const double gap =
        std::ldexp(random.below(2) == 0 ? 1.0 : -1.0, -static_cast<int>(random.integer(20, 60)));
    const double infinity = std::numeric_limits<double>::infinity();
    program.model.add_row(terms, {value, infinity});
    program.model.add_row(terms, {-infinity, value + gap});
  }
  program.objective = random_terms(random, columns);
  return program;
}

/// Interval coefficients, and a point that is feasible: each row holds there for coefficients drawn from its
/// intervals, computed exactly.
struct ProgramWithPoint {
  LpModel model;
  std::vector<LinearTerm> objective;
  std::vector<Rational> point;
};

inline ProgramWithPoint random_interval_program(Random& random) {
  using namespace random_lp_detail;
  ProgramWithPoint program;
  const int columns = static_cast<int>(random.integer(1, 6));
  for (int column = 0; column < columns; ++column) {
    program.model.add_column({random.uniform(-2, 0), random.uniform(0, 2)});
    const Interval& bounds = program.model.column(column);
    const double value = random.below(4) == 0 ? bounds.upper : random.uniform(bounds.lower, bounds.upper);
    program.point.push_back(rational_from_double(value));
  }
  const auto random_interval_terms = [&](Rational& value) {
    std::vector<LinearTerm> terms;
    for (int column = 0; column < columns; ++column) {
      if (random.below(3) == 0) continue;
      const double lower = random.uniform(-3, 3);
      const double width =
          random.below(2) == 0 ? 0 : std::ldexp(random.unit(), -static_cast<int>(random.below(52)));
      const Interval coefficient(lower, lower + width);
      terms.push_back({column, coefficient});
      const double drawn = random.below(2) == 0 ? coefficient.lower : coefficient.upper;
      value += rational_from_double(drawn) * program.point[static_cast<std::size_t>(column)];
    }
    return terms;
  };
  const auto rows = random.below(10);
  for (std::uint64_t row = 0; row < rows; ++row) {
    Rational value = 0;
    const auto terms = random_interval_terms(value);
    const double nearest = nearest_double(value);
    const double infinity = std::numeric_limits<double>::infinity();
    const double below = std::nextafter(nearest, -infinity);
    const double above = std::nextafter(nearest, infinity);
    const bool open_above = random.below(3) == 0;
    const bool open_below = !open_above && random.below(3) == 0;
    program.model.add_row(terms, {open_below ? -infinity : below, open_above ? infinity : above});
  }
  Rational ignored = 0;
  program.objective = random_interval_terms(ignored);
  return program;
}

}  // namespace gcslab
