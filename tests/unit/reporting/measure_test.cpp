#include "experiments/reporting/measure.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "base/error.h"
#include "unit/reporting/sample_rows.h"

namespace gcslab {
namespace {

TEST(Summary, MedianAndQuartilesInterpolate) {
  const Measure m = summarise({4, 1, 3, 2});
  EXPECT_EQ(m.median, 2.5);
  EXPECT_EQ(m.minimum, 1);
  EXPECT_EQ(m.maximum, 4);
  EXPECT_EQ(m.lower_quartile, 1.75);
  EXPECT_EQ(m.samples, 4U);
}

TEST(Summary, InfiniteSamplesStayOrdered) {
  const Measure m =
      summarise({1, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()});
  EXPECT_TRUE(std::isinf(m.median));
  EXPECT_EQ(m.minimum, 1);
}

TEST(ValueName, ReadsQuotients) {
  const ValueName value("wall_s/kept_cells");
  EXPECT_EQ(value.heading(), "wall time per kept cell");
  EXPECT_EQ(value.unit(), "s");
  EXPECT_TRUE(value.is_of_machine());
  EXPECT_FALSE(ValueName("kept_cells").is_of_machine());
  for (const char* bad : {"", "/x", "x/", "a/b/c"}) EXPECT_THROW(ValueName{bad}, InputError) << bad;
}

TEST(Samples, OneRowGivesItsRepetitionsDividedByItsOwnCount) {
  const Row row = sample_row("p", "m", 100, 2.0);
  EXPECT_EQ(samples_of(row, ValueName("wall_s/kept_cells")), (std::vector<double>{0.02, 0.03, 0.01}));
}

TEST(Measure, SeveralRowsGiveOneSampleEach) {
  const Row a = sample_row("p", "m", 10, 1, "8", "1");
  const Row b = sample_row("p", "m", 30, 3, "8", "2");
  const auto m = measure({&a, &b}, ValueName("wall_s"));
  ASSERT_TRUE(m);
  EXPECT_EQ(m->samples, 2U);
  EXPECT_EQ(m->median, 2);
}

TEST(Measure, ExactTextsKeepTheirTextAndTheirNumber) {
  Row row = sample_row("p", "m", 1, 1);
  row.values["lower"] = "-1/4";
  const auto m = measure({&row}, ValueName("lower"));
  ASSERT_TRUE(m);
  EXPECT_EQ(m->text, "-1/4");
  EXPECT_EQ(m->median, -0.25);
}

TEST(Measure, ListsAreTexts) {
  Row row = sample_row("p", "m", 1, 1);
  row.values["visited_per_level"] = {1, 4, 16};
  const auto m = measure({&row}, ValueName("visited_per_level"));
  ASSERT_TRUE(m);
  EXPECT_FALSE(m->is_number());
  EXPECT_EQ(m->text, "1, 4, 16");
}

TEST(Measure, OutcomesWithoutResultHaveNone) {
  const Row row = with_outcome(sample_row("p", "m", 1, 1), "crashed", "SIGSEGV");
  EXPECT_FALSE(measure({&row}, ValueName("kept_cells")));
}

}  // namespace
}  // namespace gcslab
