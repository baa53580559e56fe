#include "univariate/sign_variations.h"

#include <gtest/gtest.h>
#include <vector>

#include "base/random.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

int variations_of(const std::vector<int>& signs) {
  int changes = 0, last = 0;
  for (const int sign : signs) {
    if (sign * last < 0) ++changes;
    if (sign != 0) last = sign;
  }
  return changes;
}

/// Every choice of -1, 0 or 1 from each interval.
void choose(const std::vector<FastInterval>& numbers, std::vector<int>& chosen, int& least, int& most) {
  if (chosen.size() == numbers.size()) {
    least = std::min(least, variations_of(chosen));
    most = std::max(most, variations_of(chosen));
    return;
  }
  for (int sign = -1; sign <= 1; ++sign) {
    if (!contains(numbers[chosen.size()].interval(), sign)) continue;
    chosen.push_back(sign);
    choose(numbers, chosen, least, most);
    chosen.pop_back();
  }
}

TEST(SignVariations, AreTheLeastAndTheMostOfAllChoices) {
  Random random(fuzz_seed(), "sign_variations");
  for (std::size_t i = 0; i < fuzz_cases(2000); ++i) {
    std::vector<FastInterval> numbers;
    const auto length = random.below(7) + 1;
    for (std::size_t k = 0; k < length; ++k) {
      const auto lower = random.integer(-1, 1);
      numbers.emplace_back(static_cast<double>(lower), static_cast<double>(random.integer(lower, 1)));
    }
    int least = 100, most = 0;
    std::vector<int> chosen;
    choose(numbers, chosen, least, most);
    const SignVariations found = sign_variations(numbers);
    EXPECT_EQ(found.least, least);
    EXPECT_EQ(found.most, most);
  }
}

}  // namespace
}  // namespace gcslab
