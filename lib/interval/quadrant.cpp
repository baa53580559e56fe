#include "interval/quadrant.h"

#include <algorithm>
#include <cmath>
#include <gmpxx.h>
#include <optional>

#include "interval/rounding.h"

namespace gcslab::elementary {
namespace {

constexpr mpfr_exp_t kLargestExponent = 65536;

QuadrantSpan whole_period() { return {0, 4}; }

/// An MPFR number that frees itself.
class Scratch {
 public:
  explicit Scratch(mpfr_prec_t precision) { mpfr_init2(value_, precision); }
  ~Scratch() { mpfr_clear(value_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  mpfr_ptr get() { return value_; }

 private:
  mpfr_t value_;
};

/// floor(2 x / pi) if it is certain in this precision: both roundings of the quotient have the same floor.
std::optional<mpz_class> quadrant_at(mpfr_srcptr x, mpfr_prec_t precision) {
  Scratch pi(precision);
  Scratch quotient(precision);
  mpz_class floors[2];
  const mpfr_rnd_t directions[2] = {MPFR_RNDD, MPFR_RNDU};
  const bool positive = mpfr_sgn(x) > 0;
  for (int i = 0; i < 2; ++i) {
    const mpfr_rnd_t direction = directions[i];
    const mpfr_rnd_t opposite = directions[1 - i];
    mpfr_const_pi(pi.get(), positive ? opposite : direction);
    mpfr_div(quotient.get(), x, pi.get(), direction);
    mpfr_mul_2ui(quotient.get(), quotient.get(), 1, direction);
    mpfr_get_z(floors[i].get_mpz_t(), quotient.get(), MPFR_RNDD);
  }
  if (floors[0] != floors[1]) return std::nullopt;
  return floors[0];
}

mpz_class quadrant_of(mpfr_srcptr x) {
  if (mpfr_zero_p(x)) return 0;
  const mpfr_exp_t magnitude = std::max<mpfr_exp_t>(mpfr_get_exp(x), 0);
  for (mpfr_prec_t precision = mpfr_get_prec(x) + magnitude + 64;; precision *= 2) {
    if (const auto quadrant = quadrant_at(x, precision)) return *quadrant;
  }
}

/// The quadrant of a small argument when plain arithmetic, whose error is below 2^-20, already tells it.
std::optional<long> quickly(double x) {
  constexpr double kTwoOverPi = 0x1.45f306dc9c883p-1;
  constexpr double kMargin = 0x1p-20;
  if (std::fabs(x) < 1.5) return x < 0 ? -1 : 0;
  if (!(std::fabs(x) < 0x1p30)) return std::nullopt;
  const double scaled = rounded_multiply(x, kTwoOverPi);
  const double below = std::floor(scaled);
  const double fraction = rounded_subtract(scaled, below);
  if (fraction < kMargin || fraction > 1 - kMargin) return std::nullopt;
  return static_cast<long>(below);
}

int residue_of(long quadrant) { return static_cast<int>(((quadrant % 4) + 4) % 4); }

}  // namespace

bool QuadrantSpan::crosses(int residue) const {
  const int distance = (residue - first + 4) % 4;
  return crossings >= (distance == 0 ? 4 : distance);
}

QuadrantSpan quadrant_span(double lower, double upper) {
  const auto first = quickly(lower);
  const auto last = quickly(upper);
  if (first && last) return {residue_of(*first), static_cast<int>(std::min(*last - *first, 4L))};
  Scratch exact_lower(53);
  Scratch exact_upper(53);
  mpfr_set_d(exact_lower.get(), lower, MPFR_RNDN);
  mpfr_set_d(exact_upper.get(), upper, MPFR_RNDN);
  return quadrant_span(exact_lower.get(), exact_upper.get());
}

QuadrantSpan quadrant_span(mpfr_srcptr lower, mpfr_srcptr upper) {
  for (const mpfr_srcptr end : {lower, upper}) {
    if (!mpfr_zero_p(end) && mpfr_get_exp(end) > kLargestExponent) return whole_period();
  }
  const mpz_class first = quadrant_of(lower);
  const mpz_class crossings = quadrant_of(upper) - first;
  const unsigned long residue = mpz_fdiv_ui(first.get_mpz_t(), 4);
  return {static_cast<int>(residue), crossings > 4 ? 4 : static_cast<int>(crossings.get_si())};
}

}  // namespace gcslab::elementary
