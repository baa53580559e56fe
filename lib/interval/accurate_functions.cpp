#include "interval/accurate_functions.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <mpfr.h>

namespace gcslab::elementary {
namespace {

// Below, u = 2^-52 bounds the relative error of one operation in any rounding mode, away from underflow.

/// An unevaluated sum of two doubles.
struct Pair {
  double high = 0;
  double low = 0;
};

/// a + b with error below 4 u^2 |a + b|, in any rounding mode (2Sum; Graillat, Jezequel, Picot 2018; Boldo,
/// Graillat, Muller 2017, "On the robustness of the 2Sum and Fast2Sum algorithms").
Pair sum(double a, double b) {
  const double s = a + b;
  const double b_in_s = s - a;
  const double a_in_s = s - b_in_s;
  return {s, (a - a_in_s) + (b - b_in_s)};
}

/// a * b exactly: the error of a product is a double.
Pair product(double a, double b) {
  const double p = a * b;
  return {p, std::fma(a, b, -p)};
}

/// c_0 + c_1 x + ... + c_n x^n by Horner's rule.
template <std::size_t size>
double polynomial(const std::array<double, size>& coefficients, double x) {
  double value = coefficients[size - 1];
  for (std::size_t i = size - 1; i-- > 0;) value = coefficients[i] + x * value;
  return value;
}

// Taylor coefficients; constexpr, as directed rounding keeps the compiler from dividing constants elsewhere.
constexpr std::array kExpFromQuadratic = {1.0 / 2, 1.0 / 6, 1.0 / 24, 1.0 / 120, 1.0 / 720, 1.0 / 5040};
constexpr std::array kLogFromCubic = {1.0 / 3, -1.0 / 4, 1.0 / 5, -1.0 / 6, 1.0 / 7, -1.0 / 8, 1.0 / 9};
constexpr std::array kSineFromCubic = {-1.0 / 6, 1.0 / 120, -1.0 / 5040, 1.0 / 362880};
constexpr std::array kCosineFromQuadratic = {-1.0 / 2, 1.0 / 24, -1.0 / 720, 1.0 / 40320};
constexpr std::array kAtanFromCubic = {-1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9};

/// The nearest integer, or its neighbour when near a half; in any rounding mode.
double whole(double x) { return std::floor(x + 0.5); }

/// An MPFR number of 300 bits while a table is filled.
class Wide {
 public:
  Wide() { mpfr_init2(value_, 300); }
  ~Wide() { mpfr_clear(value_); }
  Wide(const Wide&) = delete;
  Wide& operator=(const Wide&) = delete;
  mpfr_ptr get() { return value_; }

  /// The nearest double, whose low `dropped` bits are 0, taken off the value.
  double split(int dropped = 0) {
    mpfr_t part;
    mpfr_init2(part, 53 - dropped);
    mpfr_set(part, value_, MPFR_RNDN);
    const double result = mpfr_get_d(part, MPFR_RNDN);
    mpfr_sub(value_, value_, part, MPFR_RNDN);
    mpfr_clear(part);
    return result;
  }

  /// The value to 2^-106 of itself.
  Pair pair() {
    const double high = split();
    return {high, split()};
  }

 private:
  mpfr_t value_;
};

constexpr int kExpSteps = 64;
constexpr int kLogSteps = 128;
constexpr int kSinSteps = 256;  // of the full circle
constexpr int kAtanSteps = 64;

struct Tables {
  std::array<Pair, kExpSteps> power_of_two;       // 2^(i / 64)
  std::array<double, kLogSteps> reciprocal;       // near 128 / (128 + i + 1/2), or half of it; 9 bits
  std::array<Pair, kLogSteps> log_of_reciprocal;  // -log of it
  std::array<Pair, kSinSteps> sine;               // sin(i pi / 128)
  std::array<Pair, kAtanSteps + 1> arctangent;    // atan(i / 64)
  double exp_step[2];                             // log(2) / 64 in 36 bits, and the rest
  double exp_steps_in_one;                        // 64 / log(2)
  double log_two[2];                              // log(2) in 42 bits, and the rest
  double sin_step[3];                             // pi / 128 in 33 bits, 33 bits, and the rest
  double sin_steps_in_one;                        // 128 / pi
  Pair half_pi;

  Tables();

 private:
  void fill_exp();
  void fill_log();
  void fill_sin();
  void fill_atan();
};

Tables::Tables() {
  fill_exp();
  fill_log();
  fill_sin();
  fill_atan();
}

void Tables::fill_exp() {
  Wide value;
  for (int i = 0; i < kExpSteps; ++i) {
    mpfr_set_d(value.get(), static_cast<double>(i) / kExpSteps, MPFR_RNDN);
    mpfr_exp2(value.get(), value.get(), MPFR_RNDN);
    power_of_two[static_cast<std::size_t>(i)] = value.pair();
  }
  mpfr_const_log2(value.get(), MPFR_RNDN);
  mpfr_ui_div(value.get(), kExpSteps, value.get(), MPFR_RNDN);
  exp_steps_in_one = mpfr_get_d(value.get(), MPFR_RNDN);
  mpfr_const_log2(value.get(), MPFR_RNDN);
  mpfr_div_ui(value.get(), value.get(), kExpSteps, MPFR_RNDN);
  exp_step[0] = value.split(53 - 36);
  exp_step[1] = value.split();
}

void Tables::fill_log() {
  Wide value;
  for (int i = 0; i < kLogSteps; ++i) {
    const bool halved =
        i >= kLogSteps * 2 / 5;  // mantissas above 1.4 are halved, and one more taken into the exponent
    const double centre = (1 + (i + 0.5) / kLogSteps) / (halved ? 2 : 1);
    const bool at_one =
        i == 0 || i == kLogSteps - 1;  // there the mantissa's logarithm is computed to relative accuracy
    const double near = at_one ? 1 : whole(512 / centre) / 512;
    reciprocal[static_cast<std::size_t>(i)] = near;
    mpfr_set_d(value.get(), near, MPFR_RNDN);
    mpfr_log(value.get(), value.get(), MPFR_RNDN);
    mpfr_neg(value.get(), value.get(), MPFR_RNDN);
    log_of_reciprocal[static_cast<std::size_t>(i)] = at_one ? Pair() : value.pair();
  }
  mpfr_const_log2(value.get(), MPFR_RNDN);
  log_two[0] = value.split(53 - 42);
  log_two[1] = value.split();
}

void Tables::fill_sin() {
  Wide value;
  for (int i = 0; i < kSinSteps; ++i) {
    mpfr_const_pi(value.get(), MPFR_RNDN);
    mpfr_mul_ui(value.get(), value.get(), static_cast<unsigned long>(i), MPFR_RNDN);
    mpfr_div_ui(value.get(), value.get(), kSinSteps / 2, MPFR_RNDN);
    mpfr_sin(value.get(), value.get(), MPFR_RNDN);
    sine[static_cast<std::size_t>(i)] = i % (kSinSteps / 2) == 0 ? Pair() : value.pair();
  }
  mpfr_const_pi(value.get(), MPFR_RNDN);
  mpfr_ui_div(value.get(), kSinSteps / 2, value.get(), MPFR_RNDN);
  sin_steps_in_one = mpfr_get_d(value.get(), MPFR_RNDN);
  mpfr_const_pi(value.get(), MPFR_RNDN);
  mpfr_div_ui(value.get(), value.get(), kSinSteps / 2, MPFR_RNDN);
  sin_step[0] = value.split(53 - 33);
  sin_step[1] = value.split(53 - 33);
  sin_step[2] = value.split();
}

void Tables::fill_atan() {
  Wide value;
  for (int i = 0; i <= kAtanSteps; ++i) {
    mpfr_set_d(value.get(), static_cast<double>(i) / kAtanSteps, MPFR_RNDN);
    mpfr_atan(value.get(), value.get(), MPFR_RNDN);
    arctangent[static_cast<std::size_t>(i)] = value.pair();
  }
  mpfr_const_pi(value.get(), MPFR_RNDN);
  mpfr_div_ui(value.get(), value.get(), 2, MPFR_RNDN);
  half_pi = value.pair();
}

const Tables& tables() {
  static const Tables filled;
  return filled;
}

double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52U);
}

/// An angle less the nearest multiple of pi / 128: x = k pi / 128 + r.
struct ReducedAngle {
  int k = 0;  // modulo 256
  Pair r;
  double error = 0;  // of r
};

/// For |x| < 25000, k < 2^20. The first two products are exact (20 + 33 bits), and so is the first
/// difference: both its sides are multiples of ulp(x) >= 2^-59 and it is below 2^-6.3. The third product is
/// below 2^-52, its error and that of the last difference below 2^-102, and with k = 0 all is exact.
ReducedAngle reduced(double x) {
  const Tables& t = tables();
  const double k = whole(x * t.sin_steps_in_one);
  if (k == 0) return {0, {x, 0}, 0};
  const Pair near = sum(x - k * t.sin_step[0], -(k * t.sin_step[1]));
  const double low = near.low - k * t.sin_step[2];
  return {static_cast<int>(static_cast<std::int64_t>(k) & (kSinSteps - 1)), {near.high, low}, 0x1p-100};
}

/// sin(j pi/128 + r), |r| < pi/256 + 2^-20, from S = sin(j pi/128), C = cos(j pi/128):
///   S + C r + S (cos r - 1) + C (sin r - r).
/// |cos r - 1| < 2^-13.7 carries 6 u: 2^-63.1 of S. |sin r - r| < 2^-21.5 carries 10 u: 2^-70.1, and 2^-63.9
/// of r. Where j is no multiple of 128 the value is at least S/2 and 2^-6.4, so that these are 2^-62.1 and
/// 2^-63.7 of it; the last sum of the low part adds 2^-64.7, the omitted product of S's low part 2^-65.7.
/// Where j is such a multiple, S is 0, C is +-1, the value is near r; r's low part, below 2^-52, may cancel
/// most of its high part, and three roundings of it add less than 2^-102, which r's error has to spare. All
/// together stay below 2^-61.3; claimed: 2^-61 of the value, and r's error.
AccurateValue sine_of(const ReducedAngle& angle, int quarter_turns) {
  const Tables& t = tables();
  const int j = (angle.k + quarter_turns * (kSinSteps / 4)) & (kSinSteps - 1);
  const Pair S = t.sine[static_cast<std::size_t>(j)];
  const Pair C = t.sine[static_cast<std::size_t>((j + kSinSteps / 4) & (kSinSteps - 1))];
  const double r = angle.r.high + angle.r.low;
  const double r2 = r * r;
  const double cosine_less_one = r2 * polynomial(kCosineFromQuadratic, r2);
  const double sine_less_r = r * r2 * polynomial(kSineFromCubic, r2);
  const Pair linear = product(C.high, angle.r.high);
  const Pair main = sum(S.high, linear.high);
  const double low = S.high * cosine_less_one + (C.high * (angle.r.low + sine_less_r) +
                                                 (C.low * angle.r.high + (linear.low + (S.low + main.low))));
  return {true, main.high, low, 0x1p-61 * std::fabs(main.high + low) + angle.error};
}

constexpr double kLargestAngle = 25000;

/// Whether the argument is neither so small that the bounds on underflow fail nor beyond the reduction.
bool is_moderate(double x, double largest) { return std::fabs(x) >= 0x1p-100 && std::fabs(x) <= largest; }

}  // namespace

/// exp(x) = 2^m 2^(i/64) e^r, x = (64 m + i) log(2)/64 + r, |r| < 2^-7.5. k = 64 m + i has 16 bits, so that k
/// times the step's high part and its difference from x are exact; r_low < 2^-27 has an error below 2^-78.
/// The terms of e^r from the quadratic on are below 2^-16 and carry 6 u, so 2^-65.4, and r^8/8! < 2^-75 is
/// omitted. With T = 2^(i/64) < 2 the sums of the low part, below 2^-15, add 4 u of it. All together stay
/// below 2^-63; claimed: 2^-62, of a value above 0.99.
AccurateValue accurate_exp(double x) {
  if (!is_moderate(x, 600)) return {};
  const Tables& t = tables();
  const double k = whole(x * t.exp_steps_in_one);
  const double r_high = x - k * t.exp_step[0];
  const double r_low = -(k * t.exp_step[1]);
  const double r = r_high + r_low;
  const double series = r * r * polynomial(kExpFromQuadratic, r);
  const int steps = static_cast<int>(k);
  const Pair T = t.power_of_two[static_cast<std::size_t>(steps & (kExpSteps - 1))];
  const Pair linear = product(T.high, r_high);
  const Pair main = sum(T.high, linear.high);
  const double low = T.high * (r_low + series) + (T.low * r_high + (linear.low + (T.low + main.low)));
  const double scale = power_of_two((steps - (steps & (kExpSteps - 1))) / kExpSteps);
  return {true, main.high * scale, low * scale, 0x1p-62 * scale};
}

/// log(x) = e log(2) - log(c) + log(1 + r), x = 2^e m, r = c m - 1 exactly as h + r_low with c of 10 bits,
/// |r| <= 2^-7, |r_low| <= 2^-52. The quadratic term is an exact product; the terms from the cubic on are
/// below 2^-22 and carry 8 u, so 2^-71; the sums of the low part add about as much; r^10/10 < 2^-73 and h^3
/// r_low < 2^-73 are omitted. e times the high part of log(2) is exact. Where c is not 1 the value is 2^-8 or
/// more; where c is 1 and e is 0, r_low is 0 and all errors are in proportion to r: 2^-63. Claimed: 2^-61 of
/// the value.
AccurateValue accurate_log(double x) {
  if (!(x >= 0x1p-1000 && x <= 0x1p1000) || x == 1) return {};
  const Tables& t = tables();
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const std::size_t i = static_cast<std::size_t>((bits >> 45U) & (kLogSteps - 1));
  const bool halved = i >= kLogSteps * 2 / 5;
  const double e = static_cast<double>(static_cast<int>(bits >> 52U) - (halved ? 1022 : 1023));
  const std::uint64_t unit_exponent = halved ? 1022 : 1023;
  const double m = std::bit_cast<double>((bits & 0xfffffffffffffU) | (unit_exponent << 52U));
  const Pair scaled = product(m, t.reciprocal[i]);
  const Pair r = {scaled.high - 1, scaled.low};
  const double h = r.high;
  const Pair square = product(h, h);
  const double cubic = h * square.high * polynomial(kLogFromCubic, h);
  const Pair constant = sum(e * t.log_two[0], t.log_of_reciprocal[i].high);
  const Pair with_r = sum(constant.high, h);
  const Pair main = sum(with_r.high, -0.5 * square.high);
  const double constant_low = e * t.log_two[1] + (t.log_of_reciprocal[i].low + constant.low);
  const double series_low = r.low - r.low * (h - h * h) - 0.5 * square.low;
  const double low = cubic + ((constant_low + series_low) + (with_r.low + main.low));
  return {true, main.high, low, 0x1p-61 * std::fabs(main.high)};
}

AccurateValue accurate_sin(double x) {
  if (!is_moderate(x, kLargestAngle)) return {};
  return sine_of(reduced(x), 0);
}

AccurateValue accurate_cos(double x) {
  if (!is_moderate(x, kLargestAngle)) return {};
  return sine_of(reduced(x), 1);
}

/// The quotient of sine and cosine; the relative errors add up, and the division's own is below 2^-99.
AccurateValue accurate_tan(double x) {
  if (!is_moderate(x, kLargestAngle)) return {};
  const ReducedAngle angle = reduced(x);
  const AccurateValue sine = sine_of(angle, 0);
  const AccurateValue cosine = sine_of(angle, 1);
  const Pair n = sum(sine.high, sine.low);
  const Pair d = sum(cosine.high, cosine.low);
  const double quotient = n.high / d.high;
  const double remainder = std::fma(-quotient, d.high, n.high);
  const double low = (remainder + (n.low - quotient * d.low)) / d.high;
  const double relative = sine.error / std::fabs(n.high) + cosine.error / std::fabs(d.high);
  return {true, quotient, low, 1.25 * relative * std::fabs(quotient)};
}

/// With v = |x| and c = i/64 near v or 1/v: atan(v) = atan(c) + atan((v - c)/(1 + c v)) for v <= 1, and
/// pi/2 - atan(c) - atan((1/v - c)/(1 + c/v)) otherwise, where that quotient is (1 - c v)/(v + c). 1 - c v is
/// an exact pair (c v is 0, or between 0.6 and 2.1); the other sums have errors below 4 u^2. A plain v - c
/// would not do: for the double v before 1/128, 64 v + 1/2 rounds to 1, and v - 1/64 has 54 bits. The
/// quotient t, below 2^-6.9, has an error below 2^-98, of itself unless inverted. Its double q is within 4 u
/// |t| of t, or 2^-52 more if inverted, by the low part of c v. So the terms from the cubic on, below
/// 2^-22.2, carry 17 u: 2^-70, and 2^-63.2 of t, which is at most the value; or 2^-65 if inverted, when the
/// value is above pi/4. t^11/11 < 2^-79 is omitted; the sums of the low part add 2^-67 of the value. Claimed:
/// 2^-61 of the value.
AccurateValue accurate_atan(double x) {
  if (!is_moderate(x, 0x1p100)) return {};
  const Tables& t = tables();
  const double v = std::fabs(x);
  const bool inverted = v > 1;
  const double steps = whole((inverted ? 1 / v : v) * kAtanSteps);
  const double c = steps / kAtanSteps;
  const Pair cv = product(c, v);
  const Pair n = inverted ? Pair{1 - cv.high, -cv.low} : sum(v, -c);
  const Pair d = inverted ? sum(v, c) : sum(1, cv.high);
  const double d_low = inverted ? d.low : d.low + cv.low;
  const double q = n.high / d.high;
  const double q_low = (std::fma(-q, d.high, n.high) + (n.low - q * d_low)) / d.high;
  const double q2 = q * q;
  const double cubic = q * q2 * polynomial(kAtanFromCubic, q2);
  const Pair base = t.arctangent[static_cast<std::size_t>(steps)];
  const Pair angle = sum(base.high, q);
  const double angle_low = base.low + angle.low + q_low + cubic;
  const Pair main = inverted ? sum(t.half_pi.high, -angle.high) : angle;
  const double low = inverted ? (t.half_pi.low + main.low) - angle_low : angle_low;
  const double error = 0x1p-61 * std::fabs(main.high);
  return x > 0 ? AccurateValue{true, main.high, low, error} : AccurateValue{true, -main.high, -low, error};
}

}  // namespace gcslab::elementary
