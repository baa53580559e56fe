#include "univariate/sign_variations.h"

#include <algorithm>

namespace gcslab {
namespace {

/// The most changes of a sequence that ends, zeros left out, with a positive and with a negative number.
/// Below 0: there is no such sequence.
struct MostChanges {
  int positive = kNone;
  int negative = kNone;
  static constexpr int kNone = -1'000'000'000;

  void extend(double lower, double upper) {
    const int to_positive = std::max({positive, negative + 1, is_start() ? 0 : kNone});
    const int to_negative = std::max({negative, positive + 1, is_start() ? 0 : kNone});
    const bool may_vanish = lower <= 0 && upper >= 0;
    positive = upper > 0 ? to_positive : may_vanish ? positive : kNone;
    negative = lower < 0 ? to_negative : may_vanish ? negative : kNone;
    has_sign = has_sign || !may_vanish;
  }
  /// Whether all numbers so far may be 0.
  bool is_start() const { return !has_sign; }
  bool has_sign = false;
};

}  // namespace

SignVariations sign_variations(std::span<const FastInterval> numbers) {
  MostChanges most;
  int least = 0;
  int last = 0;
  for (const FastInterval& number : numbers) {
    const double lower = number.lower();
    const double upper = number.upper();
    most.extend(lower, upper);
    const int sign = lower > 0 ? 1 : upper < 0 ? -1 : 0;
    if (sign == 0) continue;
    if (last == -sign) ++least;
    last = sign;
  }
  return {least, std::max({most.positive, most.negative, 0})};
}

}  // namespace gcslab
