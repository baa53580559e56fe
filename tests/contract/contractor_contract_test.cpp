// One suite for every registered contractor in every rigorous arithmetic: no solution of a box is lost, boxes
// only shrink, and the trace tells all that was done. Systems have planted solutions, known exactly: simple,
// double, clustered, in the interior, on sides and in corners; polynomial and not, square and not, with
// inequalities. A new contractor is tested without an edit here.

#include <gtest/gtest.h>
#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "box_solver/contractor_registry.h"
#include "support/fuzz.h"
#include "support/planted_system.h"
#include "support/replay.h"

namespace gcslab {
namespace {

using planted::PlantedGenerator;
using planted::PlantedSystem;
using planted::Point;

struct Choice {
  std::string contractor;
  Arithmetic arithmetic;
};

std::vector<Choice> choices() {
  std::vector<Choice> result;
  for (const std::string& name : contractor_registry().names()) {
    for (const Arithmetic arithmetic : kArithmetics) {
      if (promise_of(arithmetic) == Promise::rigorous) result.push_back({name, arithmetic});
    }
  }
  return result;
}

std::string name_of_choice(const testing::TestParamInfo<Choice>& info) {
  return info.param.contractor + "_" + std::string(name_of(info.param.arithmetic));
}

std::unique_ptr<Contractor> make(const Choice& choice, const SystemFunctions& functions) {
  ContractorSettings settings;
  settings.arithmetic = choice.arithmetic;
  settings.bits = choice.arithmetic == Arithmetic::mpfr ? 90 : 53;
  return contractor_registry().at(choice.contractor).make(functions, settings);
}

/// The same, or nothing with the reason checked when the contractor does not take the system.
std::unique_ptr<Contractor> make_if_applicable(const Choice& choice, const SystemFunctions& functions) {
  try {
    return make(choice, functions);
  } catch (const NotApplicable& refusal) {
    EXPECT_GT(std::string(refusal.what()).size(), 10U);
    return nullptr;
  }
}

std::vector<Point> members(const std::vector<Point>& roots, const Box& box) {
  std::vector<Point> result;
  for (const Point& root : roots) {
    if (planted::contains(box, root)) result.push_back(root);
  }
  return result;
}

/// The number of roots lost.
std::size_t lost_roots(const std::vector<Point>& before, const Box& box, bool is_alive) {
  return is_alive ? before.size() - members(before, box).size() : before.size();
}

class ContractorContract : public testing::TestWithParam<Choice> {
 protected:
  static std::size_t cases() {
    return fuzz_cases(1000) / (GetParam().arithmetic == Arithmetic::fast ? 1 : 5);
  }

  void contract_and_check(const PlantedSystem& planted, Contractor& contractor, Box box) {
    constexpr int kRounds = 3;
    for (int round = 0; round < kRounds; ++round) {
      const Box before = box;
      const std::vector<Point> roots = members(planted.roots, box);
      ProofTrace trace(true);
      const bool is_alive = contractor.contract(box, trace);
      const auto where = [&] { return planted::to_text(planted.system) + "on " + planted::to_text(before); };
      ASSERT_EQ(lost_roots(roots, box, is_alive), 0U) << where() << "left " << planted::to_text(box);
      const std::optional<Box> replayed = Replay(trace.steps()).run(before);
      ASSERT_EQ(replayed.has_value(), is_alive) << where();
      if (!is_alive) return;
      for (std::size_t i = 0; i < box.size(); ++i) ASSERT_TRUE(subset(box[i], before[i])) << where();
      ASSERT_EQ(*replayed, box) << where();
      if (largest_gain(before, box) > 0) ++gains_;
    }
  }

  std::size_t gains_ = 0;
};

TEST_P(ContractorContract, LosesNoRootAndTellsEveryStep) {
  constexpr std::size_t kBoxes = 5;
  Random random(fuzz_seed(), "contractor_contract");
  PlantedGenerator generator(random);
  for (std::size_t i = 0; i < cases(); i += kBoxes) {
    const PlantedSystem planted = generator.system(generator.random_kind());
    const SystemFunctions functions(planted.system);
    const auto contractor = make_if_applicable(GetParam(), functions);
    if (contractor == nullptr) continue;
    for (std::size_t k = 0; k < kBoxes; ++k) {
      const Point& centre = planted.roots[random.below(planted.roots.size())];
      contract_and_check(planted, *contractor, generator.box_around(centre));
      if (HasFatalFailure()) return;
    }
  }
  // A contractor that never does anything would pass all that.
  EXPECT_GT(gains_, cases() / 20);
}

TEST_P(ContractorContract, ShrinksAroundASimpleRoot) {
  const SystemFunctions functions(planted::system_of({"x", "y"}, {"x^2 + y^2 - 2", "x^2 + x*y - y - 1"}));
  const auto contractor = make_if_applicable(GetParam(), functions);
  ASSERT_NE(contractor, nullptr);
  Box box = {{0.9, 1.05}, {0.95, 1.2}};
  ProofTrace trace;
  ASSERT_TRUE(contractor->contract(box, trace));
  EXPECT_LT(width(box[0]) + width(box[1]), 0.4);
  EXPECT_TRUE(contains(box[0], 1) && contains(box[1], 1));
  EXPECT_TRUE(trace.steps().empty()) << "a trace that nobody wants";
}

TEST_P(ContractorContract, FindsThatABoxHasNoRoot) {
  const SystemFunctions functions(planted::system_of({"x", "y"}, {"x^2 + y^2 - 2", "x^2 + x*y - y - 1"}));
  const auto contractor = make_if_applicable(GetParam(), functions);
  ASSERT_NE(contractor, nullptr);
  Box box = {{0.5, 0.6}, {0.2, 0.3}};
  ProofTrace trace(true);
  bool is_alive = true;
  for (int round = 0; round < 5 && is_alive; ++round) is_alive = contractor->contract(box, trace);
  EXPECT_FALSE(is_alive);
  EXPECT_FALSE(Replay(trace.steps()).run({{0.5, 0.6}, {0.2, 0.3}}).has_value());
}

TEST_P(ContractorContract, ForgetsEarlierBoxes) {
  const SystemFunctions functions(planted::system_of({"x", "y"}, {"x^2 + y^2 - 2", "x^3 - x*y + y/3 - 1/3"}));
  const auto used = make_if_applicable(GetParam(), functions);
  ASSERT_NE(used, nullptr);
  const Box probe = {{0.5, 1.3}, {0.7, 1.4}};
  ProofTrace trace;
  Random random(fuzz_seed(), "contractor_forgets");
  for (int i = 0; i < 50; ++i) {
    Box other = {{random.uniform(-2, 0), random.uniform(0, 2)},
                 {random.uniform(-2, 0), random.uniform(0, 2)}};
    static_cast<void>(used->contract(other, trace));
  }
  Box first = probe, second = probe;
  const bool alive_first = used->contract(first, trace);
  const bool alive_second = make(GetParam(), functions)->contract(second, trace);
  ASSERT_TRUE(alive_first && alive_second);
  EXPECT_EQ(first, second);
}

INSTANTIATE_TEST_SUITE_P(Every, ContractorContract, testing::ValuesIn(choices()), name_of_choice);

TEST(UnroundedContractor, LosesRoots) {
  // The baseline: the same contractors without outward rounding lose roots in thin boxes.
  Random random(fuzz_seed(), "contractor_unrounded");
  PlantedGenerator generator(random);
  std::map<std::string, std::size_t> lost;
  for (std::size_t i = 0; i < fuzz_cases(1000); ++i) {
    const PlantedSystem planted = generator.system(generator.random_kind());
    const SystemFunctions functions(planted.system);
    for (const std::string& name : contractor_registry().names()) {
      const auto contractor = make_if_applicable({name, Arithmetic::unrounded}, functions);
      if (contractor == nullptr) continue;
      Box box = generator.box_around(planted.roots.front());
      const std::vector<Point> roots = members(planted.roots, box);
      ProofTrace trace;
      const bool is_alive = contractor->contract(box, trace);
      lost[name] += lost_roots(roots, box, is_alive);
    }
  }
  for (const auto& [name, number] : lost) std::cout << name << " lost " << number << '\n';
  EXPECT_GT(lost["hull"], 0U);
  EXPECT_GT(lost["multipliers"], 0U);
}

}  // namespace
}  // namespace gcslab
