// The preconditioned mean value form against exact values, and Krawczyk certificates against known roots.

#include <gtest/gtest.h>

#include "certification/krawczyk_certifier.h"
#include "certification/preconditioned_form.h"
#include "interval/fast_interval.h"
#include "support/counted_system.h"
#include "support/fuzz.h"
#include "support/random_polynomial.h"

namespace gcslab {
namespace {

using planted::CountedGenerator;
using planted::CountedSystem;
using planted::Point;
using planted::system_of;

Matrix<double> matrix_of(std::size_t n, const std::vector<double>& entries) {
  Matrix<double> result(n, n);
  std::ranges::copy(entries, result.data());
  return result;
}

TEST(ProvedNonsingular, HoldsOfRegularMatricesOnly) {
  EXPECT_TRUE(is_proved_nonsingular(matrix_of(2, {1, 2, 3, 4})));
  EXPECT_TRUE(is_proved_nonsingular(matrix_of(2, {1e-200, 0, 0, 1e200})));
  EXPECT_FALSE(is_proved_nonsingular(matrix_of(2, {1, 2, 2, 4})));
  EXPECT_FALSE(is_proved_nonsingular(matrix_of(1, {0})));
  // Exactly singular, though elimination in doubles may not see it: row 3 is the sum of the others.
  Random random(fuzz_seed(), "nonsingular");
  for (std::size_t i = 0; i < fuzz_cases(1000); ++i) {
    std::vector<double> entries;
    for (int k = 0; k < 6; ++k) entries.push_back(static_cast<double>(random.integer(-1000, 1000)) / 1024);
    for (std::size_t k = 0; k < 3; ++k) entries.push_back(entries[k] + entries[k + 3]);
    ASSERT_FALSE(is_proved_nonsingular(matrix_of(3, entries)));
  }
}

TEST(PreconditionedForm, EnclosesTheCombinedEquations) {
  const SystemFunctions functions(system_of({"x", "y"}, {"x^3 - x*y + 1/3", "abs(x)*y - max(x, y^2)"}));
  const NumberTraits<FastInterval>::Scope scope;
  PreconditionedForm<FastInterval> form(functions);
  Random random(fuzz_seed(), "preconditioned_form");
  for (std::size_t i = 0; i < fuzz_cases(2000); ++i) {
    Box box;
    std::vector<double> centre;
    Point x;
    for (int j = 0; j < 2; ++j) {
      const double lower = random.uniform(-2, 2);
      box.emplace_back(lower, lower + std::ldexp(random.unit(), -static_cast<int>(random.integer(0, 30))));
      centre.push_back(random.below(3) == 0 ? lower : midpoint(box.back()));
      const double member = std::min(lower + random.unit() * width(box.back()), box.back().upper);
      x.push_back(rational_from_double(member));
    }
    ASSERT_TRUE(form.evaluate(box, centre));
    const Matrix<double> c =
        matrix_of(2, {random.uniform(-2, 2), 0, random.uniform(-1, 1), random.uniform(-2, 2)});
    form.precondition(c);
    for (std::size_t k = 0; k < 2; ++k) {
      Rational exact;
      FastInterval sum = form.values()[k];
      for (std::size_t j = 0; j < 2; ++j) {
        exact += rational_from_double(c(k, j)) * planted::exact_value(functions.equations()[j].expression, x);
        const Rational offset = x[j] - rational_from_double(centre[j]);
        sum = sum + form.matrix()(k, j) * NumberTraits<FastInterval>::from_rational(offset);
      }
      ASSERT_TRUE(encloses(sum, exact)) << planted::to_text(box);
    }
  }
}

TEST(KrawczykCertifier, CertifiesRootsThatAreThereAndAlone) {
  Random random(fuzz_seed(), "krawczyk_certifier");
  CountedGenerator generator(random);
  std::size_t proofs = 0;
  for (std::size_t i = 0; i < fuzz_cases(1000); ++i) {
    const CountedSystem counted = generator.system(static_cast<int>(random.integer(1, 3)));
    const SystemFunctions functions(counted.system);
    const std::size_t n = functions.variables();
    const std::vector<double> scales(n, 1.0);
    const Point& centre = counted.centres[random.below(counted.centres.size())];
    Box around;
    for (const Rational& x : centre) {
      const double size = std::ldexp(1, -static_cast<int>(random.integer(0, 30)));
      around.emplace_back(nearest_double(x) - size * random.unit(), nearest_double(x) + size);
    }
    NewtonIteration newton(functions, scales);
    const auto approximate = newton.run(around);
    if (!approximate) continue;
    KrawczykCertifier<FastInterval> certifier(functions, scales, 53);
    auto root = certifier.certify(*approximate);
    if (!root) continue;
    ++proofs;
    certifier.enlarge_uniqueness(*root, *approximate, around);
    const auto inside = [&](const Box& box) {
      return std::ranges::count_if(counted.roots, [&](const Point& r) { return planted::contains(box, r); });
    };
    ASSERT_EQ(inside(root->box), 1) << planted::to_text(counted.system) << planted::to_text(root->box);
    ASSERT_EQ(inside(root->uniqueness_box), 1)
        << planted::to_text(counted.system) << planted::to_text(root->uniqueness_box);
  }
  EXPECT_GT(proofs, fuzz_cases(1000) / 4);
}

}  // namespace
}  // namespace gcslab
