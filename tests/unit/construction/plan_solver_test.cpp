// Systems that a plan solves outright: the box solver, which knows nothing of plans, proves the same roots;
// by hand, what happens where loci touch, miss, or coincide.

#include "construction/plan_solver.h"

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/random.h"
#include "box_solver/contractor_registry.h"
#include "box_solver/search.h"
#include "support/corpus_figure.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

CorpusFigure figure_of(const std::string& text) {
  CorpusFigure result{read_constraint_system(YamlNode::parse(text, "test.yaml")), {}, {}};
  result.frame = frame_of(result.system);
  result.equations = geometric_equations(result.system, result.frame);
  return result;
}

/// "{distance: [A, B], parameter: h}" each, with values.
struct Length {
  std::string a, b, value;
};

CorpusFigure of_lengths(const std::string& universe, const std::string& points,
                        const std::vector<Length>& lengths, const std::string& more = "") {
  std::string constraints, values;
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    constraints += fmt::format("  - {{distance: [{}, {}], parameter: h{}}}\n", lengths[k].a, lengths[k].b, k);
    values += fmt::format("{}h{}: {}", k == 0 ? "" : ", ", k, lengths[k].value);
  }
  return figure_of(fmt::format(
      "kind: constraint_system\nname: test\nuniverse: {}\npoints: [{}]\nconstraints:\n{}valuations: "
      "{{wanted: {{{}}}}}\n{}origin: test\nlicence: test\n",
      universe, points, constraints, values, more));
}

PlanSolutions solved(const CorpusFigure& figure, const PlanSolverOptions& options = {}) {
  const SystemFunctions functions(figure.equation_system());
  return solve_by_plan(figure.system, figure.frame, figure.equations, figure.system.valuation(""), functions,
                       options);
}

SearchResult searched(const SystemFunctions& functions) {
  const ContractorMaker maker = [](const SystemFunctions& of, int bits) {
    ContractorSettings settings;
    if (bits > 53) settings = {.arithmetic = Arithmetic::mpfr, .bits = bits};
    return make_contractor("hull+multipliers", of, settings);
  };
  const Box& box = functions.system().box;
  return search(functions, box, {{box}}, maker, {});
}

bool are_apart(const Box& a, const Box& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (disjoint(a[i], b[i])) return true;
  }
  return false;
}

/// The same roots: as many, and each box meets one of the others.
std::size_t expect_as_searched(const CorpusFigure& figure, const std::string& what) {
  const SystemFunctions functions(figure.equation_system());
  const SearchResult reference = searched(functions);
  const PlanSolutions found = solved(figure);
  EXPECT_TRUE(reference.undecided.empty()) << what;
  EXPECT_TRUE(found.undecided.empty()) << what << (found.undecided.empty() ? "" : found.undecided[0].reason);
  EXPECT_TRUE(found.is_finished) << what;
  EXPECT_EQ(found.roots.size(), reference.solutions.size()) << what;
  for (const CertifiedRoot& root : found.roots) {
    EXPECT_EQ(std::ranges::count_if(reference.solutions,
                                    [&](const Solution& s) { return !are_apart(root.box, s.root.box); }),
              1)
        << what;
  }
  return found.roots.size();
}

TEST(PlanSolver, FindsWhatTheBoxSolverProvesOnTheCorpus) {
  for (const char* name : {"sketches/triangle", "polyhedra/tetrahedron-volume"})
    EXPECT_GT(expect_as_searched(corpus_figure(name), name), 0U);
}

/// Points one after the other, each at the distances of random ones from `dimension` before; some lengths are
/// changed, so that loci miss each other on some branches.
std::vector<Length> random_chain(Random& random, std::size_t dimension, std::size_t points) {
  std::vector<std::vector<double>> at(points, std::vector<double>(dimension));
  std::vector<Length> lengths;
  for (std::size_t p = 0; p < points; ++p) {
    for (double& x : at[p]) x = random.uniform(-2, 2);
    std::vector<std::size_t> before(p);
    for (std::size_t q = 0; q < p; ++q) before[q] = q;
    for (std::size_t left = std::min(p, dimension); left > 0; --left) {
      const auto k = static_cast<std::size_t>(random.uniform(0, static_cast<double>(before.size())));
      const std::size_t q = before[k];
      before.erase(before.begin() + static_cast<std::ptrdiff_t>(k));
      double square = 0;
      for (std::size_t i = 0; i < dimension; ++i) square += (at[p][i] - at[q][i]) * (at[p][i] - at[q][i]);
      const double factor = p > dimension && random.uniform(0, 1) < 0.3 ? random.uniform(0.7, 1.3) : 1.0;
      lengths.push_back(
          {fmt::format("P{}", p), fmt::format("P{}", q), fmt::format("{:.6f}", factor * std::sqrt(square))});
    }
  }
  return lengths;
}

TEST(PlanSolver, FindsWhatTheBoxSolverProvesOnRandomChains) {
  const std::uint64_t seed = fuzz_seed();
  Random random(seed, "chains");
  std::size_t roots = 0;
  for (std::size_t k = 0; k < fuzz_cases(6); ++k) {
    roots += expect_as_searched(of_lengths("2d", "P0, P1, P2, P3, P4", random_chain(random, 2, 5)),
                                fmt::format("plane, seed {}, case {}", seed, k));
    // The loci start from other points than the frame has.
    roots += expect_as_searched(
        of_lengths("2d", "P0, P1, P2, P3", random_chain(random, 2, 4), "frame: [P3, P2]\n"),
        fmt::format("frame, seed {}, case {}", seed, k));
    roots += expect_as_searched(of_lengths("3d", "P0, P1, P2, P3, P4", random_chain(random, 3, 5)),
                                fmt::format("space, seed {}, case {}", seed, k));
  }
  EXPECT_GT(roots, 0U);
}

TEST(PlanSolver, LeavesTouchingLociUndecidedAndNothingElse) {
  // AC + CB = AB: the circles touch at C, and D has two places for it.
  const CorpusFigure figure =
      of_lengths("2d", "A, B, C, D",
                 {{"A", "B", "5"}, {"A", "C", "2"}, {"B", "C", "3"}, {"A", "D", "4"}, {"B", "D", "3"}});
  const PlanSolutions found = solved(figure);
  EXPECT_TRUE(found.roots.empty());
  ASSERT_EQ(found.undecided.size(), 4U);  // B on either side, D on either side
  for (const UndecidedFigures& undecided : found.undecided) {
    EXPECT_EQ(undecided.reason, "the loci of C touch, or nearly, with 1024 bits");
    EXPECT_NEAR(std::abs(midpoint(undecided.box[1])), 2, 1e-9);  // C
    EXPECT_NEAR(midpoint(undecided.box[2]), 0, 1e-9);
    for (const Interval& side : undecided.box) EXPECT_LT(width(side), 1e-9);
  }
}

TEST(PlanSolver, DecidesByPrecisionWhatNearlyTouches) {
  const auto triangle = [](const std::string& side) {
    return of_lengths("2d", "A, B, C", {{"A", "B", "5"}, {"A", "C", "2"}, {"B", "C", side}});
  };
  const PlanSolutions apart = solved(triangle("3 - 10^(-60)"));
  EXPECT_TRUE(apart.roots.empty() && apart.undecided.empty());
  EXPECT_EQ(apart.empty_branches, 1U);
  EXPECT_GT(apart.bits, 128);
  const PlanSolutions near = solved(triangle("3 + 10^(-8)"));
  EXPECT_EQ(near.roots.size(), 4U);
  EXPECT_TRUE(near.undecided.empty());
  // Two roots nearer than doubles tell are not certified, and not lost.
  const PlanSolutions nearer = solved(triangle("3 + 10^(-60)"));
  EXPECT_TRUE(nearer.roots.empty());
  EXPECT_EQ(nearer.undecided.size(), 4U);
}

TEST(PlanSolver, ProvesThatConcentricCirclesAreApart) {
  const auto lengths = [](const std::string& last) {
    return std::vector<Length>{{"A", "B", "4"}, {"A", "C", "3"}, {"B", "C", "5"}, {"A", "D", "0"},
                               {"B", "D", "4"}, {"A", "E", "2"}, {"D", "E", last}};
  };
  const PlanSolutions apart = solved(of_lengths("2d", "A, B, C, D, E", lengths("3")));
  EXPECT_TRUE(apart.roots.empty() && apart.undecided.empty());
  const PlanSolutions same = solved(of_lengths("2d", "A, B, C, D, E", lengths("2")));
  ASSERT_FALSE(same.undecided.empty());
  EXPECT_EQ(same.undecided[0].reason, "the loci of E may meet in infinitely many points");
  // Every place of E on the circle around A is in a box.
  for (const double angle : {0.1, 2.0, 4.0}) {
    EXPECT_TRUE(std::ranges::any_of(same.undecided, [&](const UndecidedFigures& undecided) {
      const std::size_t last = undecided.box.size();
      return contains(undecided.box[last - 2], 2 * std::cos(angle)) &&
             contains(undecided.box[last - 1], 2 * std::sin(angle));
    }));
  }
}

TEST(PlanSolver, ProvesThatSpheresAroundPointsOfALineAreApart) {
  // A, B, D on a line at 0, 2, 3, all of them in the plane of A, B, C.
  const auto lengths = [](const std::string& last) {
    return std::vector<Length>{{"A", "B", "2"}, {"A", "C", "2"}, {"B", "C", "2"},
                               {"A", "D", "3"}, {"B", "D", "1"}, {"C", "D", "sqrt(7)"},
                               {"A", "E", "2"}, {"B", "E", "2"}, {"D", "E", last}};
  };
  const PlanSolutions apart = solved(of_lengths("3d", "A, B, C, D, E", lengths("3")));
  EXPECT_TRUE(apart.roots.empty());
  EXPECT_TRUE(apart.undecided.empty());
  EXPECT_FALSE(solved(of_lengths("3d", "A, B, C, D, E", lengths("sqrt(7)"))).undecided.empty());
}

TEST(PlanSolver, SaysWhereNoFrameHoldsTheFigure) {
  const PlanSolutions found =
      solved(of_lengths("2d", "A, B, C", {{"A", "B", "0"}, {"A", "C", "2"}, {"B", "C", "2"}}));
  EXPECT_TRUE(found.roots.empty());
  ASSERT_FALSE(found.undecided.empty());
  EXPECT_NE(found.undecided[0].reason.find("B may be at one place"), std::string::npos)
      << found.undecided[0].reason;
  // Unequal radii around the one place: proved to be impossible.
  const PlanSolutions none =
      solved(of_lengths("2d", "A, B, C", {{"A", "B", "0"}, {"A", "C", "2"}, {"B", "C", "3"}}));
  EXPECT_TRUE(none.roots.empty() && none.undecided.empty());
}

TEST(PlanSolver, DiscardsBranchesThatViolateAConstraintMore) {
  const auto lengths = [](const std::string& last) {
    return std::vector<Length>{{"A", "B", "5"}, {"A", "C", "4"}, {"B", "C", "3"},
                               {"A", "D", "4"}, {"B", "D", "3"}, {"C", "D", last}};
  };
  const PlanSolutions apart = solved(of_lengths("2d", "A, B, C, D", lengths("1")));
  EXPECT_TRUE(apart.roots.empty() && apart.undecided.empty());
  // C and D are mirror images, 24/5 apart: on one branch up to congruence, which no theorem here proves.
  const PlanSolutions fits = solved(of_lengths("2d", "A, B, C, D", lengths("4.8")));
  EXPECT_TRUE(fits.roots.empty());
  ASSERT_EQ(fits.undecided.size(), 4U);
  EXPECT_NE(fits.undecided[0].reason.find("more equations than unknowns"), std::string::npos);
}

TEST(PlanSolver, StopsAtItsBudgetAndSaysSo) {
  const CorpusFigure figure =
      of_lengths("2d", "A, B, C", {{"A", "B", "5"}, {"A", "C", "4"}, {"B", "C", "3"}});
  EXPECT_TRUE(solved(figure, {.maximum_branches = 2}).is_finished);
  EXPECT_FALSE(solved(figure, {.maximum_branches = 1}).is_finished);
}

TEST(PlanSolver, RefusesWhatNeedsGuides) {
  EXPECT_THROW(solved(corpus_figure("polyhedra/octahedron")), NotApplicable);
}

}  // namespace
}  // namespace gcslab
