// Short proofs written by hand, and every way to spoil them.

#include "unit/verifier/hand_written_proof.h"

#include <gtest/gtest.h>

namespace gcslab {
namespace {

constexpr double kBelow = 0x1.6a09e667f3bccp+0;  ///< sqrt(2) rounded down
constexpr double kAbove = 0x1.6a09e667f3bcdp+0;  ///< and up

/// x^2 = 2 in [-3, 3]: narrowed to [-sqrt(2), sqrt(2)], cut at 0, each half in a uniqueness box.
HandWritten square_root() {
  HandWritten proof;
  proof.system = system_of({"x"}, {"x^2 - 2"}, {{-3, 3}});
  proof.result = result_of(proof.system, {solution_of({{-kAbove, -kBelow}}, {{-3, -0.5}}),
                                          solution_of({{kBelow, kAbove}}, {{0.5, 3}})});
  proof.lines = {
      "gcslab-proof 1",                                              // 1
      "box -0x1.8p+1 0x1.8p+1",                                      // 2
      "start 0 -0x1.8p+1 0x1.8p+1",                                  // 3
      "node 0",                                                      // 4
      "hull_equation 0 0 " + bounds(-kAbove, kAbove),                // 5
      "end cut 0 0x0p+0 1 2",                                        // 6
      "root 0 " + bounds(-kAbove, -kBelow) + " U -0x1.8p+1 0x1p-4",  // 7
      "node 1",                                                      // 8
      "end covered 0",                                               // 9
      "root 1 " + bounds(kBelow, kAbove) + " U 0x1p-1 0x1.8p+1",     // 10
      "node 2",                                                      // 11
      "expansion",                                                   // 12
      "expansion_row 0 0x1p-1 " + hexadecimal(kAbove) + " 0x1p-1",   // 13
      "end covered 1",                                               // 14
      "end",                                                         // 15
  };
  return proof;
}

TEST(HandWrittenProof, IsAccepted) {
  const VerificationReport report = square_root().verified();
  EXPECT_TRUE(report.accepted()) << refusals_of(report);
  EXPECT_TRUE(report.completeness_proved);
}

const Spoiled kSpoiled[] = {
    {"a lower bound one unit inward", 5,
     [](HandWritten& p) { replace(p, 5, "hull_equation 0 0 " + bounds(-kBelow, kAbove)); }},
    {"an upper bound one unit inward", 5,
     [](HandWritten& p) { replace(p, 5, "hull_equation 0 0 " + bounds(-kAbove, kBelow)); }},
    {"no root claimed", 5, [](HandWritten& p) { replace(p, 5, "hull_equation 0 0 empty"); }},
    {"no root claimed at the end", 9, [](HandWritten& p) { replace(p, 9, "end empty"); }},
    {"a narrowing in a row one unit inward", 13,
     [](HandWritten& p) { replace(p, 13, "expansion_row 0 0x1p-1 " + hexadecimal(kBelow) + " 0x1p-1"); }},
    {"another multiplier", 13,
     [](HandWritten& p) { replace(p, 13, "expansion_row 0 0x1p-1 " + hexadecimal(kAbove) + " 0x0p+0"); }},
    {"an infinite multiplier", 13,
     [](HandWritten& p) { replace(p, 13, "expansion_row 0 0x1p-1 " + hexadecimal(kAbove) + " inf"); }},
    {"a row without expansion", 12, [](HandWritten& p) { erase(p, 12); }},
    {"an expansion that comes late", 12, [](HandWritten& p) { std::swap(p.lines[11], p.lines[12]); }},
    {"an equation that is not there", 5,
     [](HandWritten& p) { replace(p, 5, "hull_equation 1 0 " + bounds(-kAbove, kAbove)); }},
    {"an inequality that is not there", 5,
     [](HandWritten& p) { replace(p, 5, "hull_inequality 0 0 " + bounds(-kAbove, kAbove)); }},
    {"a variable that is not there", 5,
     [](HandWritten& p) { replace(p, 5, "hull_equation 0 1 " + bounds(-kAbove, kAbove)); }},
    {"the narrowing that the cover rests on left out", 13, [](HandWritten& p) { erase(p, 13); }},
    {"another number of a root", 9, [](HandWritten& p) { replace(p, 9, "end covered 1"); }},
    {"a root that comes later", 8,
     [](HandWritten& p) {
       std::swap(p.lines[6], p.lines[7]);
       std::swap(p.lines[7], p.lines[8]);
     }},
    {"a uniqueness box with both roots", 7,
     [](HandWritten& p) { replace(p, 7, "root 0 " + bounds(-kAbove, -kBelow) + " U -0x1.8p+1 0x1.8p+1"); }},
    {"a uniqueness box that ends at the other root", 7,
     [](HandWritten& p) {
       replace(p, 7, "root 0 " + bounds(-kAbove, -kBelow) + " U -0x1.8p+1 " + hexadecimal(kAbove));
     }},
    {"a root's box beside the root", 7,
     [](HandWritten& p) { replace(p, 7, "root 0 " + bounds(-kBelow, -kBelow) + " U -0x1.8p+1 0x1p-4"); }},
    {"a root's box outside of the uniqueness box", 7,
     [](HandWritten& p) { replace(p, 7, "root 0 " + bounds(-kAbove, -kBelow) + " U -0x1p+0 0x1p-4"); }},
    {"a cut outside of the box", 6, [](HandWritten& p) { replace(p, 6, "end cut 0 0x1p+1 1 2"); }},
    {"parts of one number", 6, [](HandWritten& p) { replace(p, 6, "end cut 0 0x0p+0 1 1"); }},
    {"a part with the number of its whole", 6, [](HandWritten& p) { replace(p, 6, "end cut 0 0x0p+0 0 1"); }},
    {"a node without a box", 8, [](HandWritten& p) { replace(p, 8, "node 7"); }},
    {"a node twice", 15, [](HandWritten& p) { p.lines.insert(p.lines.begin() + 14, {"node 2"}); }},
    {"an undecided box that the result does not list", 9,
     [](HandWritten& p) { replace(p, 9, "end undecided"); }},
    {"a box left for later that the result does not list", 9,
     [](HandWritten& p) { replace(p, 9, "end pending"); }},
    {"a word that nobody knows", 5, [](HandWritten& p) { replace(p, 5, "oracle 0 0 empty"); }},
    {"a word too many", 9, [](HandWritten& p) { replace(p, 9, "end covered 0 0"); }},
    {"a word too few", 13, [](HandWritten& p) { replace(p, 13, "expansion_row 0 0x1p-1 0x1p+1"); }},
    {"a decimal number", 5, [](HandWritten& p) { replace(p, 5, "hull_equation 0 0 -2 2"); }},
    {"a bound that is no number", 5, [](HandWritten& p) { replace(p, 5, "hull_equation 0 0 nan nan"); }},
    {"bounds in the wrong order", 5,
     [](HandWritten& p) { replace(p, 5, "hull_equation 0 0 0x1p+1 -0x1p+1"); }},
    {"another search box", 2, [](HandWritten& p) { replace(p, 2, "box -0x1p+1 0x1.8p+1"); }},
    {"another version", 1, [](HandWritten& p) { replace(p, 1, "gcslab-proof 2"); }},
    {"a file that ends early", 15, [](HandWritten& p) { erase(p, 15); }},
    {"a solution that the result does not list", 14, [](HandWritten& p) { p.result["solutions"].erase(1); }},
};

TEST(HandWrittenProof, IsRefusedAtTheLineThatIsSpoiled) {
  for (const Spoiled& spoiled : kSpoiled) {
    HandWritten proof = square_root();
    spoiled.spoil(proof);
    EXPECT_EQ(proof.refused_line(), spoiled.refused_line) << spoiled.what << "\n"
                                                          << refusals_of(proof.verified());
    EXPECT_FALSE(proof.proves_completeness()) << spoiled.what;
  }
}

TEST(HandWrittenProof, BoundsOneUnitOutwardStillHold) {
  HandWritten proof = square_root();
  const double outward = std::nextafter(kAbove, 2);
  replace(proof, 5, "hull_equation 0 0 " + bounds(-outward, outward));
  replace(proof, 13, "expansion_row 0 0x1p-1 " + hexadecimal(std::nextafter(outward, 2)) + " 0x1p-1");
  EXPECT_TRUE(proof.proves_completeness()) << refusals_of(proof.verified());
}

TEST(HandWrittenProof, ABoxThatIsNotFollowedToItsEndLeavesCompletenessUnproved) {
  HandWritten proof = square_root();
  proof.lines.erase(proof.lines.begin() + 10, proof.lines.begin() + 14);
  EXPECT_FALSE(proof.proves_completeness());
  EXPECT_FALSE(proof.verified().accepted());  // the result says that completeness is proved
  proof.result["completeness"] = "none";
  proof.result["status"] = "partial";
  EXPECT_TRUE(proof.verified().accepted()) << refusals_of(proof.verified());
  EXPECT_FALSE(proof.verified().completeness_proved);
}

TEST(HandWrittenProof, StartsThatLeaveAGapProveNothingOfTheWhole) {
  HandWritten proof = square_root();
  replace(proof, 3, "start 0 -0x1.8p+1 0x1p+1");
  EXPECT_EQ(proof.refused_line(), 0);
  EXPECT_FALSE(proof.proves_completeness());
}

TEST(HandWrittenProof, StartsMayTileTheSearchBox) {
  HandWritten proof = square_root();
  replace(proof, 3, "start 0 -0x1.8p+1 0x1p+1");
  proof.lines.insert(proof.lines.begin() + 14,
                     {"start 3 0x1p+1 0x1.8p+1", "node 3", "hull_equation 0 0 empty", "end empty"});
  EXPECT_TRUE(proof.proves_completeness()) << refusals_of(proof.verified());
}

TEST(HandWrittenProof, AnEditedFileIsNoticedByItsHash) {
  const HandWritten proof = square_root();
  SolvedSystem run{proof.system, proof.result, text_of(proof.lines)};
  run.sign();
  ASSERT_TRUE(run.verified().accepted());
  SolvedSystem edited = run;
  edited.proof.replace(edited.proof.find("expansion\n"), 10, "expansion \n");
  EXPECT_FALSE(edited.verified().accepted());
  edited = run;
  edited.proof += "end\n";
  EXPECT_FALSE(edited.verified().accepted());
  edited = run;
  edited.proof.erase(edited.proof.rfind("hash"));
  EXPECT_FALSE(edited.verified().accepted());
  edited = run;
  edited.result["problem"] = "another";
  EXPECT_FALSE(edited.verified().accepted());
}

TEST(HandWrittenProof, AListedRootMayBeMissingWhereItIsNoSolution) {
  HandWritten proof = square_root();
  proof.system = system_of({"x"}, {"x^2 - 2"}, {{-3, 3}}, {"x >= 0"});
  proof.result["solutions"].erase(0);
  EXPECT_TRUE(proof.proves_completeness()) << refusals_of(proof.verified());
  proof.system = system_of({"x"}, {"x^2 - 2"}, {{-3, 3}}, {"x <= 0"});
  EXPECT_FALSE(proof.proves_completeness());
}

/// The steps of one node for x^2 = 2 in [lower, upper] that ends empty or undecided.
HandWritten one_node(double lower, double upper, const std::vector<std::string>& steps, const Box& left) {
  HandWritten proof;
  proof.system = system_of({"x"}, {"x^2 - 2"}, {{lower, upper}});
  proof.result = result_of(proof.system, Json::array());
  proof.lines = {"gcslab-proof 1", "box " + bounds(lower, upper), "start 0 " + bounds(lower, upper),
                 "node 0"};
  proof.lines.insert(proof.lines.end(), steps.begin(), steps.end());
  if (left.empty()) {
    proof.lines.push_back("end empty");
  } else {
    proof.lines.push_back("end undecided");
    proof.result["undecided"].push_back({{"box", box_json(left)}, {"reason", "test"}});
    proof.result["status"] = "partial";
  }
  proof.lines.push_back("end");
  return proof;
}

TEST(CaseDistinction, LeavesTheHullOfItsCases) {
  const std::string lower = "hull_equation 0 0 " + bounds(-kAbove, -kBelow);
  const std::string upper = "hull_equation 0 0 " + bounds(kBelow, kAbove);
  // On [-3, 0] the equation leaves -sqrt(2), on [0, 3] sqrt(2).
  const std::vector<std::string> steps = {"cases 0 0x0p+0", lower, "otherwise", upper, "join"};
  EXPECT_TRUE(one_node(-3, 3, steps, {{-kAbove, kAbove}}).proves_completeness());
  // The hull is no smaller.
  EXPECT_FALSE(one_node(-3, 3, steps, {{-kAbove, kBelow}}).proves_completeness());
}

TEST(CaseDistinction, DropsEmptyCases) {
  const std::vector<std::string> one = {"cases 0 0x1p+0", "hull_equation 0 0 empty", "otherwise", "join"};
  EXPECT_TRUE(one_node(0, 3, one, {{1, 3}}).proves_completeness());
  EXPECT_FALSE(one_node(0, 3, one, {{1.25, 3}}).proves_completeness());
  const std::vector<std::string> both = {"cases 0 0x1p+0", "hull_equation 0 0 empty", "otherwise",
                                         "hull_equation 0 0 empty", "join"};
  EXPECT_TRUE(one_node(0, 1.25, both, {}).proves_completeness());
  EXPECT_FALSE(one_node(0, 1.5, both, {}).proves_completeness());
  EXPECT_FALSE(one_node(-1.5, 1.25, both, {}).proves_completeness());
}

TEST(CaseDistinction, Nests) {
  const std::vector<std::string> steps = {"cases 0 0x1p+0",
                                          "cases 0 0x0p+0",
                                          "hull_equation 0 0 empty",
                                          "otherwise",
                                          "hull_equation 0 0 empty",
                                          "join",
                                          "otherwise",
                                          "cases 0 0x1.8p+0",
                                          "otherwise",
                                          "hull_equation 0 0 empty",
                                          "join",
                                          "join"};
  EXPECT_TRUE(one_node(-1, 3, steps, {{1, 1.5}}).proves_completeness());
  EXPECT_FALSE(one_node(-1, 3, steps, {{1, 1.4}}).proves_completeness());
  EXPECT_FALSE(one_node(-3, 3, steps, {{1, 1.5}}).proves_completeness());
}

TEST(CaseDistinction, ForgetsWhatHeldInTheOtherCase) {
  // The propagation and the expansion of the first case say nothing of the second.
  const std::vector<std::string> kept = {"cases 0 0x1p+0", "hull_equation 0 0 empty", "otherwise",
                                         "hull_equation 0 0 empty", "join"};
  EXPECT_FALSE(one_node(0, 3, kept, {}).proves_completeness());
  const std::vector<std::string> expanded = {"cases 0 0x1p+0", "expansion", "otherwise",
                                             "expansion_row 0 0x1p+0 0x1p+1 0x1p+0", "join"};
  EXPECT_FALSE(one_node(0, 3, expanded, {{0, 3}}).proves_completeness());
}

TEST(CaseDistinction, MustBeWellFormed) {
  const std::vector<std::vector<std::string>> malformed = {
      {"otherwise"},
      {"join"},
      {"cases 0 0x1p+0"},
      {"cases 0 0x1p+0", "join"},
      {"cases 0 0x1p+0", "otherwise"},
      {"cases 0 0x1p+0", "otherwise", "otherwise", "join"},
      {"cases 0 0x1p+3", "otherwise", "join"},
      {"cases 1 0x1p+0", "otherwise", "join"},
      {"cases 0 0x1p+0", "hull_equation 0 0 empty", "expansion", "otherwise", "join"},
  };
  for (const auto& steps : malformed) {
    const HandWritten proof = one_node(0, 3, steps, {{0, 3}});
    EXPECT_NE(proof.refused_line(), 0) << steps.back();
  }
}

TEST(Polytope, ProvesAbsenceWithAnInequality) {
  // On [1, 2], x = 3/2 + z/2: with f = x^2 - 2 = 1/4 + 3/2 z + 1/4 z^2 and g = x - 5/4 = 1/4 + 1/2 z,
  // g - f / 3 = 1/6 - z^2 / 12 > 0, while g <= 0 and f = 0 where there is a solution.
  const auto refused_line = [](const std::string& multipliers) {
    HandWritten proof = one_node(1, 2, {"expansion", "polytope 0 empty " + multipliers + " ;"}, {});
    proof.system = system_of({"x"}, {"x^2 - 2"}, {{1, 2}}, {"x <= 5/4"});
    return proof.refused_line();
  };
  const std::string third = hexadecimal(1.0 / 3);
  EXPECT_EQ(refused_line(third + " -0x1p+0"), 0);
  EXPECT_EQ(refused_line(third + " 0x1p+0"), 6);   // would be right for g >= 0
  EXPECT_EQ(refused_line(third + " -0x1p-1"), 6);  // proves nothing
  EXPECT_EQ(refused_line(third + " 0x0p+0"), 6);   // without the inequality
  EXPECT_EQ(refused_line("0x0p+0 -0x1p+0"), 6);    // without the equation
  EXPECT_EQ(refused_line(third), 6);               // a multiplier too few
}

TEST(Polytope, ProvesAbsenceWithAProductOfBoundFactors) {
  // On [-1, 1], x = z: f = (x - 1)^3 - 1/100, and (1 - z)^3 >= 0: -f - (1 - z)^3 = 1/100.
  const auto refused_line = [](const std::string& product) {
    HandWritten proof = one_node(-1, 1, {"expansion", "polytope 0 empty 0x1p+0 ; " + product}, {});
    proof.system = system_of({"x"}, {"x^3 - 3*x^2 + 3*x - 101/100"}, {{-1, 1}});
    return proof.refused_line();
  };
  EXPECT_EQ(refused_line("p -0 -0 -0 : 0x1p+0"), 0);
  EXPECT_EQ(refused_line("p -0 -0*0 : 0x1p+0"), 6);  // (1 - z)(1 - z^2)
  EXPECT_EQ(refused_line("p -0 -0 +0 : 0x1p+0"), 6);
  EXPECT_EQ(refused_line("p -0 -0 -0 : -0x1p+0"), 6);  // a negative multiplier
  EXPECT_EQ(refused_line("p -0 -0 0 : 0x1p+0"), 6);    // no sign
  EXPECT_EQ(refused_line("p -0 -0 -1 : 0x1p+0"), 6);   // no such variable
  EXPECT_EQ(refused_line("p : 0x1p+0"), 6);
  EXPECT_EQ(refused_line("q -0 -0 -0 : 0x1p+0"), 6);
  EXPECT_EQ(refused_line("p -0 -0 -0 0x1p+0"), 6);
  EXPECT_EQ(refused_line("p -0 -0 -0 -0 -0 -0 -0 -0 -0 : 0x1p+0"), 6);  // too many factors
}

TEST(Polytope, ProvesAbsenceWithTheSquareOfASum) {
  // On [-1, 1]^2: f = x^2 - 2 x y + y^2 + 1 and (x - y)^2 >= 0.
  const auto refused_line = [](const std::string& product) {
    HandWritten proof;
    const Box box = {{-1, 1}, {-1, 1}};
    proof.system = system_of({"x", "y"}, {"x^2 - 2*x*y + y^2 + 1"}, box);
    proof.result = result_of(proof.system, Json::array());
    const std::string sides = bounds(-1, 1) + " " + bounds(-1, 1);
    proof.lines = {"gcslab-proof 1", "box " + sides, "start 0 " + sides,
                   "node 0",         "expansion",    "polytope 0 empty -0x1p+0 ; " + product,
                   "end empty",      "end"};
    return proof.refused_line();
  };
  EXPECT_EQ(refused_line("s +0 -1 : 0x1p+0"), 0);
  EXPECT_EQ(refused_line("s +0 +1 : 0x1p+0"), 6);
  EXPECT_EQ(refused_line("s +0 -1 : 0x1p+1"), 6);
}

TEST(MeanValueRow, ProvesWhatNewtonAndKrawczykProve) {
  const auto row = [](double lower, double upper, double multiplier) {
    return std::vector<std::string>{
        "expansion", "mean_value_row 0 " + bounds(lower, upper) + " " + hexadecimal(multiplier)};
  };
  // On [1, 2]: m = 3/2, f(m) = 1/4, slopes from m are [5/2, 7/2]: the quotient is 3/2 - [1/14, 1/10].
  EXPECT_TRUE(one_node(1, 2, row(1.3999, 1.4286, 1), {{1.3999, 1.4286}}).proves_completeness());
  EXPECT_FALSE(one_node(1, 2, row(1.4001, 1.4286, 1), {{1.3999, 1.4286}}).proves_completeness());
  EXPECT_FALSE(one_node(1, 2, row(1.3999, 1.4285, 1), {{1.3999, 1.4286}}).proves_completeness());
  EXPECT_FALSE(one_node(1, 2, row(1.3999, 1.4286, 0), {{1.3999, 1.4286}}).proves_completeness());
  // On [-3, 3] the slopes from 0 contain 0: only Krawczyk's form narrows, and not below [-3, 3] here.
  EXPECT_FALSE(one_node(-3, 3, row(-2, 2, 1), {{-3, 3}}).proves_completeness());
  // On [2, 3] there is no root: m = 5/2, f(m) = 17/4, slopes [9/2, 11/2].
  const std::vector<std::string> none = {"expansion", "mean_value_row 0 empty 0x1p+0"};
  EXPECT_TRUE(one_node(2, 3, none, {}).proves_completeness());
  EXPECT_FALSE(one_node(1, 2, none, {}).proves_completeness());
}

TEST(MeanValueRow, SaysNothingWhereTheFunctionMayBeUndefined) {
  HandWritten proof = one_node(-1, 3, {"expansion", "mean_value_row 0 empty 0x1p+0"}, {});
  proof.system = system_of({"x"}, {"sqrt(x) + 1"}, {{-1, 3}});
  EXPECT_EQ(proof.refused_line(), 6);
  proof.system = system_of({"x"}, {"sqrt(x + 2) + 1"}, {{-1, 3}});
  EXPECT_TRUE(proof.proves_completeness());
}

}  // namespace
}  // namespace gcslab
