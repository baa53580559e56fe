// Random straight-line programs over shared variables, where affine arithmetic's noise symbols meet: every
// register of every rigorous type encloses the value at random points of the box, computed by MPFR intervals
// of 300 bits. For affine forms more is checked: with the variables' noise symbols fixed to that point, the
// band that the other symbols and the error leave still contains the value.

#include <array>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "interval/affine_form.h"
#include "interval/boost_interval.h"
#include "interval/fast_interval.h"
#include "interval/mpfr_interval.h"
#include "support/fuzz.h"
#include "support/random_interval.h"

namespace gcslab {
namespace {

constexpr int kTruthBits = 300;
constexpr std::size_t kVariables = 3;
constexpr std::size_t kSteps = 12;
constexpr std::uint64_t kOperations = 25;

struct Step {
  std::uint64_t operation;
  std::size_t left;
  std::size_t right;
};

struct Program {
  std::vector<Interval> box;
  std::vector<Rational> constants;
  std::vector<Step> steps;
};

template <class T>
T apply(std::uint64_t operation, const T& x, const T& y) {
  switch (operation) {
    case 0:
    case 1:
      return x + y;
    case 2:
    case 3:
      return x - y;
    case 4:
    case 5:
    case 6:
      return x * y;
    case 7:
      return x / y;
    case 8:
      return sqr(x);
    case 9:
      return pow(x, 3);
    case 10:
      return pow(x, 4);
    case 11:
      return pow(x, -2);
    case 12:
      return pow(x, Rational(2, 3));
    case 13:
      return sqrt(x);
    case 14:
      return cbrt(x);
    case 15:
      return exp(x);
    case 16:
      return log(x);
    case 17:
      return sin(x);
    case 18:
      return cos(x);
    case 19:
      return tan(x);
    case 20:
      return asin(x);
    case 21:
      return acos(x);
    case 22:
      return atan(x);
    case 23:
      return min(x, abs(y));
    default:
      return max(x, -y);
  }
}

Interval random_side(Random& random) {
  const double centre =
      random.below(3) == 0 ? static_cast<double>(random.integer(-3, 3)) : random.uniform(-4, 4);
  const double radius =
      random.below(6) == 0 ? 0 : std::ldexp(random.unit(), -static_cast<int>(random.below(12)));
  return {centre - radius, centre + radius};
}

Program random_program(Random& random) {
  Program program;
  for (std::size_t i = 0; i < kVariables; ++i) program.box.push_back(random_side(random));
  program.constants = {Rational(random.integer(-9, 9)) / 10, Rational(random.integer(-9, 9))};
  const std::size_t inputs = kVariables + program.constants.size();
  for (std::size_t i = 0; i < kSteps; ++i) {
    program.steps.push_back({random.below(kOperations), random.below(inputs + i), random.below(inputs + i)});
  }
  return program;
}

/// The variables, the constants, then the result of each step.
template <class T>
std::vector<T> registers_of(const Program& program, const std::vector<Interval>& box) {
  std::vector<T> registers;
  for (const Interval& side : box) registers.push_back(NumberTraits<T>::from_interval(side));
  for (const Rational& constant : program.constants) {
    registers.push_back(NumberTraits<T>::from_rational(constant));
  }
  for (const Step& step : program.steps) {
    registers.push_back(apply(step.operation, registers[step.left], registers[step.right]));
  }
  return registers;
}

std::vector<Interval> random_point(Random& random, const Program& program) {
  std::vector<Interval> point;
  for (const Interval& side : program.box) point.emplace_back(random_member(random, side));
  return point;
}

/// A true value known to 100 bits or more; others come from cancellation or from the border of a domain.
bool is_sharp(const MpfrInterval& truth) {
  if (truth.is_empty() || !mpfr_number_p(truth.lower()) || !mpfr_number_p(truth.upper())) return false;
  MpfrNumber width;
  mpfr_sub(width.get(), truth.upper(), truth.lower(), MPFR_RNDU);
  if (mpfr_zero_p(width.get())) return true;
  return !mpfr_zero_p(truth.lower()) && mpfr_get_exp(width.get()) < mpfr_get_exp(truth.lower()) - 100;
}

/// Which registers have sharp true values and rest on such alone.
std::vector<bool> sharp_registers(const Program& program, const std::vector<MpfrInterval>& truth) {
  std::vector<bool> sharp(truth.size(), true);
  const std::size_t inputs = truth.size() - program.steps.size();
  for (std::size_t i = 0; i < program.steps.size(); ++i) {
    const Step& step = program.steps[i];
    sharp[inputs + i] = sharp[step.left] && sharp[step.right] && is_sharp(truth[inputs + i]);
  }
  return sharp;
}

/// Whether the sharp true value may lie in [lower, upper]: it is not outside.
bool meets(const MpfrInterval& truth, const Interval& x) {
  return !is_empty(x) && mpfr_cmp_d(truth.upper(), x.lower) >= 0 && mpfr_cmp_d(truth.lower(), x.upper) <= 0;
}

template <class T>
bool holds_more(const T&, const MpfrInterval&, const Program&, const std::vector<Interval>&) {
  return true;
}

/// The affine sum with the variables' symbols fixed to those of the point.
template <Approximation approximation>
bool holds_more(const AffineForm<approximation>& form, const MpfrInterval& truth, const Program& program,
                const std::vector<Interval>& point) {
  const auto& sum = form.value().sum();
  if (!sum) return true;
  const auto exactly = [](double x) { return MpfrInterval(Interval(x)); };
  MpfrInterval band = exactly(sum->centre());
  MpfrInterval rest = exactly(sum->error());
  std::size_t symbol = 0;
  for (std::size_t i = 0; i < kVariables; ++i) {
    const Interval& side = program.box[i];
    if (is_singleton(side)) continue;
    const MpfrInterval offset = exactly(point[i].lower) - exactly(midpoint(side));
    band = band + exactly(sum->coefficient(symbol++)) * (offset / exactly(radius(side)));
  }
  for (; symbol < sum->symbols(); ++symbol) rest = rest + abs(exactly(sum->coefficient(symbol)));
  band = band + rest * MpfrInterval(Interval(-1, 1));
  return mpfr_lessequal_p(band.lower(), truth.upper()) && mpfr_lessequal_p(truth.lower(), band.upper());
}

/// Checks every register of one number type; returns how many were compared.
template <class T>
std::size_t check_registers(const Program& program, const std::vector<Interval>& point,
                            const std::vector<MpfrInterval>& truth, const std::vector<bool>& sharp,
                            const char* type) {
  const typename NumberTraits<T>::Scope scope;
  const std::vector<T> values = registers_of<T>(program, program.box);
  const NumberTraits<MpfrInterval>::Scope truth_scope(kTruthBits);
  std::size_t compared = 0;
  for (std::size_t r = 0; r < values.size(); ++r) {
    if (!sharp[r]) continue;
    ++compared;
    const Interval range = NumberTraits<T>::enclosure(values[r]);
    EXPECT_TRUE(meets(truth[r], range)) << type << ", register " << r << ": " << to_string(range)
                                        << " misses " << to_string(truth[r].interval());
    EXPECT_TRUE(holds_more(values[r], truth[r], program, point)) << type << ", register " << r;
  }
  return compared;
}

TEST(IntervalPrograms, EveryRegisterEnclosesTheTrueValueAtRandomPoints) {
  Random random(fuzz_seed(), "interval_programs");
  std::size_t compared = 0;  // a case is one register compared, in each type
  while (compared < fuzz_cases(200'000) && !HasFailure()) {
    const Program program = random_program(random);
    const std::vector<Interval> point = random_point(random, program);
    std::vector<MpfrInterval> truth;
    std::vector<bool> sharp;
    {
      const NumberTraits<MpfrInterval>::Scope scope(kTruthBits);
      truth = registers_of<MpfrInterval>(program, point);
      sharp = sharp_registers(program, truth);
    }
    check_registers<BoostInterval>(program, point, truth, sharp, "BoostInterval");
    check_registers<MpfrInterval>(program, point, truth, sharp, "MpfrInterval");
    check_registers<ChebyshevAffine>(program, point, truth, sharp, "ChebyshevAffine");
    check_registers<MinRangeAffine>(program, point, truth, sharp, "MinRangeAffine");
    compared += check_registers<FastInterval>(program, point, truth, sharp, "FastInterval");
  }
}

}  // namespace
}  // namespace gcslab
