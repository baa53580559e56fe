#include "interval/rounding.h"

#include <gtest/gtest.h>
#include <limits>

#include "interval/rounding_self_test.h"

namespace gcslab {
namespace {

TEST(RoundingScopes, SetTheModeAndRestoreIt) {
  ASSERT_TRUE(rounding_is_nearest());
  {
    const UpwardRounding upward;
    EXPECT_EQ(rounding_mode(), RoundingMode::upward);
    EXPECT_EQ(rounded_divide(1, 3), 0x1.5555555555556p-2);
    {
      const NearestRounding nearest;
      EXPECT_TRUE(rounding_is_nearest());
      const UpwardRounding again;
      EXPECT_EQ(rounding_mode(), RoundingMode::upward);
    }
    EXPECT_EQ(rounding_mode(), RoundingMode::upward);
    const UpwardRounding nested;
    EXPECT_EQ(rounding_mode(), RoundingMode::upward);
  }
  EXPECT_TRUE(rounding_is_nearest());
}

TEST(RoundingScopes, RestoreTheModeWhenLeftByAnException) {
  try {
    const UpwardRounding upward;
    throw 1;
  } catch (int) {
  }
  EXPECT_TRUE(rounding_is_nearest());
}

TEST(RoundingScopes, KeepSubnormalNumbers) {
  const std::uint32_t saved = rounding_detail::read_control();
  rounding_detail::write_control(saved | rounding_detail::kFlushToZero | rounding_detail::kDenormalsAreZero);
  double tiny = 0;
  {
    const UpwardRounding upward;
    tiny = rounded_multiply(0x1p-1074, 0.5);
  }
  rounding_detail::write_control(saved);
  EXPECT_EQ(tiny, std::numeric_limits<double>::denorm_min());
}

TEST(RoundingScopes, SeparateEqualOperations) {
  double up = 0;
  double nearest = rounded_divide(1, 3);
  {
    const UpwardRounding upward;
    up = rounded_divide(1, 3);
  }
  const double after = rounded_divide(1, 3);
  EXPECT_LT(nearest, up);
  EXPECT_EQ(nearest, after);
}

TEST(RoundingSelfTest, PassesInAnyMode) {
  EXPECT_NO_THROW(check_rounding());
  const UpwardRounding upward;
  EXPECT_NO_THROW(check_rounding());
}

}  // namespace
}  // namespace gcslab
