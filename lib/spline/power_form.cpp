#include "spline/power_form.h"

namespace gcslab {

std::vector<PowerForm> power_forms(const BezierPiece<Rational>& piece) {
  const std::size_t count = piece.points.rows();
  std::vector<PowerForm> forms;
  for (std::size_t c = 0; c < piece.points.columns(); ++c) {
    PowerForm differences;
    for (std::size_t i = 0; i < count; ++i) differences.push_back(piece.points(i, c));
    for (std::size_t k = 1; k < count; ++k) {
      for (std::size_t i = count - 1; i >= k; --i) differences[i] -= differences[i - 1];
    }
    Rational binomial = 1;
    for (std::size_t k = 0; k < count; ++k) {
      differences[k] *= binomial;
      binomial *= Rational(static_cast<unsigned long>(count - 1 - k));
      binomial /= Rational(static_cast<unsigned long>(k + 1));
    }
    forms.push_back(std::move(differences));
  }
  return forms;
}

PowerForm product(const PowerForm& a, const PowerForm& b) {
  if (a.empty() || b.empty()) return {};
  PowerForm result(a.size() + b.size() - 1, Rational(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  }
  return result;
}

PowerForm sum(const PowerForm& a, const PowerForm& b) {
  PowerForm result = a;
  result.resize(std::max(a.size(), b.size()), Rational(0));
  for (std::size_t i = 0; i < b.size(); ++i) result[i] += b[i];
  return result;
}

PowerForm derivative(const PowerForm& a) {
  PowerForm result;
  for (std::size_t k = 1; k < a.size(); ++k)
    result.emplace_back(a[k] * Rational(static_cast<unsigned long>(k)));
  return result;
}

Rational value(const PowerForm& a, const Rational& t) {
  Rational result = 0;
  for (std::size_t k = a.size(); k > 0; --k) result = result * t + a[k - 1];
  return result;
}

bool is_zero(const PowerForm& a) {
  return std::ranges::all_of(a, [](const Rational& c) { return c == 0; });
}

std::vector<RationalInterval> unit_roots(const PowerForm& a, int bits) {
  if (is_zero(a)) return {};
  mpz_class denominator = 1;
  for (const Rational& c : a) denominator = lcm(denominator, c.get_den());
  std::vector<mpz_class> integers;
  for (const Rational& c : a) integers.emplace_back(Rational(c * denominator).get_num());
  while (integers.back() == 0) integers.pop_back();
  RealRoots roots(IntegerPolynomial(std::move(integers)), {Rational(0), Rational(1)});
  const Rational width = pow(Rational(2), -bits);
  std::vector<RationalInterval> result;
  for (std::size_t i = 0; i < roots.roots().size(); ++i) {
    roots.try_exact(i, 0);
    roots.try_exact(i, 1);
    roots.refine(i, width);
    result.push_back({roots.roots()[i].lower, roots.roots()[i].upper});
  }
  return result;
}

RationalInterval range_on(const PowerForm& a, const RationalInterval& t) {
  const Rational middle = value(a, Rational((t.lower + t.upper) / 2));
  Rational steepness = 0;
  for (const Rational& c : derivative(a)) steepness += abs(c);
  const Rational slack = steepness * (t.upper - t.lower) / 2;
  return {middle - slack, middle + slack};
}

Interval rounded(const RationalInterval& x) {
  return {NumberTraits<Rational>::enclosure(x.lower).lower, NumberTraits<Rational>::enclosure(x.upper).upper};
}

}  // namespace gcslab
