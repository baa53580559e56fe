#include "verifier/verifier.h"

#include <gtest/gtest.h>

#include "unit/verifier/solved_system.h"

namespace gcslab {
namespace {

EquationSystem square_root_of_two() { return system_of({"x"}, {"x^2 - 2"}, {{-3, 3}}); }

EquationSystem circle_and_parabola() {
  return system_of({"x", "y"}, {"x^2 + y^2 = 1", "y - x^2"}, {{-2, 2}, {-2, 2}});
}

TEST(Verifier, AcceptsWhatTheEngineProves) {
  for (const std::string contractor : {"hull", "multipliers", "hull+multipliers"}) {
    for (const EquationSystem& system : {square_root_of_two(), circle_and_parabola()}) {
      const SolvedSystem run = solved(system, contractor);
      ASSERT_EQ(run.result["solutions"].size(), 2u);
      const VerificationReport report = run.verified();
      EXPECT_TRUE(report.accepted()) << refusals_of(report);
      EXPECT_TRUE(report.completeness_proved);
    }
  }
}

}  // namespace
}  // namespace gcslab
