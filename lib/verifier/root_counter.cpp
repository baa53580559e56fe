#include "verifier/root_counter.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace gcslab::verifier {
namespace {

/// p, p' and the negative remainders down to their greatest common divisor.
std::vector<IntegerPolynomial> remainders(const IntegerPolynomial& p) {
  std::vector<IntegerPolynomial> chain = {p};
  IntegerPolynomial next = p.derivative();
  while (!next.is_zero()) {
    chain.push_back(std::move(next));
    next = chain[chain.size() - 2].negative_remainder(chain.back());
  }
  return chain;
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
  IntegerPolynomial p(terms);
  GCSLAB_CHECK(!p.is_zero());
  do {
    std::vector<IntegerPolynomial> chain = remainders(p);
    p = chain.back();
    for (IntegerPolynomial& member : chain) member = member.quotient(p);
    chains_.push_back(std::move(chain));
  } while (p.degree() > 0);
}

int RootCounter::variations(const std::vector<IntegerPolynomial>& chain, double x) {
  int changes = 0;
  int last = 0;
  for (const IntegerPolynomial& member : chain) {
    const int sign = member.sign_at(x);
    if (sign * last < 0) ++changes;
    if (sign != 0) last = sign;
  }
  return changes;
}

/// Sturm's theorem counts in ]lower, upper].
int RootCounter::count(std::size_t level, const Interval& x) const {
  if (level >= chains_.size() || is_empty(x)) return 0;
  const std::vector<IntegerPolynomial>& chain = chains_[level];
  const bool is_root = std::isfinite(x.lower) && chain[0].sign_at(x.lower) == 0;
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
