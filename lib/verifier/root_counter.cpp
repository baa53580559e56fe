#include "verifier/root_counter.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace gcslab::verifier {
namespace {

using Integers = std::vector<mpz_class>;

void trim(Integers& a) {
  while (!a.empty() && a.back() == 0) a.pop_back();
}

/// Divided by the common factor of the coefficients, which is positive: no sign changes.
void make_primitive(Integers& a) {
  mpz_class common;
  for (const mpz_class& c : a) common = gcd(common, c);
  if (common == 0) return;
  for (mpz_class& c : a) c /= common;
}

Integers integers(const PolynomialTerms& terms) {
  mpz_class denominator = 1;
  std::size_t degree = 0;
  for (const auto& [exponents, c] : terms) {
    denominator = lcm(denominator, c.get_den());
    degree = std::max(degree, static_cast<std::size_t>(exponents.at(0)));
  }
  Integers result(degree + 1);
  for (const auto& [exponents, c] : terms)
    result[static_cast<std::size_t>(exponents[0])] = c.get_num() * (denominator / c.get_den());
  trim(result);
  make_primitive(result);
  return result;
}

Integers derivative(const Integers& a) {
  Integers result;
  for (std::size_t k = 1; k < a.size(); ++k) result.emplace_back(a[k] * static_cast<unsigned long>(k));
  make_primitive(result);
  return result;
}

/// A positive multiple of -(a modulo b).
Integers negative_remainder(Integers a, const Integers& b) {
  const mpz_class scale = abs(b.back());
  while (a.size() >= b.size()) {
    mpz_class factor = a.back();
    if (b.back() < 0) factor = -factor;
    for (mpz_class& c : a) c *= scale;
    for (std::size_t i = 0; i < b.size(); ++i) a[a.size() - b.size() + i] -= factor * b[i];
    trim(a);
  }
  for (mpz_class& c : a) c = -c;
  make_primitive(a);
  return a;
}

/// A positive multiple of a / b, or a negative one when b's leading coefficient is negative; b divides a.
Integers quotient(Integers a, const Integers& b) {
  Integers result(a.size() - b.size() + 1);
  for (std::size_t k = result.size(); k-- > 0;) {
    GCSLAB_CHECK(mpz_divisible_p(a[k + b.size() - 1].get_mpz_t(), b.back().get_mpz_t()) != 0);
    result[k] = a[k + b.size() - 1] / b.back();
    for (std::size_t i = 0; i < b.size(); ++i) a[k + i] -= result[k] * b[i];
  }
  return result;
}

/// p, p' and the negative remainders down to their greatest common divisor.
std::vector<Integers> remainders(const Integers& p) {
  std::vector<Integers> chain = {p};
  Integers next = derivative(p);
  while (!next.empty()) {
    chain.push_back(std::move(next));
    next = negative_remainder(chain[chain.size() - 2], chain.back());
  }
  return chain;
}

int sign_at(const Integers& p, double x) {
  if (std::isinf(x)) return p.size() % 2 == 0 && x < 0 ? -sgn(p.back()) : sgn(p.back());
  const Rational point(x);
  mpz_class value;
  mpz_class power = 1;
  for (std::size_t k = p.size(); k-- > 0;) {
    value = value * point.get_num() + p[k] * power;
    power *= point.get_den();
  }
  return sgn(value);
}

/// Disjoint intervals with the same union, in order.
std::vector<Interval> merged(std::vector<Interval> intervals) {
  std::ranges::sort(intervals, {}, &Interval::lower);
  std::vector<Interval> result;
  for (const Interval& x : intervals) {
    if (is_empty(x)) continue;
    if (!result.empty() && x.lower <= result.back().upper) {
      result.back().upper = std::max(result.back().upper, x.upper);
    } else {
      result.push_back(x);
    }
  }
  return result;
}

}  // namespace

RootCounter::RootCounter(const PolynomialTerms& terms) {
  Integers p = integers(terms);
  GCSLAB_CHECK(!p.empty());
  do {
    std::vector<Integers> chain = remainders(p);
    p = chain.back();
    for (Integers& member : chain) member = quotient(std::move(member), p);
    chains_.push_back(std::move(chain));
  } while (p.size() > 1);
}

int RootCounter::variations(const std::vector<Integers>& chain, double x) {
  int changes = 0;
  int last = 0;
  for (const Integers& member : chain) {
    const int sign = sign_at(member, x);
    if (sign * last < 0) ++changes;
    if (sign != 0) last = sign;
  }
  return changes;
}

/// Sturm's theorem counts in ]lower, upper].
int RootCounter::count(std::size_t level, const Interval& x) const {
  if (level >= chains_.size() || is_empty(x)) return 0;
  const std::vector<Integers>& chain = chains_[level];
  const bool is_root = std::isfinite(x.lower) && sign_at(chain[0], x.lower) == 0;
  return variations(chain, x.lower) - variations(chain, x.upper) + (is_root ? 1 : 0);
}

int RootCounter::count_in_union(std::vector<Interval> intervals) const {
  int sum = 0;
  for (const Interval& x : merged(std::move(intervals))) sum += count(0, x);
  return sum;
}

int RootCounter::multiplicity(const Interval& x) const {
  if (count(0, x) != 1) return 0;
  int multiplicity = 1;
  while (count(static_cast<std::size_t>(multiplicity), x) == 1) ++multiplicity;
  return multiplicity;
}

}  // namespace gcslab::verifier
