#include "experiments/corpus/figure_family.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "geometry/degrees_of_freedom.h"
#include "geometry/sketch.h"

namespace gcslab {
namespace {

std::vector<FigureFamilyOptions> members() {
  std::vector<FigureFamilyOptions> result;
  for (const std::string& family : figure_families()) {
    for (const int more : {0, 1, 2, 9}) {
      for (const std::uint64_t seed : {1u, 2u})
        result.push_back({family, least_size(family) + more, seed, Rational(1, 20)});
    }
  }
  return result;
}

std::string name_of_member(const FigureFamilyOptions& options) {
  return fmt::format("{} {} seed {}", options.family, options.size, options.seed);
}

TEST(FigureFamily, IsRigidByCountByStructureAndAtAWitness) {
  for (const FigureFamilyOptions& options : members()) {
    const ConstraintSystem system = family_figure(options).system;
    const GeometricEquations equations = geometric_equations(system, *system.frame);
    const std::size_t unknowns = equations.unknowns.size();
    EXPECT_EQ(equations.equations.size(), unknowns) << name_of_member(options);
    EXPECT_EQ(structural_diagnosis(equations).rank, unknowns) << name_of_member(options);
    const auto witness = witness_diagnosis(system, *system.frame, equations);
    ASSERT_TRUE(witness) << name_of_member(options);
    EXPECT_EQ(witness->rank, unknowns) << name_of_member(options);
    const std::size_t size = static_cast<std::size_t>(options.size);
    const std::size_t expected = options.family == "polygon" ? 2 * size - 3
                                 : options.family == "prism" ? 5 * size - 3
                                                             : 3 * size - 6;
    EXPECT_EQ(unknowns, expected) << name_of_member(options);
  }
}

TEST(FigureFamily, ThePlantedFigureSatisfiesEveryConstraint) {
  for (const FigureFamilyOptions& options : members()) {
    const FamilyFigure member = family_figure(options);
    const ConstraintSystem& system = member.system;
    const std::vector<double> lengths = values_of(system.valuation("wanted"));
    for (const Constraint& constraint : system.constraints) {
      const auto vector = [&](std::size_t a, std::size_t b) {
        std::vector<Rational> result;
        for (std::size_t i = 0; i < member.wanted[0].size(); ++i)
          result.emplace_back(member.wanted[constraint.objects[b]][i] -
                              member.wanted[constraint.objects[a]][i]);
        return result;
      };
      const std::vector<Rational> u = vector(0, 1);
      if (constraint.parameter) {
        Rational square = 0;
        for (const Rational& x : u) square += x * x;
        EXPECT_NEAR(lengths[*constraint.parameter], std::sqrt(square.get_d()), 1e-12);
        EXPECT_GT(square, 0);
        continue;
      }
      const std::vector<Rational> v = vector(0, 2), w = vector(0, 3);
      EXPECT_EQ(u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
                    u[2] * (v[0] * w[1] - v[1] * w[0]),
                0)
          << name_of_member(options) << ": " << system.describe(constraint);
    }
  }
}

TEST(FigureFamily, PerturbationMovesTheFigureAwayFromTheSketchByNoMore) {
  const FamilyFigure member = family_figure({"triangulated_polyhedron", 20, 3, Rational(1, 100)});
  double most = 0;
  for (std::size_t k = 0; k < member.wanted.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i)
      most = std::max(most, std::abs(member.wanted[k][i].get_d() - (*member.system.sketch)[k][i]));
  }
  EXPECT_GT(most, 0.008);
  EXPECT_LE(most, 0.01 + 1e-6);
}

TEST(FigureFamily, AnotherSeedIsAnotherFigureAndTheSameSeedTheSame) {
  for (const std::string& family : figure_families()) {
    const auto of_seed = [&](std::uint64_t seed) { return family_figure({family, 9, seed}).wanted; };
    EXPECT_EQ(of_seed(4), of_seed(4)) << family;
    EXPECT_NE(of_seed(4), of_seed(5)) << family;
  }
}

}  // namespace
}  // namespace gcslab
