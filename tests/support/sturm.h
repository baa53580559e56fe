#pragma once

// The number of distinct real roots by Sturm's theorem (1829) in exact rationals: an oracle that shares
// nothing with Descartes' rule but the integers.

#include <vector>

#include "interval/rational.h"

namespace gcslab {

class SturmChain {
 public:
  /// By ascending powers; the last one is not 0.
  explicit SturmChain(const std::vector<mpz_class>& coefficients) {
    std::vector<Rational> p(coefficients.begin(), coefficients.end());
    std::vector<Rational> derivative;
    for (std::size_t k = 1; k < p.size(); ++k) derivative.emplace_back(p[k] * static_cast<unsigned long>(k));
    chain_ = {p, derivative};
    while (!chain_.back().empty())
      chain_.push_back(minus_remainder(chain_[chain_.size() - 2], chain_.back()));
    chain_.pop_back();
    const Numbers common = chain_.back();
    for (Numbers& member : chain_) member = quotient(std::move(member), common);
  }

  /// Distinct roots in [lower, upper].
  int count(const Rational& lower, const Rational& upper) const {
    return variations(lower) - variations(upper) + (value(chain_[0], lower) == 0 ? 1 : 0);
  }
  /// Distinct roots on the whole line, from the signs at -bound and bound beyond all roots.
  int count() const {
    Rational bound = 1;
    for (const Rational& c : chain_[0]) bound += abs(c / chain_[0].back());
    return count(-bound, bound);
  }

 private:
  using Numbers = std::vector<Rational>;

  static Numbers quotient(Numbers a, const Numbers& b) {
    Numbers result(a.size() - b.size() + 1);
    for (std::size_t k = result.size(); k-- > 0;) {
      result[k] = a[k + b.size() - 1] / b.back();
      for (std::size_t i = 0; i < b.size(); ++i) a[k + i] -= result[k] * b[i];
    }
    return result;
  }
  static Numbers minus_remainder(Numbers a, const Numbers& b) {
    while (a.size() >= b.size()) {
      const Rational factor = a.back() / b.back();
      for (std::size_t i = 0; i < b.size(); ++i) a[a.size() - b.size() + i] -= factor * b[i];
      while (!a.empty() && a.back() == 0) a.pop_back();
    }
    if (a.empty()) return a;
    const Rational size = abs(a.back());
    for (Rational& x : a) x /= -size;
    return a;
  }
  static Rational value(const Numbers& p, const Rational& x) {
    Rational result = 0;
    for (std::size_t k = p.size(); k-- > 0;) result = result * x + p[k];
    return result;
  }
  /// Changes of sign along the chain, zeros left out.
  int variations(const Rational& x) const {
    int changes = 0, last = 0;
    for (const Numbers& p : chain_) {
      const int sign = sgn(value(p, x));
      if (sign != 0 && sign == -last) ++changes;
      if (sign != 0) last = sign;
    }
    return changes;
  }

  std::vector<Numbers> chain_;  ///< divided by its last member, so that nowhere all of them vanish
};

}  // namespace gcslab
