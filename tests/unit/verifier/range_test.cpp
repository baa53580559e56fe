#include "verifier/range.h"

#include <gtest/gtest.h>

#include "interval/fast_interval.h"
#include "interval/reverse_operations.h"
#include "support/fuzz.h"
#include "support/random_interval.h"
#include "verifier/projection.h"

namespace gcslab::verifier {
namespace {

/// A number of far more digits than a range has.
class Oracle {
 public:
  Oracle() { mpfr_init2(value_, 3000); }
  explicit Oracle(double x) : Oracle() { mpfr_set_d(value_, x, MPFR_RNDN); }
  Oracle(const Oracle& other) : Oracle() { mpfr_set(value_, other.value_, MPFR_RNDN); }
  Oracle& operator=(const Oracle&) = delete;
  ~Oracle() { mpfr_clear(value_); }
  mpfr_ptr get() { return value_; }
  mpfr_srcptr get() const { return value_; }

 private:
  mpfr_t value_;
};

bool holds(const Range& x, const Oracle& value) {
  return mpfr_lessequal_p(x.lower(), value.get()) != 0 && mpfr_lessequal_p(value.get(), x.upper()) != 0;
}

bool is_number(const Oracle& value) { return mpfr_number_p(value.get()) != 0; }

struct UnaryCase {
  const char* name;
  Range (*range)(const Range&);
  FastInterval (*fast)(FastInterval);
  int (*exact)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
  Range (*projection)(const Range&, const Range&);
  FastInterval (*fast_projection)(const FastInterval&, const FastInterval&);
};

const UnaryCase kUnary[] = {
    {"negate", [](const Range& x) { return -x; }, [](FastInterval x) { return -x; }, mpfr_neg, nullptr,
     nullptr},
    {"sqr", sqr, gcslab::sqr, mpfr_sqr, project_sqr, gcslab::reverse_sqr<FastInterval>},
    {"sqrt", sqrt, gcslab::sqrt, mpfr_sqrt, project_sqrt, gcslab::reverse_sqrt<FastInterval>},
    {"cbrt", cbrt, gcslab::cbrt, mpfr_cbrt, nullptr, nullptr},
    {"exp", exp, gcslab::exp, mpfr_exp, nullptr, nullptr},
    {"log", log, gcslab::log, mpfr_log, nullptr, nullptr},
    {"sin", sin, gcslab::sin, mpfr_sin, project_sin, gcslab::reverse_sin<FastInterval>},
    {"cos", cos, gcslab::cos, mpfr_cos, project_cos, gcslab::reverse_cos<FastInterval>},
    {"tan", tan, gcslab::tan, mpfr_tan, project_tan, gcslab::reverse_tan<FastInterval>},
    {"asin", asin, gcslab::asin, mpfr_asin, project_asin, gcslab::reverse_asin<FastInterval>},
    {"acos", acos, gcslab::acos, mpfr_acos, project_acos, gcslab::reverse_acos<FastInterval>},
    {"atan", atan, gcslab::atan, mpfr_atan, project_atan, gcslab::reverse_atan<FastInterval>},
    {"abs", abs, gcslab::abs, mpfr_abs, project_abs, gcslab::reverse_abs<FastInterval>},
};

TEST(Range, FunctionsContainTheValuesOfMembersAndLieInTheDoubleEnclosure) {
  Random random(fuzz_seed(), "verifier.range");
  const NumberTraits<FastInterval>::Scope scope;
  for (const UnaryCase& f : kUnary) {
    for (std::size_t i = 0; i < fuzz_cases(3000); ++i) {
      const Interval x = random_interval(random);
      const Range value = f.range(Range(x));
      EXPECT_TRUE(value.is_within(f.fast(FastInterval(x)).interval())) << f.name << " " << to_string(x);
      const Oracle member(random_member(random, x));
      Oracle exact;
      f.exact(exact.get(), member.get(), MPFR_RNDN);
      if (is_number(exact)) {
        EXPECT_TRUE(holds(value, exact)) << f.name << " " << to_string(x);
      }
    }
  }
}

TEST(Projection, KeepsEveryArgumentWhoseValueIsWantedAndLiesInTheDoubleEnclosure) {
  Random random(fuzz_seed(), "verifier.projection");
  const NumberTraits<FastInterval>::Scope scope;
  for (const UnaryCase& f : kUnary) {
    if (f.projection == nullptr) continue;
    for (std::size_t i = 0; i < fuzz_cases(3000); ++i) {
      const Interval z = random_interval(random);
      const Interval x = random_interval(random);
      const Range left = f.projection(Range(z), Range(x));
      const FastInterval expected = f.fast_projection(FastInterval(z), FastInterval(x));
      EXPECT_TRUE(left.is_within(expected.interval())) << f.name << to_string(z) << to_string(x);
      const Oracle member(random_member(random, x));
      Oracle value;
      f.exact(value.get(), member.get(), MPFR_RNDN);
      if (is_number(value) && holds(Range(z), value)) {
        EXPECT_TRUE(holds(left, member)) << f.name << to_string(z) << to_string(x);
      }
    }
  }
}

struct BinaryCase {
  const char* name;
  Range (*range)(const Range&, const Range&);
  FastInterval (*fast)(FastInterval, FastInterval);
  int (*exact)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
};

const BinaryCase kBinary[] = {
    {"add", [](const Range& x, const Range& y) { return x + y; },
     [](FastInterval x, FastInterval y) { return x + y; }, mpfr_add},
    {"subtract", [](const Range& x, const Range& y) { return x - y; },
     [](FastInterval x, FastInterval y) { return x - y; }, mpfr_sub},
    {"multiply", [](const Range& x, const Range& y) { return x * y; },
     [](FastInterval x, FastInterval y) { return x * y; }, mpfr_mul},
    {"divide", [](const Range& x, const Range& y) { return x / y; },
     [](FastInterval x, FastInterval y) { return x / y; }, mpfr_div},
    {"min", min, gcslab::min, mpfr_min},
    {"max", max, gcslab::max, mpfr_max},
};

TEST(Range, ArithmeticContainsTheValuesOfMembersAndLiesInTheDoubleEnclosure) {
  Random random(fuzz_seed(), "verifier.arithmetic");
  const NumberTraits<FastInterval>::Scope scope;
  for (const BinaryCase& f : kBinary) {
    for (std::size_t i = 0; i < fuzz_cases(5000); ++i) {
      const Interval x = random_interval(random);
      const Interval y = random_interval(random);
      const Range value = f.range(Range(x), Range(y));
      EXPECT_TRUE(value.is_within(f.fast(FastInterval(x), FastInterval(y)).interval()))
          << f.name << to_string(x) << to_string(y);
      Oracle exact;
      f.exact(exact.get(), Oracle(random_member(random, x)).get(), Oracle(random_member(random, y)).get(),
              MPFR_RNDN);
      if (is_number(exact)) {
        EXPECT_TRUE(holds(value, exact)) << f.name << to_string(x) << to_string(y);
      }
    }
  }
}

TEST(Range, AThirdIsEnclosedAsTightlyAs256BitsAllow) {
  const Range third(Rational(1, 3));
  EXPECT_TRUE(mpfr_less_p(third.lower(), third.upper()) != 0);
  Real next = Real();
  mpfr_set(next.get(), third.lower(), MPFR_RNDN);
  mpfr_nextabove(next.get());
  EXPECT_TRUE(mpfr_equal_p(next.get(), third.upper()) != 0);
  EXPECT_TRUE((Range(1.0) - third * Range(3.0)).contains_zero());
}

TEST(Range, PowersContainTheValuesOfMembersAndLieInTheDoubleEnclosure) {
  Random random(fuzz_seed(), "verifier.power");
  const NumberTraits<FastInterval>::Scope scope;
  const Rational exponents[] = {
      3, 4, -1, -2, 7, Rational(1, 2), Rational(2, 3), Rational(-5, 3), Rational(3, 4)};
  for (const Rational& exponent : exponents) {
    for (std::size_t i = 0; i < fuzz_cases(2000); ++i) {
      const Interval x = random_interval(random);
      const Interval z = random_interval(random);
      const Range value = power(Range(x), exponent);
      const FastInterval fast(x);
      const FastInterval expected = exponent.get_den() == 1
                                        ? pow(fast, static_cast<int>(exponent.get_num().get_si()))
                                        : pow(fast, exponent);
      EXPECT_TRUE(value.is_within(expected.interval())) << exponent << to_string(x);
      const Oracle member(random_member(random, x));
      Oracle exact;
      mpfr_rootn_ui(exact.get(), member.get(), exponent.get_den().get_ui(), MPFR_RNDN);
      mpfr_pow_si(exact.get(), exact.get(), exponent.get_num().get_si(), MPFR_RNDN);
      if (!is_number(exact)) continue;
      // The root is rounded, if to many digits: the value lies in the range or beside it.
      const Range around = value + Range(value.outward()) * Range(Interval(-0x1p-900, 0x1p-900));
      EXPECT_TRUE(holds(value, exact) || holds(around, exact)) << exponent << to_string(x);
      if (holds(Range(z), exact)) {
        EXPECT_TRUE(holds(project_power(Range(z), exponent, Range(x)), member)) << exponent << to_string(z);
      }
    }
  }
}

TEST(Projection, KeepsFactorsAndSmallerOperands) {
  Random random(fuzz_seed(), "verifier.factor");
  const NumberTraits<FastInterval>::Scope scope;
  for (std::size_t i = 0; i < fuzz_cases(20000); ++i) {
    const Interval z = random_interval(random);
    const Interval x = random_interval(random);
    const Interval y = random_interval(random);
    const Oracle a(random_member(random, x));
    const Oracle b(random_member(random, y));
    Oracle value;
    mpfr_mul(value.get(), a.get(), b.get(), MPFR_RNDN);
    const Range factor = project_factor(Range(z), Range(y), Range(x));
    if (holds(Range(z), value)) {
      EXPECT_TRUE(holds(factor, a)) << to_string(x) << to_string(y);
    }
    EXPECT_TRUE(
        factor.is_within(reverse_multiply(FastInterval(z), FastInterval(y), FastInterval(x)).interval()));
    mpfr_min(value.get(), a.get(), b.get(), MPFR_RNDN);
    const Range smaller = project_min(Range(z), Range(y), Range(x));
    if (holds(Range(z), value)) {
      EXPECT_TRUE(holds(smaller, a)) << to_string(x) << to_string(y);
    }
    EXPECT_TRUE(smaller.is_within(reverse_min(FastInterval(z), FastInterval(y), FastInterval(x)).interval()));
  }
}

TEST(Range, EmptyStaysEmpty) {
  const Range empty = Range::empty();
  for (const UnaryCase& f : kUnary) EXPECT_TRUE(f.range(empty).is_empty()) << f.name;
  for (const BinaryCase& f : kBinary) {
    EXPECT_TRUE(f.range(empty, Range(1.0)).is_empty()) << f.name;
    EXPECT_TRUE(f.range(Range(1.0), empty).is_empty()) << f.name;
  }
  EXPECT_TRUE(scaled(0, empty).is_empty());
  EXPECT_TRUE(power(empty, Rational(1, 2)).is_empty());
}

TEST(Range, NotANumberBreaksAnInvariant) {
  Range x(1.0);
  mpfr_set_nan(x.lower());
  EXPECT_ANY_THROW(static_cast<void>(x.is_empty()));
}

}  // namespace
}  // namespace gcslab::verifier
