// No cell that the curve meets is ever dropped: dropped cells are checked exactly, on their edges and at
// planted points.

#include "covering/cover.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/random.h"
#include "enclosure/bound_registry.h"
#include "experiments/corpus/corpus.h"
#include "experiments/corpus/problem.h"
#include "expression/parser.h"
#include "polynomial/bernstein.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

std::unique_ptr<RangeBound> make_bound(const std::string& name, const BoundTarget& target) {
  const BoundVariant& variant = bound_registry().at(name);
  return variant.make(target, Options(variant.options, {}, name));
}

std::vector<std::string> bounds_for(const BoundTarget& target) {
  std::vector<std::string> names;
  for (const BoundVariant& variant : bound_registry().entries()) {
    try {
      static_cast<void>(make_bound(variant.name, target));
      names.push_back(variant.name);
    } catch (const NotApplicable&) {
    }
  }
  return names;
}

/// Whether a polynomial in one variable has no root in [0, 1], exactly: halves until all coefficients have
/// one sign. A root that is touched but not crossed is found too: there the coefficients never get one sign.
bool has_no_root(const BernsteinTensor<Rational>& edge, int splits_left) {
  const auto [least, greatest] = extreme_coefficients(edge);
  if (least > 0 || greatest < 0) return true;
  if (splits_left == 0 || edge.corner(0) == 0 || edge.corner(1) == 0) return false;
  BernsteinTensor<Rational> lower, upper;
  edge.halve(0, lower, upper);
  return has_no_root(lower, splits_left - 1) && has_no_root(upper, splits_left - 1);
}

/// Whether the curve has no point on any edge of the cell.
bool edges_are_free(const Polynomial& f, const Box& cell) {
  const auto tensor = bernstein_from_polynomial<Rational>(f, rational_box(cell));
  for (int variable = 0; variable < 2; ++variable) {
    for (const Side side : {Side::lower, Side::upper}) {
      if (!has_no_root(tensor.face(variable, side), 60)) return false;
    }
  }
  return true;
}

bool lies_in(const std::vector<Rational>& point, const Box& box) {
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (point[i] < rational_from_double(box[i].lower) || point[i] > rational_from_double(box[i].upper))
      return false;
  }
  return true;
}

std::vector<CorpusEntry> covered_problems(const std::string& kind) {
  std::vector<CorpusEntry> result;
  for (const CorpusEntry& entry : Corpus::standard().problems()) {
    if (kind_of_file(entry.path) == kind) result.push_back(entry);
  }
  return result;
}

/// Checks that no dropped cell contains one of the points.
void expect_points_kept(const CoverTree& tree, const std::vector<std::vector<Rational>>& points,
                        const std::string& what) {
  tree.for_each_leaf([&](const CoverLeaf& leaf) {
    if (leaf.kept) return;
    for (const auto& point : points) {
      ASSERT_FALSE(lies_in(point, leaf.box)) << what << " drops a cell with a point of the set";
    }
  });
}

class CorpusCover : public testing::TestWithParam<CorpusEntry> {};

TEST_P(CorpusCover, KnownPointsAreKeptByEveryBoundAndSplit) {
  const Problem problem = load_problem(GetParam().path);
  const std::vector<BoundTarget> targets = problem.targets();
  for (const std::string& name : bounds_for(targets.front())) {
    for (const Split split : {Split::all, Split::alternate}) {
      SetBounds bounds;
      for (const BoundTarget& target : targets) bounds.equations.push_back(make_bound(name, target));
      const int depth = targets.front().variables() == 2 ? 6 : 3;
      const Cover found = cover(bounds, problem.system.box, {depth, split});
      expect_points_kept(found.tree, problem.known.points, GetParam().name + " by " + name);
      EXPECT_GT(found.tree.kept_cells(), 0u);
    }
  }
}

TEST_P(CorpusCover, DroppedCellsOfCurvesHaveNoPointOnTheirEdges) {
  const Problem problem = load_problem(GetParam().path);
  const BoundTarget target = problem.targets().front();
  if (problem.kind != "curve" || !target.is_polynomial()) GTEST_SKIP() << "no algebraic plane curve";
  for (const std::string& name : bounds_for(target)) {
    SetBounds bounds;
    bounds.equations.push_back(make_bound(name, target));
    const Cover found = cover(bounds, problem.system.box, {4, Split::all});
    found.tree.for_each_leaf([&](const CoverLeaf& leaf) {
      if (!leaf.kept) {
        ASSERT_TRUE(edges_are_free(target.polynomial(), leaf.box)) << GetParam().name << " by " << name;
      }
    });
  }
}

std::vector<CorpusEntry> all_covered_problems() {
  std::vector<CorpusEntry> all;
  for (const char* kind : {"curve", "surface", "space_curve"}) {
    for (const CorpusEntry& entry : covered_problems(kind)) all.push_back(entry);
  }
  return all;
}

std::string name_of_entry(const testing::TestParamInfo<CorpusEntry>& info) {
  std::string name = info.param.name;
  std::ranges::replace_if(
      name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Corpus, CorpusCover, testing::ValuesIn(all_covered_problems()), name_of_entry);

/// A random polynomial with a planted rational zero: simple, double (no change of sign), or isolated.
Expression planted(ExpressionGraph& graph, Random& random, const std::vector<Rational>& point) {
  const Expression x = graph.variable(0), y = graph.variable(1);
  const Expression u = x - graph.constant(point[0]), v = y - graph.constant(point[1]);
  const auto coefficient = [&] {
    return graph.constant(Rational(random.integer(-9, 9), random.integer(1, 5)));
  };
  const Expression through = u * (coefficient() + coefficient() * y + coefficient() * x * x) +
                             v * (coefficient() + coefficient() * x + coefficient() * y);
  switch (random.below(3)) {
    case 0:
      return through;
    case 1:
      return sqr(through);
    default:
      return sqr(u) * (graph.constant(1) + sqr(y)) + sqr(v) * (graph.constant(2) + sqr(coefficient() * x));
  }
}

TEST(PlantedCover, PlantedPointsAreKeptByEveryBoundOnRandomBoxes) {
  Random random(fuzz_seed(), "planted_cover");
  const std::size_t cases = fuzz_cases(10000) / 20;
  for (std::size_t i = 0; i < cases; ++i) {
    Box box;
    std::vector<Rational> point;
    for (int k = 0; k < 2; ++k) {
      const double a = random.uniform(-2, 2);
      box.emplace_back(a, a + random.uniform(0.1, 2));
      // Cell corners and rounded cell corners are the points where a careless walk loses zeros.
      double p = box.back().lower +
                 (box.back().upper - box.back().lower) * static_cast<double>(random.below(17)) / 16;
      p = std::clamp(p, box.back().lower, box.back().upper);
      point.push_back(rational_from_double(p));
    }
    auto graph = std::make_shared<ExpressionGraph>();
    const BoundTarget target(graph, planted(*graph, random, point), 2);
    for (const std::string& name : bounds_for(target)) {
      SetBounds bounds;
      bounds.equations.push_back(make_bound(name, target));
      const Cover found = cover(bounds, box, {4, Split::all});
      expect_points_kept(found.tree, {point}, name);
      if (testing::Test::HasFatalFailure()) FAIL() << "seed " << fuzz_seed() << ", case " << i;
    }
  }
}

TEST(Cover, InfiniteDerivativesLoseNoCell) {
  // Functions that are continuous but have no finite derivative at points of the box; the points lie on the
  // curves.
  struct Sample {
    const char* function;
    Box box;
    std::vector<Rational> point;
  };
  const std::vector<Sample> samples = {
      {"y - sqrt(max(x, 0))", {{-2, 2}, {-1, 1}}, {-1, 0}},
      {"y - sqrt(max(x, 0))", {{-2, 2}, {-1, 1}}, {Rational(1, 4), Rational(1, 2)}},
      {"y - cbrt(max(x, 0))", {{-2, 2}, {-1, 1}}, {Rational(-3, 2), 0}},
      {"y - max(x, 0)^(2/3)", {{-2, 2}, {-1, 1}}, {-1, 0}},
      {"y - cbrt(x)", {{0, 0}, {-1, 1}}, {0, 0}},
      {"y - cbrt(x)", {{-8, 8}, {-3, 3}}, {8, 2}},
      {"y - acos(min(x, 1))", {{0, 4}, {-1, 3}}, {2, 0}},
      {"y - 1 + 0*(max(x, 1/2))^0", {{0, 1}, {-1, 1}}, {Rational(1, 4), 1}},
      {"y - 2 + max(x - 1, 0)^0", {{0, 3}, {0, 2}}, {2, 1}},
      {"y - abs(x)^(1/3)", {{-1, 1}, {-1, 1}}, {Rational(1, 8), Rational(1, 2)}},
  };
  for (const Sample& sample : samples) {
    auto graph = std::make_shared<ExpressionGraph>();
    const std::vector<std::string> variables = {"x", "y"};
    const BoundTarget target(graph, parse_expression(*graph, sample.function, variables), 2);
    for (const std::string& name : bounds_for(target)) {
      SetBounds bounds;
      bounds.equations.push_back(make_bound(name, target));
      for (const int depth : {2, 6}) {
        const Cover found = cover(bounds, sample.box, {depth, Split::all});
        expect_points_kept(found.tree, {sample.point}, std::string(sample.function) + " by " + name);
      }
    }
  }
}

TEST(Cover, RoundedCornersLoseNoZeroInTheSliverBetweenCells) {
  // The middle of [0.1, 0.8] is no double; a zero just beside the rounded middle lies in the cell that was
  // rounded away from it unless the walk allows for the rounding.
  const std::vector<std::string> variables = {"x"};
  const Box box = {{0.1, 0.8}};
  for (const double at :
       {midpoint(box[0]), midpoint({0.1, midpoint(box[0])}), midpoint({midpoint(box[0]), 0.8})}) {
    for (const int steps : {-1, 0, 1}) {
      double zero = at;
      for (int s = 0; s < std::abs(steps); ++s) zero = std::nextafter(zero, steps > 0 ? 1.0 : 0.0);
      auto graph = std::make_shared<ExpressionGraph>();
      const Expression f = graph->variable(0) - graph->constant(rational_from_double(zero));
      const BoundTarget target(graph, f, 1);
      for (const std::string& name : bounds_for(target)) {
        SetBounds bounds;
        bounds.equations.push_back(make_bound(name, target));
        const Cover found = cover(bounds, box, {6, Split::all});
        expect_points_kept(found.tree, {{rational_from_double(zero)}}, name);
      }
    }
  }
}

}  // namespace
}  // namespace gcslab
