// The record of a search tiles the search box, tells the same whatever the threads, and changes nothing.

#include "box_solver/search_record.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "box_solver/contractor_registry.h"
#include "box_solver/search.h"
#include "interval/rational.h"
#include "support/planted_system.h"

namespace gcslab {
namespace {

using planted::system_of;

ContractorMaker maker(const std::string& composition) {
  return [composition](const SystemFunctions& functions, int bits) {
    ContractorSettings settings;
    if (bits > 53) settings = {.arithmetic = Arithmetic::mpfr, .bits = bits};
    return make_contractor(composition, functions, settings);
  };
}

struct Recorded {
  SearchResult result;
  SearchRecord record;
};

Recorded recorded(const SystemFunctions& functions, const Box& box, const std::string& composition,
                  int threads = 1, std::size_t limit = 100'000) {
  Recorded search_of{{}, SearchRecord(limit)};
  SearchOptions options;
  options.threads = threads;
  options.record = &search_of.record;
  search_of.result = search(functions, box, {{box}}, maker(composition), options);
  return search_of;
}

Rational area(const Box& box) {
  Rational result = 1;
  for (const Interval& side : box) result *= Rational(side.upper) - Rational(side.lower);
  return result;
}

const Box kSquare = {{-3, 3}, {-3, 3}};

SystemFunctions two_ellipses() {
  return SystemFunctions(system_of({"x", "y"}, {"x^2/4 + y^2 - 1", "x^2 + y^2/4 - 1"}));
}

class SearchRecordOf : public testing::TestWithParam<std::string> {};

/// Every point is in the part that a reduction took off one box, or in what is left of a box that was not
/// cut: as exact areas, since boxes share borders only.
TEST_P(SearchRecordOf, TilesTheSearchBox) {
  const Recorded found = recorded(two_ellipses(), kSquare, GetParam());
  Rational covered = 0;
  for (const RecordedBox& box : found.record.boxes()) {
    for (std::size_t i = 0; i + 1 < box.stages.size(); ++i) {
      for (std::size_t k = 0; k < 2; ++k) EXPECT_TRUE(subset(box.stages[i + 1][k], box.stages[i][k]));
    }
    covered += area(box.taken()) - area(box.left());
    if (box.fate != BoxFate::cut) covered += area(box.left());
  }
  EXPECT_EQ(covered, area(kSquare));
}

TEST_P(SearchRecordOf, TellsEveryBoxAndChangesNothing) {
  const SystemFunctions functions = two_ellipses();
  const Recorded found = recorded(functions, kSquare, GetParam());
  const SearchResult plain = search(functions, kSquare, {{kSquare}}, maker(GetParam()), {});
  EXPECT_EQ(found.record.told(), plain.statistics.boxes);
  EXPECT_EQ(found.result.statistics.boxes, plain.statistics.boxes);
  EXPECT_EQ(found.result.statistics.bisections, plain.statistics.bisections);
  ASSERT_EQ(found.result.solutions.size(), plain.solutions.size());
  for (std::size_t i = 0; i < plain.solutions.size(); ++i)
    EXPECT_EQ(found.result.solutions[i].root.box, plain.solutions[i].root.box);
  const auto count = [&](BoxFate fate) {
    return static_cast<std::uint64_t>(std::ranges::count(found.record.boxes(), fate, &RecordedBox::fate));
  };
  EXPECT_EQ(count(BoxFate::cut), plain.statistics.bisections);
  EXPECT_EQ(count(BoxFate::pending), 0U);
  EXPECT_LE(count(BoxFate::root), 4U);
}

INSTANTIATE_TEST_SUITE_P(
    Compositions, SearchRecordOf,
    testing::Values("newton", "lp_reduction", "bernstein_projection", "hull",
                    "hull+multipliers+adaptive_constructive_disjunction?+lp_reduction?"));

TEST(SearchRecord, DoesNotDependOnThreads) {
  const SystemFunctions functions = two_ellipses();
  const Recorded one = recorded(functions, kSquare, "newton", 1);
  const Recorded two = recorded(functions, kSquare, "newton", 2);
  ASSERT_EQ(one.record.boxes().size(), two.record.boxes().size());
  for (std::size_t i = 0; i < one.record.boxes().size(); ++i) {
    EXPECT_EQ(one.record.boxes()[i].stages, two.record.boxes()[i].stages);
    EXPECT_EQ(one.record.boxes()[i].fate, two.record.boxes()[i].fate);
  }
}

TEST(SearchRecord, KeepsTheFirstBoxesUpToItsLimit) {
  const SystemFunctions functions = two_ellipses();
  const Recorded whole = recorded(functions, kSquare, "newton");
  const Recorded part = recorded(functions, kSquare, "newton", 1, 5);
  ASSERT_EQ(part.record.boxes().size(), 5U);
  EXPECT_FALSE(part.record.is_whole());
  EXPECT_EQ(part.record.told(), whole.record.told());
  EXPECT_EQ(part.record.boxes()[4].stages, whole.record.boxes()[4].stages);
}

TEST(SearchRecord, SaysWhatWasNotSearched) {
  const SystemFunctions functions = two_ellipses();
  SearchRecord record(100);
  SearchOptions options;
  options.record = &record;
  options.maximum_boxes = 1;
  const SearchResult result = search(functions, kSquare, {{kSquare}}, maker("newton"), options);
  ASSERT_EQ(result.pending.size(), 2U);
  EXPECT_EQ(std::ranges::count(record.boxes(), BoxFate::pending, &RecordedBox::fate), 2);
}

TEST(SearchRecord, NamesTheArgumentThatEmptiedABox) {
  const SystemFunctions functions(system_of({"x", "y"}, {"x^2 + y^2 - 1", "(x - 3)^2 + y^2 - 1"}));
  const Box box = {{-4, 4}, {-4, 4}};
  const Recorded found = recorded(functions, box, "lp_reduction");
  ASSERT_EQ(found.record.boxes().size(), 1U);
  const RecordedBox& whole = found.record.boxes().front();
  EXPECT_EQ(whole.fate, BoxFate::empty);
  EXPECT_EQ(whole.reason, Argument::polytope);
  EXPECT_EQ(name_of(whole.reason), "polytope");
  EXPECT_GE(whole.reductions, 1);
}

TEST(Stages, AreTheRoundsOutsideOfCases) {
  const Box box = {{0, 8}, {0, 8}};
  const auto narrow = [](std::uint32_t variable, Interval side) {
    return ProofStep{Argument::mean_value_row, 0, variable, side};
  };
  const std::vector<ProofStep> steps = {
      {Argument::expansion},
      narrow(0, {0, 6}),
      narrow(1, {1, 6}),
      {Argument::expansion},
      {Argument::cases, 0, 0, Interval(2)},  // [0, 2] and [2, 6] in x
      {Argument::expansion},
      narrow(0, Interval::empty()),
      {Argument::otherwise},
      narrow(1, {2, 3}),
      {Argument::join},
  };
  EXPECT_EQ(stages_of(box, steps), (std::vector<Box>{box, {{0, 6}, {1, 6}}, {{2, 6}, {2, 3}}}));
}

TEST(BoxFate, NamesAreReadBack) {
  for (const BoxFate fate :
       {BoxFate::empty, BoxFate::root, BoxFate::covered, BoxFate::cut, BoxFate::undecided, BoxFate::pending})
    EXPECT_EQ(box_fate_from_name(name_of(fate)), fate);
  EXPECT_THROW(box_fate_from_name("lost"), InputError);
}

}  // namespace
}  // namespace gcslab
