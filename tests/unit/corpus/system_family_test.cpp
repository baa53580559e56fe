#include "experiments/corpus/system_family.h"

#include <gtest/gtest.h>

#include "polynomial/recognise.h"

namespace gcslab {
namespace {

Polynomial polynomial_of(const FamilyMember& member, std::size_t equation) {
  const Recognition recognition =
      recognise_polynomial(member.system.equations[equation], static_cast<int>(member.root.size()));
  EXPECT_TRUE(recognition.polynomial) << recognition.reason;
  return *recognition.polynomial;
}

TEST(SparseQuadraticSystem, VanishesAtThePlantedRootExactly) {
  for (const int n : {2, 3, 5, 17}) {
    const FamilyMember member = sparse_quadratic_system(n, 3);
    ASSERT_EQ(member.system.equations.size(), static_cast<std::size_t>(n));
    for (std::size_t i = 0; i < member.root.size(); ++i) {
      EXPECT_EQ(polynomial_of(member, i).evaluate(member.root), 0) << n;
      EXPECT_LE(abs(member.root[i]), Rational(1, 4));
    }
  }
}

TEST(SparseQuadraticSystem, IsSparseAndQuadraticInEveryVariable) {
  const FamilyMember member = sparse_quadratic_system(12, 1);
  Exponents largest(12, 0);
  for (std::size_t i = 0; i < 12; ++i) {
    const Polynomial polynomial = polynomial_of(member, i);
    EXPECT_LE(polynomial.terms().size(), 7u);
    EXPECT_EQ(polynomial.total_degree(), 2);
    const Exponents degrees = polynomial.degrees();
    for (std::size_t j = 0; j < 12; ++j) largest[j] = std::max(largest[j], degrees[j]);
  }
  EXPECT_EQ(largest, Exponents(12, 2)) << "its tensors have 3^12 coefficients";
}

TEST(SparseQuadraticSystem, FollowsFromTheSeed) {
  EXPECT_EQ(sparse_quadratic_system(4, 7).root, sparse_quadratic_system(4, 7).root);
  EXPECT_NE(sparse_quadratic_system(4, 7).root, sparse_quadratic_system(4, 8).root);
}

}  // namespace
}  // namespace gcslab
