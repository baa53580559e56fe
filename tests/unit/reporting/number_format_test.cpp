#include "experiments/reporting/number_format.h"

#include <cmath>
#include <gtest/gtest.h>

namespace gcslab {
namespace {

TEST(NumberFormat, CountsHaveSeparators) {
  EXPECT_EQ(format_count(0), "0");
  EXPECT_EQ(format_count(999), "999");
  EXPECT_EQ(format_count(1000), "1,000");
  EXPECT_EQ(format_count(1234567), "1,234,567");
  EXPECT_EQ(format_count(-123456), "-123,456");
}

TEST(NumberFormat, SignificantDigitsNeverRoundWholePartsAway) {
  EXPECT_EQ(format_significant(0.012345, 3), "0.0123");
  EXPECT_EQ(format_significant(1.5, 3), "1.50");
  EXPECT_EQ(format_significant(9.996, 3), "10.0");
  EXPECT_EQ(format_significant(12345.6, 3), "12,346");
  EXPECT_EQ(format_significant(-2.345, 2), "-2.3");
}

TEST(NumberFormat, ExtremesArePowersOfTen) {
  EXPECT_EQ(format_significant(1.234e-12, 3), "1.23×10⁻¹²");
  EXPECT_EQ(format_significant(2e15, 2), "2.0×10¹⁵");
  EXPECT_EQ(format_number(INFINITY), "inf");
  EXPECT_EQ(format_number(NAN), "nan");
}

TEST(NumberFormat, OneUnitForAllTimes) {
  EXPECT_EQ(scale_for("s", {0.0012, 0.5, 0.002}).unit, "ms");
  EXPECT_EQ(scale_for("s", {3, 20}).unit, "s");
  EXPECT_EQ(scale_for("s", {4e-6}).unit, "µs");
  EXPECT_EQ(scale_for("s", {4e-9}).factor, 1e9);
  EXPECT_EQ(scale_for("s", {}).unit, "s");
  EXPECT_EQ(scale_for("MB", {1e-9}).unit, "MB");
}

}  // namespace
}  // namespace gcslab
