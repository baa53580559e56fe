#include "interval/rational.h"

#include <gtest/gtest.h>
#include <limits>

#include "base/check.h"
#include "base/error.h"

namespace gcslab {
namespace {

TEST(RationalText, IsReadExactly) {
  EXPECT_EQ(rational_from_text("0.1"), Rational(1, 10));
  EXPECT_EQ(rational_from_text("1e-3"), Rational(1, 1000));
  EXPECT_EQ(rational_from_text("2.50E+2"), Rational(250));
  EXPECT_EQ(rational_from_text("3/4"), Rational(3, 4));
  EXPECT_EQ(rational_from_text("-6/8"), Rational(-3, 4));
  EXPECT_EQ(rational_from_text("+.5"), Rational(1, 2));
  EXPECT_EQ(rational_from_text("-7."), Rational(-7));
  EXPECT_EQ(rational_from_text("0.5/0.25"), Rational(2));
  EXPECT_EQ(rational_from_text("123456789012345678901234567890"), Rational("123456789012345678901234567890"));
}

TEST(RationalText, ThatIsNoNumberIsRefused) {
  for (const char* text : {"", "-", ".", "e5", "1e", "1e+", "1e+-2", "--3", "0x10", "1/", "/2", "1/-2", " 1",
                           "1 ", "inf", "nan", "1.2.3", "1e5.5", "1,5"}) {
    EXPECT_THROW(rational_from_text(text), InputError) << "'" << text << "'";
  }
}

TEST(RationalText, ThatNoComputationCanUseIsRefused) {
  EXPECT_THROW(rational_from_text("1/0"), InputError);
  EXPECT_THROW(rational_from_text("1e1000000000"), InputError);
  EXPECT_THROW(rational_from_text("1e99999999999999999999"), InputError);
  EXPECT_NO_THROW(rational_from_text("1e-9999"));
}

TEST(RationalAndDouble, ConvertExactlyOrToNearest) {
  EXPECT_EQ(rational_from_double(0.75), Rational(3, 4));
  EXPECT_NE(rational_from_double(0.1), Rational(1, 10));
  EXPECT_EQ(nearest_double(Rational(1, 10)), 0.1);
  EXPECT_EQ(nearest_double(Rational(1, 3)), 1.0 / 3.0);
  EXPECT_EQ(nearest_double(rational_from_text("1e400")), std::numeric_limits<double>::max());
  EXPECT_EQ(nearest_double(rational_from_text("-1e400")), -std::numeric_limits<double>::max());
  EXPECT_THROW(rational_from_double(std::numeric_limits<double>::infinity()), InvariantError);
}

TEST(RationalAndDouble, NearestRoundsTiesToEvenAlsoAmongSubnormals) {
  const Rational ulp = rational_from_double(0x1p-52);
  EXPECT_EQ(nearest_double(1 + ulp / 2), 1);
  EXPECT_EQ(nearest_double(1 + 3 * ulp / 2), 1 + 0x1p-51);
  EXPECT_EQ(nearest_double(1 + ulp / 2 + rational_from_double(0x1p-200)), 1 + 0x1p-52);
  const Rational smallest = rational_from_double(std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(nearest_double(smallest / 2), 0);
  EXPECT_EQ(nearest_double(smallest * 3 / 2), 2 * std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(nearest_double(smallest * 5 / 8), std::numeric_limits<double>::denorm_min());
}

}  // namespace
}  // namespace gcslab
