#pragma once

// Random B-spline curves whose knots and points are dyadic, so that doubles hold them exactly.

#include <algorithm>
#include <vector>

#include "base/random.h"
#include "spline/curve.h"

namespace gcslab::random_spline {

inline Rational dyadic(Random& random, std::int64_t size, long denominator) {
  Rational result(static_cast<long>(random.integer(-size * denominator, size * denominator)), denominator);
  result.canonicalize();
  return result;
}

/// Clamped or not, with interior knots of random multiplicities, one of which is `multiplicity`.
inline KnotVector<Rational> knots(Random& random, int degree, int multiplicity) {
  std::vector<Rational> result;
  Rational place = dyadic(random, 4, 8);
  const auto advance = [&] {
    Rational step(static_cast<long>(random.integer(1, 16)), 8);
    step.canonicalize();
    place += step;
  };
  const bool is_clamped = random.below(3) != 0;
  const auto end = [&] {
    for (int i = 0; i <= degree; ++i) {
      if (!is_clamped && i > 0) advance();
      result.push_back(place);
    }
  };
  end();
  const auto interior = static_cast<std::size_t>(random.integer(1, 3));
  const std::size_t chosen = random.below(interior);
  for (std::size_t i = 0; i < interior; ++i) {
    advance();
    const auto copies = i == chosen ? multiplicity : static_cast<int>(random.integer(1, degree + 1));
    result.insert(result.end(), static_cast<std::size_t>(copies), place);
  }
  advance();
  end();
  return KnotVector<Rational>(degree, std::move(result));
}

inline Matrix<Rational> points(Random& random, std::size_t rows, std::size_t dimension) {
  Matrix<Rational> result(rows, dimension);
  for (std::size_t i = 0; i < rows * dimension; ++i) result.data()[i] = dyadic(random, 4, 64);
  return result;
}

inline BSplineCurve<Rational> curve(Random& random, int degree, int multiplicity, std::size_t dimension = 2) {
  KnotVector<Rational> vector = knots(random, degree, multiplicity);
  Matrix<Rational> rows = points(random, vector.size(), dimension);
  return BSplineCurve<Rational>(std::move(vector), std::move(rows));
}

/// A parameter of the domain, no knot as a rule.
inline Rational parameter(Random& random, const KnotVector<Rational>& knots) {
  Rational part(static_cast<long>(random.integer(0, 1 << 10)), 1 << 10);
  part.canonicalize();
  return knots.lower() + (knots.upper() - knots.lower()) * part;
}

/// f(curve, random) for every degree 1..7 with every multiplicity 1..d+1 of an interior knot.
template <class F>
void for_every_multiplicity(Random& random, std::size_t cases, const F& f) {
  for (std::size_t i = 0; i < cases; ++i) {
    for (int degree = 1; degree <= 7; ++degree) {
      for (int multiplicity = 1; multiplicity <= degree + 1; ++multiplicity)
        f(curve(random, degree, multiplicity));
    }
  }
}

/// The values of the curve at some parameters of each span, exactly: as many as its polynomials have
/// coefficients, so that two curves with the same ones are the same.
inline std::vector<Rational> sample_parameters(const KnotVector<Rational>& knots) {
  std::vector<Rational> result;
  for (const std::size_t k : knots.spans()) {
    for (int i = 0; i <= knots.degree(); ++i) {
      Rational part(2 * i + 1, 2 * knots.degree() + 3);
      part.canonicalize();
      result.emplace_back(knots[k] + (knots[k + 1] - knots[k]) * part);
    }
  }
  return result;
}

/// Whether b is the curve a on the domain of b, at the samples of both.
inline bool is_same_curve(const BSplineCurve<Rational>& a, const BSplineCurve<Rational>& b) {
  const auto agree = [&](const Rational& u) { return evaluate(a, u) == evaluate(b, u); };
  const auto in_b = [&](const Rational& u) { return b.knots.lower() <= u && u < b.knots.upper(); };
  return std::ranges::all_of(sample_parameters(b.knots), agree) &&
         std::ranges::all_of(sample_parameters(a.knots),
                             [&](const Rational& u) { return !in_b(u) || agree(u); }) &&
         agree(b.knots.lower());
}

/// The curve of Celikbas 2003, figure 2.
template <class T>
BSplineCurve<T> report_curve() {
  const std::vector<std::vector<const char*>> texts = {{"0.41705", "0.10673"}, {"0.28802", "0.60088"},
                                                       {"0.90553", "0.46053"}, {"1.3203", "0.79678"},
                                                       {"1.8041", "0.63012"},  {"1.477", "0.13012"}};
  Matrix<T> rows(texts.size(), 2);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (std::size_t c = 0; c < 2; ++c)
      rows(i, c) = NumberTraits<T>::from_rational(rational_from_text(texts[i][c]));
  }
  std::vector<T> knots;
  for (const long knot : {0, 0, 0, 0, 1, 2, 3, 3, 3, 3}) knots.push_back(whole_number<T>(knot));
  return BSplineCurve<T>(KnotVector<T>(3, std::move(knots)), std::move(rows));
}

}  // namespace gcslab::random_spline
