// Programs of others as methods of `solve`, through the program: recorded answers of PHCpack 2.4.86 and of
// the COV format of IBEX told by programs that stand in for them on the PATH, garbled answers, time limits,
// and the real phc where it is installed.

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/gcslab_shell.h"

namespace gcslab {
namespace {

using Json = nlohmann::json;

/// What `phc -b` (2.4.86) appends to the file of x^2 + y^2 - 1, y - x^2.
const char* const kPhcSolutions = R"(

THE SOLUTIONS :
4 2
===========================================================================
solution 1 :
t :  1.00000000000000E+00   0.00000000000000E+00
m : 1
the solution for t :
 x : -7.86151377757423E-01   0.00000000000000E+00
 y :  6.18033988749895E-01   0.00000000000000E+00
== err :  8.123E-17 = rco :  4.601E-01 = res :  1.110E-16 ==
solution 2 :
t :  1.00000000000000E+00   0.00000000000000E+00
m : 1
the solution for t :
 x :  0.00000000000000E+00   1.27201964951407E+00
 y : -1.61803398874989E+00   0.00000000000000E+00
== err :  4.599E-73 = rco :  2.268E-01 = res :  0.000E+00 ==
solution 3 :
t :  1.00000000000000E+00   0.00000000000000E+00
m : 1
the solution for t :
 x :  7.86151377757423E-01   0.00000000000000E+00
 y :  6.18033988749895E-01   0.00000000000000E+00
== err :  8.123E-17 = rco :  4.601E-01 = res :  1.110E-16 ==
solution 4 :
t :  1.00000000000000E+00   0.00000000000000E+00
m : 1
the solution for t :
 x :  0.00000000000000E+00  -1.27201964951407E+00
 y : -1.61803398874989E+00   0.00000000000000E+00
== err :  4.599E-73 = rco :  2.268E-01 = res :  0.000E+00 ==
)";

/// The bytes of a COV file, as `ibexsolve --format` describes them.
class CoverBytes {
 public:
  CoverBytes& integer(std::uint32_t value) { return raw(value); }
  CoverBytes& integers(std::initializer_list<std::uint32_t> values) {
    for (const std::uint32_t value : values) integer(value);
    return *this;
  }
  CoverBytes& number(double value) { return raw(value); }
  CoverBytes& box(std::initializer_list<double> bounds) {
    for (const double bound : bounds) number(bound);
    return *this;
  }
  CoverBytes& text(const std::string& characters) {
    bytes_ += characters;
    bytes_ += '\0';
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  template <class Number>
  CoverBytes& raw(Number value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    bytes_.append(bytes, sizeof value);
    return *this;
  }

  std::string bytes_;
};

/// Two solutions and a box that was not validated, for two equations in x, y.
std::string cover_of_two(std::uint32_t status = 2, std::uint32_t variables = 2) {
  CoverBytes cover;
  cover.text("IBEX COVERING FILE ").integer(5).integers({0, 0, 0, 0, 0, 0}).integers({1, 1, 1, 1, 1, 1});
  cover.integer(variables).integer(3);
  cover.box({-0.78616, -0.78615, 0.618, 0.6181})
      .box({0.5, 0.6, 0.5, 0.6})
      .box({0.78615, 0.78616, 0.618, 0.6181});
  cover.integer(0).integers({1, 2, 0, 2});   // no inner boxes; boundary boxes 0 and 2
  cover.integers({2, 0, 0}).integer(2);      // equations, inequalities, type; solutions
  cover.integer(0).box({-1, -0.5, 0.5, 1});  // with their unicity boxes
  cover.integer(2).box({0.5, 1, 0.5, 1});
  cover.integer(0);  // boundaries
  cover.text("x").text("y").integer(status).number(0.01).integer(17).integer(0);
  return cover.bytes();
}

class Peers : public GcslabShell {
 protected:
  void SetUp() override {
    GcslabShell::SetUp();
    fs::create_directories(folder_ / "programs");
    write("p.yaml",
          "kind: system\nname: test\nvariables: [x, y]\nequations: [\"x^2 + y^2 = 1\", \"y - x^2\"]\n"
          "box: {x: [-2, 2], y: [-2, 2]}\norigin: test\nlicence: none\n");
  }

  /// Puts a program on the PATH.
  void program(const std::string& name, const std::string& script) const {
    const fs::path file = folder_ / "programs" / name;
    std::ofstream(file) << "#!/bin/sh\n" << script << '\n';
    fs::permissions(file, fs::perms::owner_all);
  }

  /// A phc that says that.
  void phc(const std::string& appended, const std::string& output = "PHC ran from 1 till 2.") const {
    write("appended", appended);
    write("said", output + "\n");
    const std::string folder = folder_.string();
    program("phc", "cat '" + folder + "/appended' >> system; cat '" + folder + "/said' > output");
  }

  void ibexsolve(const std::string& cover) const {
    write("answer.cov", cover);
    program("ibexsolve", "cat '" + folder_.string() + "/answer.cov' > system.cov");
  }

  /// With the stand-ins before all others on the PATH.
  Answer solve(const std::string& options) const {
    return shell("PATH=\"$PWD/programs:$PATH\" $gcslab solve p.yaml " + options + " --json result.json");
  }
  Json result() const { return Json::parse(text_of(folder_ / "result.json"), nullptr, false); }

  /// An answer that cannot be read: an outcome with its reason, and not one root.
  void expect_failure(const std::string& method) const {
    fs::remove(folder_ / "result.json");
    const Answer answer = solve("--method " + method);
    EXPECT_EQ(answer.exit_code, 5);
    EXPECT_TRUE(has(answer.err, "cannot be read")) << answer.err;
    EXPECT_FALSE(has(answer.err, "fault of the program")) << answer.err;
    EXPECT_EQ(result()["status"], "failed");
    EXPECT_EQ(result()["completeness"], "none");
    EXPECT_EQ(result()["solutions"].size(), 0u);
  }
};

void expect_two_roots_without_certificate(const Json& result, double tolerance) {
  EXPECT_EQ(result["completeness"], "none");
  ASSERT_EQ(result["solutions"].size(), 2u);
  for (const Json& solution : result["solutions"]) {
    EXPECT_EQ(solution["certificate"]["claim"], "none");
    EXPECT_EQ(solution["isolated"], "unknown");
    EXPECT_FALSE(solution.contains("uniqueness_box"));
    EXPECT_NEAR(std::fabs(solution["point"][0].get<double>()), 0.786151377757423, tolerance);
    EXPECT_NEAR(solution["point"][1].get<double>(), 0.618033988749895, tolerance);
  }
}

TEST_F(Peers, PhcpackListsTheRealRootsInTheBoxWithoutProof) {
  phc(kPhcSolutions);
  const Answer answer = solve("--method phcpack");
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_EQ(result()["status"], "partial");
  expect_two_roots_without_certificate(result(), 1e-14);
  const Answer verified = shell("$gcslab verify result.json");
  EXPECT_EQ(verified.exit_code, 0) << verified.err;
  EXPECT_TRUE(has(verified.out, "without certificate")) << verified.out;
  solve("--method phcpack --box \"x=[0,2]\"");
  EXPECT_EQ(result()["solutions"].size(), 1u);
}

TEST_F(Peers, PhcpackWithoutSolutionsFindsNone) {
  phc("");
  EXPECT_EQ(solve("--method phcpack").exit_code, 0);
  EXPECT_EQ(result()["solutions"].size(), 0u);
  EXPECT_EQ(result()["status"], "partial");
}

TEST_F(Peers, GarbledSolutionsOfPhcpackAreAFailure) {
  const std::string good = kPhcSolutions;
  const auto with = [&](const std::string& old, const std::string& changed) {
    std::string text = good;
    text.replace(text.find(old), old.size(), changed);
    return text;
  };
  for (const std::string& text :
       {good.substr(0, good.size() / 2), with("4 2", "5 2"), with("4 2", "4 3"), with("4 2", "-4 2"),
        with("4 2", "99999999999999 2"), with("m : 1", "m : one"), with("x : -7.8", "x : nan -7.8"),
        with("-7.86151377757423E-01", "NaN"), with("-7.86151377757423E-01", "1E+999"),
        with("solution 2", "solution 7"), with("== err", "err"), with("=====", "-----"),
        std::string("\nTHE SOLUTIONS :"), std::string("\nTHE SOLUTIONS :\n\0\1\2\xff\n", 22)}) {
    phc(text);
    expect_failure("phcpack");
  }
  phc(good, "raised CONSTRAINT_ERROR");
  expect_failure("phcpack");
  program("phc", "true");
  expect_failure("phcpack");
}

TEST_F(Peers, APointThatPhcpackCallsNoSolutionIsNone) {
  // What phc -b answers to x + y - 1, x + y - 2.
  phc("\nTHE SOLUTIONS :\n1 2\n====\nsolution 1 :\nt :  0.0E+00   0.0E+00\nm : 0\nthe solution for t :\n"
      " x :  0.0E+00   0.0E+00\n y :  0.0E+00   0.0E+00\n== err :  0.0E+00 = rco :  0.0E+00 = res :  0.0E+00 "
      "==\n");
  EXPECT_EQ(solve("--method phcpack").exit_code, 0);
  EXPECT_EQ(result()["solutions"].size(), 0u);
}

TEST_F(Peers, IbexListsItsBoxesWithoutProof) {
  ibexsolve(cover_of_two());
  const Answer answer = solve("--method ibex");
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_EQ(result()["status"], "partial");
  expect_two_roots_without_certificate(result(), 1e-4);
  ASSERT_EQ(result()["undecided"].size(), 1u);
  EXPECT_EQ(result()["statistics"]["boxes"], 17);
  EXPECT_EQ(shell("$gcslab verify result.json").exit_code, 0);
  ibexsolve(cover_of_two(3));
  EXPECT_EQ(solve("--method ibex").exit_code, 3);
  EXPECT_EQ(result()["status"], "budget_exhausted");
}

TEST_F(Peers, GarbledCoversOfIbexAreAFailure) {
  const std::string good = cover_of_two();
  for (std::size_t length = 0; length < good.size(); length += 7) {
    ibexsolve(good.substr(0, length));
    expect_failure("ibex");
  }
  for (const std::string& cover : {good + "x", cover_of_two(6), cover_of_two(2, 3), std::string("hello")}) {
    ibexsolve(cover);
    expect_failure("ibex");
  }
  std::string many = good;
  std::memset(many.data() + 20 + 13 * 4 + 4, 0xff, 4);  // the number of boxes
  ibexsolve(many);
  expect_failure("ibex");
  ibexsolve(good);
  const Answer elsewhere = solve("--method ibex --box \"x=[1,2]\"");
  EXPECT_EQ(elsewhere.exit_code, 5) << "boxes outside of the search box";
}

TEST_F(Peers, AProgramThatFailsOrIsKilledIsAFailureWithItsLastLine) {
  program("phc", "echo 'raised STORAGE_ERROR : stack overflow' >&2; exit 1");
  const Answer answer = solve("--method phcpack");
  EXPECT_EQ(answer.exit_code, 5);
  EXPECT_TRUE(has(answer.err, "exit code 1")) << answer.err;
  EXPECT_TRUE(has(answer.err, "stack overflow")) << answer.err;
  program("ibexsolve", "kill -SEGV $$");
  EXPECT_TRUE(has(solve("--method ibex").err, "signal 11"));
}

TEST_F(Peers, ATimeLimitEndsTheProgramAndLeavesTheBoxUndecided) {
  program("ibexsolve", "sleep 60");
  const Answer answer = solve("--method ibex --timeout 0.3");
  EXPECT_EQ(answer.exit_code, 3);
  EXPECT_EQ(result()["status"], "budget_exhausted");
  EXPECT_EQ(result()["undecided"].size(), 1u);
  EXPECT_LT(result()["statistics"]["wall_s"].get<double>(), 20);
}

TEST_F(Peers, NotInstalledIsAnOutcomeAlsoAsARowOfARun) {
  const Answer answer = shell("PATH=/nowhere \"$gcslab\" solve p.yaml --method phcpack --json result.json");
  EXPECT_EQ(answer.exit_code, 4);
  EXPECT_TRUE(has(answer.err, "not installed")) << answer.err;
  EXPECT_EQ(result()["status"], "not_applicable");
  write("c.yaml",
        "experiment: peers\ntitle: peers\ntask: solve\nproblems: [p.yaml]\n"
        "methods: [{name: ibex}, {name: krawczyk, options: {certifier: miranda+elber_kim}}]\n");
  const Answer run =
      shell("PATH=/nowhere \"$gcslab\" run c.yaml --out runs && cat runs/peers/*.json* runs/peers/*/*");
  EXPECT_TRUE(has(run.out, "not installed")) << run.out << run.err;
  EXPECT_TRUE(has(run.out, "miranda+elber_kim")) << run.out << run.err;
}

TEST_F(Peers, AskedForAProofTheyRefuse) {
  phc(kPhcSolutions);
  for (const char* option : {"--proof f", "--pending f", "--resume f"}) {
    const Answer answer = solve(std::string("--method phcpack ") + option);
    EXPECT_EQ(answer.exit_code, 2);
    EXPECT_TRUE(has(answer.err, "program of others")) << answer.err;
  }
}

TEST_F(Peers, AreDescribedAsWhatProvesNothing) {
  EXPECT_TRUE(has(shell("$gcslab list methods --kind solve").out, "phcpack"));
  const Json about = Json::parse(shell("$gcslab describe ibex --json").out, nullptr, false);
  EXPECT_EQ(about["promise"], "baseline");
}

TEST_F(Peers, TheRealPhcFindsTheRootsInOrderOfTheVariables) {
  if (shell("command -v phc").exit_code != 0) GTEST_SKIP() << "phc is not installed";
  write("p.yaml",
        "kind: system\nname: test\nvariables: [e, y, x]\nequations: [\"y = x^2\", \"x^2 + y^2 = 1\", "
        "\"e = y + 3*x\"]\nbox: {x: [0, 2], y: [-2, 2], e: [-9, 9]}\norigin: test\nlicence: none\n");
  const Answer answer = shell("$gcslab solve p.yaml --method phcpack --json result.json");
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  ASSERT_EQ(result()["solutions"].size(), 1u);
  EXPECT_NEAR(result()["solutions"][0]["point"][2].get<double>(), 0.786151377757423, 1e-13);
  EXPECT_LT(result()["solutions"][0]["residual"].get<double>(), 1e-13);
  write("p.yaml",
        "kind: system\nname: test\nvariables: [x, y]\nequations: [\"x + y = 1\", \"x + y = 2\"]\n"
        "box: {x: [-2, 2], y: [-2, 2]}\norigin: test\nlicence: none\n");
  shell("$gcslab solve p.yaml --method phcpack --json result.json");
  EXPECT_EQ(result()["solutions"].size(), 0u);
}

}  // namespace
}  // namespace gcslab
