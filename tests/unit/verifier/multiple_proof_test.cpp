// Equations times monomials or divided by a variable, as summands of a row of a proof.

#include <gtest/gtest.h>

#include "unit/verifier/hand_written_proof.h"

namespace gcslab {
namespace {

/// The claim that the row, line 6 of the proof, shows the box to be empty.
HandWritten proof_by_row(const EquationSystem& system, const std::string& box, const std::string& row) {
  HandWritten proof;
  proof.system = system;
  proof.result = result_of(proof.system, Json::array());
  proof.lines = {"gcslab-proof 1", "box" + box, "start 0" + box, "node 0",
                 "expansion",      row,         "end empty",     "end"};
  return proof;
}

/// x (x + y) = 1 has no root with x, y in [1, 3]: divided by x, x + y - 1/x >= 1 there.
HandWritten product_of_sums() {
  return proof_by_row(system_of({"x", "y"}, {"x*(x + y) - 1", "y - x"}, {{1, 3}, {1, 3}}),
                      " 0x1p+0 0x1.8p+1 0x1p+0 0x1.8p+1",
                      "expansion_row 0 empty 0x0p+0 0x0p+0 q 0 0 : 0x1p+0");
}

TEST(QuotientProof, IsAccepted) {
  const VerificationReport report = product_of_sums().verified();
  EXPECT_TRUE(report.accepted()) << refusals_of(report);
  EXPECT_TRUE(report.completeness_proved);
}

/// Expanded about (2, 2) the quotient is 7/2 + a z_0 + z_1 with a in [7/6, 3/2]: z_1 <= -2, for x = 2 + z_0.
TEST(QuotientProof, ClaimsNoMoreThanTheSlopeOfTheReciprocalShows) {
  HandWritten proof = product_of_sums();
  // With -5/2 times y - x = z_1 - z_0 the sum is 7/2 + (a + 5/2) z_0 - 3/2 z_1: z_0 <= -1/2 at z_1 = 1.
  const auto is_taken = [&](double upper) {
    replace(proof, 6, "expansion_row 0 0x1p+0 " + hexadecimal(upper) + " 0x0p+0 -0x1.4p+1 q 0 0 : 0x1p+0");
    return proof.refused_line() != 6;
  };
  EXPECT_TRUE(is_taken(1.5 + 0x1p-50));  // z_0 <= -2 / (a + 5/2) <= -1/2, for a <= 3/2
  EXPECT_FALSE(is_taken(1.5 - 0x1p-50));
}

const Spoiled kSpoiled[] = {
    {"a variable that is not in every term", 6,
     [](HandWritten& p) { replace(p, 6, "expansion_row 0 empty 0x0p+0 0x0p+0 q 0 1 : 0x1p+0"); }},
    {"an equation without a product", 6,
     [](HandWritten& p) { replace(p, 6, "expansion_row 0 empty 0x0p+0 0x0p+0 q 1 0 : 0x1p+0"); }},
    {"an equation that is not there", 6,
     [](HandWritten& p) { replace(p, 6, "expansion_row 0 empty 0x0p+0 0x0p+0 q 2 0 : 0x1p+0"); }},
    {"a variable that is not there", 6,
     [](HandWritten& p) { replace(p, 6, "expansion_row 0 empty 0x0p+0 0x0p+0 q 0 2 : 0x1p+0"); }},
    {"an infinite multiplier", 6,
     [](HandWritten& p) { replace(p, 6, "expansion_row 0 empty 0x0p+0 0x0p+0 q 0 0 : inf"); }},
    {"no multiplier", 6,
     [](HandWritten& p) { replace(p, 6, "expansion_row 0 empty 0x0p+0 0x0p+0 q 0 0 :"); }},
    {"a quotient by a product", 6,
     [](HandWritten& p) { replace(p, 6, "expansion_row 0 empty 0x0p+0 0x0p+0 q 0 0*0 : 0x1p+0"); }},
    {"no variable", 6,
     [](HandWritten& p) { replace(p, 6, "expansion_row 0 empty 0x0p+0 0x0p+0 q 0 : 0x1p+0"); }},
    {"another letter", 6,
     [](HandWritten& p) { replace(p, 6, "expansion_row 0 empty 0x0p+0 0x0p+0 p 0 0 : 0x1p+0"); }},
    {"a multiplier too small to show anything", 6,
     [](HandWritten& p) { replace(p, 6, "expansion_row 0 empty 0x1p+0 0x0p+0 q 0 0 : 0x1p-9"); }},
    {"a row that takes no quotients", 6,
     [](HandWritten& p) { replace(p, 6, "mean_value_row 0 empty 0x0p+0 0x0p+0 q 0 0 : 0x1p+0"); }},
    {"a box with 0 in the side of the divisor", 6,
     [](HandWritten& p) {
       p.system = system_of({"x", "y"}, {"x*(x + y) - 1", "y - x"}, {{-1, 3}, {1, 3}});
       p.lines[1] = "box -0x1p+0 0x1.8p+1 0x1p+0 0x1.8p+1";
       p.lines[2] = "start 0 -0x1p+0 0x1.8p+1 0x1p+0 0x1.8p+1";
     }},
};

TEST(QuotientProof, IsRefusedAtTheLineThatIsSpoiled) {
  for (const Spoiled& spoiled : kSpoiled) {
    HandWritten proof = product_of_sums();
    spoiled.spoil(proof);
    EXPECT_EQ(proof.refused_line(), spoiled.refused_line) << spoiled.what << "\n"
                                                          << refusals_of(proof.verified());
    EXPECT_FALSE(proof.proves_completeness()) << spoiled.what;
  }
}

/// Whatever x is in [1/2, 2], y = x and x y = x^2 + 1 have no root: x times the first, less the second, is 1.
HandWritten product_that_cancels() {
  return proof_by_row(system_of({"x", "y"}, {"y - x", "x*y - x^2 - 1"}, {{0.5, 2}, {0.5, 2}}),
                      " 0x1p-1 0x1p+1 0x1p-1 0x1p+1", "expansion_row 0 empty 0x0p+0 -0x1p+0 m 0 0 : 0x1p+0");
}

TEST(ProductProof, IsAccepted) {
  const VerificationReport report = product_that_cancels().verified();
  EXPECT_TRUE(report.accepted()) << refusals_of(report);
  EXPECT_TRUE(report.completeness_proved);
}

const Spoiled kSpoiledProducts[] = {
    {"by the other variable", 6,
     [](HandWritten& p) { replace(p, 6, "expansion_row 0 empty 0x0p+0 -0x1p+0 m 0 1 : 0x1p+0"); }},
    {"by a square", 6,
     [](HandWritten& p) { replace(p, 6, "expansion_row 0 empty 0x0p+0 -0x1p+0 m 0 0*0 : 0x1p+0"); }},
    {"of the other equation", 6,
     [](HandWritten& p) { replace(p, 6, "expansion_row 0 empty 0x0p+0 -0x1p+0 m 1 0 : 0x1p+0"); }},
    {"with another multiplier", 6,
     [](HandWritten& p) { replace(p, 6, "expansion_row 0 empty 0x0p+0 -0x1p+0 m 0 0 : -0x1p+0"); }},
    {"by too high a power", 6,
     [](HandWritten& p) {
       replace(p, 6, "expansion_row 0 empty 0x0p+0 -0x1p+0 m 0 0*0*0*0*0*0*0*0*0*0*0*0*0*0*0*0*0 : 0x1p+0");
     }},
    {"of an equation that is no polynomial", 6,
     [](HandWritten& p) {
       p.system = system_of({"x", "y"}, {"sin(y) - x", "x*y - x^2 - 1"}, {{0.5, 2}, {0.5, 2}});
     }},
};

TEST(ProductProof, IsRefusedAtTheLineThatIsSpoiled) {
  for (const Spoiled& spoiled : kSpoiledProducts) {
    HandWritten proof = product_that_cancels();
    spoiled.spoil(proof);
    EXPECT_EQ(proof.refused_line(), spoiled.refused_line) << spoiled.what << "\n"
                                                          << refusals_of(proof.verified());
    EXPECT_FALSE(proof.proves_completeness()) << spoiled.what;
  }
}

}  // namespace
}  // namespace gcslab
