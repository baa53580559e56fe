// A short proof with a term that is no polynomial, written by hand, and every way to spoil it.

#include <gtest/gtest.h>

#include "unit/verifier/hand_written_proof.h"

namespace gcslab {
namespace {

/// exp(x) = 2 has no root in [1, 2]: with t = exp(x), t - 5/2 x >= exp(1) - 5/2 > 1/5, and t - 2 = 0.
HandWritten exponential() {
  HandWritten proof;
  proof.system = system_of({"x"}, {"exp(x) - 2"}, {{1, 2}});
  proof.result = result_of(proof.system, Json::array());
  proof.lines = {
      "gcslab-proof 1",                                    // 1
      "box 0x1p+0 0x1p+1",                                 // 2
      "term equation 0 0",                                 // 3
      "start 0 0x1p+0 0x1p+1",                             // 4
      "node 0",                                            // 5
      "expansion 0x1p+1 0x1p+3",                           // 6
      "polytope 0 empty -0x1p+0 ; g 0 0x1.4p+1 : 0x1p+0",  // 7
      "end empty",                                         // 8
      "end",                                               // 9
  };
  return proof;
}

const Spoiled kSpoiledTerms[] = {
    {"a term that is a constant", 7, [](HandWritten& p) { replace(p, 3, "term equation 0 1"); }},
    {"an operand that is not there", 3, [](HandWritten& p) { replace(p, 3, "term equation 0 0 1"); }},
    {"a function that is not there", 3, [](HandWritten& p) { replace(p, 3, "term equation 1 0"); }},
    {"a kind of function that is not there", 3, [](HandWritten& p) { replace(p, 3, "term identity 0 0"); }},
    {"a term named twice", 4,
     [](HandWritten& p) { p.lines.insert(p.lines.begin() + 3, {"term equation 0 0"}); }},
    {"a term named after a box", 5,
     [](HandWritten& p) { p.lines.insert(p.lines.begin() + 4, {"term equation 0"}); }},
    {"a side that does not contain the term", 6,
     [](HandWritten& p) { replace(p, 6, "expansion 0x1.8p+1 0x1p+3"); }},
    {"an unbounded side", 6, [](HandWritten& p) { replace(p, 6, "expansion 0x1p+1 inf"); }},
    {"a side too many", 6, [](HandWritten& p) { replace(p, 6, "expansion 0x1p+1 0x1p+3 0x1p+1 0x1p+3"); }},
    {"no sides", 7, [](HandWritten& p) { replace(p, 6, "expansion"); }},
    {"a strip of a term that is not there", 7,
     [](HandWritten& p) { replace(p, 7, "polytope 0 empty -0x1p+0 ; g 1 0x1.4p+1 : 0x1p+0"); }},
    {"the other side of the strip", 7,
     [](HandWritten& p) { replace(p, 7, "polytope 0 empty 0x1p+0 ; g 0 0x1.4p+1 : -0x1p+0"); }},
    {"another slope", 7,
     [](HandWritten& p) { replace(p, 7, "polytope 0 empty -0x1p+0 ; g 0 -0x1.4p+1 : 0x1p+0"); }},
    {"no strip", 7, [](HandWritten& p) { replace(p, 7, "polytope 0 empty -0x1p+0 ;"); }},
    {"a slope that is no number", 7,
     [](HandWritten& p) { replace(p, 7, "polytope 0 empty -0x1p+0 ; g 0 inf : 0x1p+0"); }},
};

TEST(ProofWithTerms, IsAccepted) {
  const VerificationReport report = exponential().verified();
  EXPECT_TRUE(report.accepted()) << refusals_of(report);
  EXPECT_TRUE(report.completeness_proved);
}

TEST(ProofWithTerms, IsRefusedAtTheLineThatIsSpoiled) {
  for (const Spoiled& spoiled : kSpoiledTerms) {
    HandWritten proof = exponential();
    spoiled.spoil(proof);
    EXPECT_EQ(proof.refused_line(), spoiled.refused_line) << spoiled.what << "\n"
                                                          << refusals_of(proof.verified());
  }
}

}  // namespace
}  // namespace gcslab
