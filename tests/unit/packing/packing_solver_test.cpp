#include "packing/packing_solver.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "packing/random_triangulation.h"
#include "support/fuzz.h"
#include "unit/packing/apollonian_network.h"
#include "unit/verifier/solved_system.h"

namespace gcslab {
namespace {

EquationSystem drawn_system(int inner, std::uint64_t seed,
                            const Rational& least_radius = Rational(1, 100000)) {
  const Triangulation graph = random_triangulation({.inner_vertices = inner, .flips = 300, .seed = seed});
  return packing_system(graph, standard_outer_discs(), least_radius);
}

/// Result and proof as `solve` writes them.
SolvedSystem packed(const EquationSystem& system) {
  const SystemFunctions functions(system);
  std::ostringstream text;
  ProofLog log(text);
  const SearchResult found = solve_packing(functions, system.box, {.proof = &log});
  Json solutions = Json::array(), undecided = Json::array();
  for (const Solution& solution : found.solutions) solutions.push_back(solution_json(system, solution));
  for (const UndecidedBox& box : found.undecided)
    undecided.push_back({{"box", box_json(box.box)}, {"reason", box.reason}});
  SolvedSystem result{system,
                      {{"problem", "test"},
                       {"status", undecided.empty() ? "complete" : "partial"},
                       {"completeness", "proved"},
                       {"variables", system.variables},
                       {"solutions", solutions},
                       {"undecided", undecided}},
                      text.str()};
  result.sign();
  return result;
}

void expect_accepted(const SolvedSystem& run) {
  const VerificationReport report = run.verified();
  EXPECT_TRUE(report.accepted()) << refusals_of(report);
  EXPECT_TRUE(report.completeness_proved);
}

TEST(PackingSolver, ProvesTheOnePackingAndTheVerifierAgrees) {
  const std::uint64_t seed = fuzz_seed();
  for (const int inner : {1, 2, 3, 5, 9, 14}) {
    const SolvedSystem run = packed(drawn_system(inner, seed + static_cast<std::uint64_t>(inner)));
    EXPECT_EQ(run.result["status"], "complete") << inner;
    EXPECT_EQ(run.result["solutions"].size(), 1u) << inner;
    expect_accepted(run);
  }
}

TEST(PackingSolver, FindsTheDiscsOfDescartes) {
  const std::uint64_t seed = fuzz_seed();
  for (std::uint64_t i = 0; i < 5; ++i) {
    const ApollonianNetwork network(12, seed + i);
    const EquationSystem system = packing_system(network.graph, standard_outer_discs(), Rational(1, 1000000));
    const SystemFunctions functions(system);
    const SearchResult found = solve_packing(functions, system.box, {});
    ASSERT_EQ(found.solutions.size(), 1u);
    EXPECT_TRUE(found.undecided.empty());
    const Box& box = found.solutions[0].root.box;
    for (std::size_t v = 3; v < network.discs.size(); ++v) {
      const RationalDisc& disc = network.discs[v];
      for (const auto& [part, value] : {std::pair{0u, disc.x}, {1u, disc.y}, {2u, disc.radius}}) {
        const Interval side = box[3 * (v - 3) + part];
        EXPECT_LE(rational_from_double(side.lower), value);
        EXPECT_GE(rational_from_double(side.upper), value);
      }
    }
  }
}

/// The search knows nothing of packings: an independent count of the solutions.
TEST(PackingSolver, AgreesWithTheSearch) {
  const std::uint64_t seed = fuzz_seed();
  for (std::uint64_t i = 0; i < 4; ++i) {
    const EquationSystem system = drawn_system(3, seed + i, Rational(1, 100));
    const SolvedSystem searched = solved(system);
    ASSERT_EQ(searched.result["status"], "complete");
    ASSERT_EQ(searched.result["solutions"].size(), 1u);
    const SystemFunctions functions(system);
    const SearchResult found = solve_packing(functions, system.box, {});
    ASSERT_EQ(found.solutions.size(), 1u);
    for (std::size_t k = 0; k < system.box.size(); ++k) {
      EXPECT_NEAR(searched.result["solutions"][0]["point"][k].get<double>(),
                  midpoint(found.solutions[0].root.box[k]), 1e-13);
    }
  }
}

TEST(PackingSolver, LeavesTheBoxUndecidedWhereTheTheoremLacksSomething) {
  EquationSystem system = drawn_system(5, fuzz_seed());
  system.inequalities.pop_back();
  SolvedSystem run = packed(system);
  EXPECT_EQ(run.result["status"], "partial");
  EXPECT_EQ(run.result["solutions"].size(), 1u);
  ASSERT_EQ(run.result["undecided"].size(), 1u);
  expect_accepted(run);
  system = drawn_system(5, fuzz_seed());
  system.box[0].upper = 1e-3;  // without the packing
  run = packed(system);
  EXPECT_EQ(run.result["status"], "partial");
  EXPECT_EQ(run.result["solutions"].size(), 0u);
  ASSERT_EQ(run.result["undecided"].size(), 1u);
  expect_accepted(run);
}

/// Each disc in the gap of the three before it, smaller by a factor of about 2.9.
EquationSystem spiral(int discs) {
  Triangulation graph;
  Face face = {0, 1, 2};
  for (int i = 0; i < discs; ++i) {
    graph.insert_vertex(face);
    face = {face[1], face[2], graph.vertices() - 1};
  }
  return packing_system(graph, standard_outer_discs(), rational_from_text("1e-40"));
}

TEST(PackingSolver, TakesMorePrecisionWhereDoublesDoNotSuffice) {
  const SolvedSystem run = packed(spiral(16));
  ASSERT_EQ(run.result["status"], "complete");
  EXPECT_GT(run.result["solutions"][0]["certificate"]["evidence"][1]["bits"], 53);
  expect_accepted(run);
}

TEST(PackingSolver, SaysWhereDiscsAreTooSmallForABoxOfDoubles) {
  const SolvedSystem run = packed(spiral(25));
  EXPECT_EQ(run.result["status"], "partial");
  EXPECT_EQ(run.result["solutions"].size(), 0u);
  ASSERT_EQ(run.result["undecided"].size(), 1u);
  EXPECT_NE(run.result["undecided"][0]["reason"].get<std::string>().find("too coarse"), std::string::npos);
  expect_accepted(run);
}

/// Discs of curvatures 6, 3, 23 (times 1/6) and both that touch them: 62, in their gap, and 2, on the other
/// side.
TEST(PackingSolver, DoesNotTakeTheGapsPackingForTheOnlyOneInAWiderBox) {
  const auto one_disc = [](double top) {
    return system_of({"x", "y", "r"},
                     {"x^2 + y^2 = (r + 1)^2", "(x - 3)^2 + y^2 = (r + 2)^2",
                      "(x - 21/23)^2 + (y - 20/23)^2 = (r + 6/23)^2"},
                     {{0, 3}, {0, top}, {0.01, 4}});
  };
  const SolvedSystem wide = packed(one_disc(5));
  EXPECT_EQ(wide.result["status"], "partial");
  ASSERT_EQ(wide.result["solutions"].size(), 1u);
  EXPECT_NEAR(wide.result["solutions"][0]["point"][2].get<double>(), 3.0 / 31, 1e-15);
  expect_accepted(wide);
  EXPECT_EQ(solved(one_disc(5)).result["solutions"].size(), 2u);
  // Where the box ends below the highest fixed centre, the theorem applies.
  const SolvedSystem narrow = packed(one_disc(0.8));
  EXPECT_EQ(narrow.result["status"], "complete");
  expect_accepted(narrow);
  SolvedSystem spoilt = narrow;
  spoilt.system.box = one_disc(5).box;
  const std::size_t second = spoilt.proof.find('\n') + 1;
  std::ostringstream header;
  ProofLog(header).begin(spoilt.system.box);
  spoilt.proof = with_hash(header.str() + spoilt.proof.substr(spoilt.proof.find('\n', second) + 1));
  EXPECT_FALSE(spoilt.verified().completeness_proved);
}

TEST(PackingSolver, TakesNoOtherSystem) {
  const EquationSystem system =
      system_of({"x", "y", "r"}, {"x^2 + y^2 = r^2", "x - y", "r - 1"}, {{-2, 2}, {-2, 2}, {0, 2}});
  EXPECT_THROW(static_cast<void>(packed(system)), NotApplicable);
}

/// Proofs whose theorem does not apply never prove that nothing is missing.
class SpoiltProof : public testing::Test {
 protected:
  const EquationSystem system_ = drawn_system(5, 3);
  SolvedSystem run_ = packed(system_);

  void expect_refused(const EquationSystem& other, const char* reason) {
    SolvedSystem spoilt = run_;
    spoilt.system = other;
    const std::size_t second = spoilt.proof.find('\n') + 1;
    std::ostringstream text;
    ProofLog(text).begin(other.box);
    const std::string header = text.str();
    spoilt.proof = with_hash(header + spoilt.proof.substr(spoilt.proof.find('\n', second) + 1));
    const VerificationReport report = spoilt.verified();
    EXPECT_FALSE(report.completeness_proved);
    EXPECT_NE(refusals_of(report).find(reason), std::string::npos) << refusals_of(report);
  }
};

TEST_F(SpoiltProof, IsAcceptedBefore) { expect_accepted(run_); }

TEST_F(SpoiltProof, IsRefusedWithoutAnInequality) {
  EquationSystem other = system_;
  other.inequalities.pop_back();
  expect_refused(other, "some pair of discs may overlap");
}

TEST_F(SpoiltProof, IsRefusedWhereAnInequalityWantsAnOverlap) {
  EquationSystem other = system_;
  other.inequalities[1] = -other.inequalities[1];
  expect_refused(other, "some pair of discs may overlap");
}

TEST_F(SpoiltProof, IsRefusedWhereRadiiMayVanish) {
  EquationSystem other = system_;
  other.box[2].lower = -1;
  expect_refused(other, "not positive");
}

TEST_F(SpoiltProof, IsRefusedWhereDiscsMayLieOutside) {
  EquationSystem other = system_;
  other.box[0].lower = other.box[1].lower = -1;
  expect_refused(other, "other side");
}

TEST_F(SpoiltProof, IsRefusedForAnEquationOfAnotherKind) {
  EquationSystem other = system_;
  // The same solution: the square of the distance and not that of the radii is moved.
  other.equations[0] = other.equations[0] * (other.graph->variable(2) + other.graph->constant(1));
  expect_refused(other, "does not say that two discs are tangent");
}

TEST_F(SpoiltProof, IsRefusedWithoutTheListedSolution) {
  run_.result["solutions"].clear();
  run_.sign();
  expect_refused(system_, "no listed root");
}

TEST_F(SpoiltProof, IsRefusedForAnUnknownTheorem) {
  const std::size_t at = run_.proof.find("circle_packing");
  run_.proof.replace(at, 14, "four_colours");
  expect_refused(system_, "expected 'circle_packing'");
}

}  // namespace
}  // namespace gcslab
