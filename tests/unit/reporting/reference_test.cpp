#include "experiments/reporting/reference.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "experiments/reporting/report_context.h"
#include "unit/reporting/sample_rows.h"

namespace gcslab {
namespace {

std::string text_of(std::vector<Row> rows) { return rows_text(sample_context(std::move(rows))); }

TEST(Reference, EqualCountsAgreeWhateverTheTimes) {
  const std::string now = text_of({sample_row("p", "m", 5, 0.004), sample_row("q", "m", 6, 0.001)});
  const std::string then = text_of({sample_row("p", "m", 5, 0.001), sample_row("q", "m", 6, 0.001)});
  const Comparison comparison = compare_rows(now, then);
  EXPECT_TRUE(comparison.agrees());
  EXPECT_EQ(comparison.equal_rows, 2U);
  ASSERT_EQ(comparison.timings.size(), 1U);
  EXPECT_DOUBLE_EQ(comparison.timings[0].geometric_mean, 2);
  EXPECT_DOUBLE_EQ(comparison.timings[0].greatest, 4);
  EXPECT_EQ(comparison.timings[0].greatest_place, "p, m, depth 8, seed 1");
  EXPECT_EQ(verdict_of(comparison).state, Verdict::State::equal);
}

TEST(Reference, EveryDifferentValueIsNamed) {
  Row now = sample_row("p", "m", 5, 1);
  Row then = sample_row("p", "m", 6, 1);
  now.values["lower"] = "1/3";
  then.values["visited"] = {1, 4};
  const Comparison comparison = compare_rows(text_of({now}), text_of({then}));
  EXPECT_FALSE(comparison.agrees());
  EXPECT_EQ(comparison.differences,
            (std::vector<std::string>{"p, m, depth 8, seed 1: kept_cells was 6, is 5",
                                      "p, m, depth 8, seed 1: visited was [1,4], is absent",
                                      "p, m, depth 8, seed 1: lower was absent, is \"1/3\""}));
  EXPECT_EQ(comparison.equal_rows, 0U);
}

TEST(Reference, OutcomesAreComparedExactly) {
  const Row row = sample_row("p", "m", 5, 1);
  const Comparison comparison =
      compare_rows(text_of({with_outcome(row, "crashed", "SIGSEGV")}), text_of({row}));
  EXPECT_EQ(comparison.differences,
            std::vector<std::string>{"p, m, depth 8, seed 1: outcome was complete, is crashed (SIGSEGV)"});
}

TEST(Reference, HowFarARowGotThatRanOutOfTimeIsNotCompared) {
  const auto ended_by = [](const std::string& reason, int kept) {
    Row row = sample_row("p", "m", kept, 1);
    row.status = "budget_exhausted";
    row.reason = reason;
    return text_of({row});
  };
  EXPECT_TRUE(compare_rows(ended_by("wall limit of 30 s, stopped by force", 5),
                           ended_by("wall limit of 30 s: boxes were left", 6))
                  .agrees());
  EXPECT_FALSE(compare_rows(ended_by("maximum_boxes of 10", 5), ended_by("maximum_boxes of 10", 6)).agrees());
  EXPECT_FALSE(
      compare_rows(ended_by("wall limit of 30 s", 5), text_of({sample_row("p", "m", 5, 1)})).agrees());
}

TEST(Reference, RowsThatAreGoneFailAndNewOnesDoNot) {
  const Row a = sample_row("a", "m", 1, 1);
  const Row b = sample_row("b", "m", 1, 1);
  const Comparison gone = compare_rows(text_of({a}), text_of({a, b}));
  EXPECT_EQ(gone.missing, std::vector<std::string>{"b, m, depth 8, seed 1"});
  EXPECT_EQ(verdict_of(gone).state, Verdict::State::different);
  const Comparison added = compare_rows(text_of({a, b}), text_of({a}));
  EXPECT_EQ(added.added, std::vector<std::string>{"b, m, depth 8, seed 1"});
  EXPECT_EQ(verdict_of(added).state, Verdict::State::equal);
}

TEST(Reference, RowsHoldNoArtifactsAndNoDates) {
  Row row = sample_row("p", "m", 5, 1);
  row.artifact = {{"tree", "AAAA"}};
  row.provenance["started"] = "2024-01-01T00:00:00Z";
  const std::string text = text_of({row});
  EXPECT_EQ(text.find("AAAA"), std::string::npos);
  EXPECT_EQ(text.find("2024-01-01"), std::string::npos);
  EXPECT_EQ(Json::parse(text).at("rows").size(), 1U);
}

TEST(Reference, DamagedReferenceIsNamed) {
  EXPECT_THROW(compare_rows(text_of({}), "{\"rows\": 3}"), InputError);
}

}  // namespace
}  // namespace gcslab
