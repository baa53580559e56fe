// Whatever byte of a result or a proof is edited: the file is refused, or still says the same. With its hash
// made anew it is judged all the same, without a fault.

#include <gtest/gtest.h>

#include "base/random.h"
#include "support/fuzz.h"
#include "unit/verifier/solved_system.h"

namespace gcslab {
namespace {

std::vector<SolvedSystem> runs() {
  const EquationSystem system = system_of({"x", "y"}, {"x^2 + y^2 = 1", "y - x^2"}, {{-2, 2}, {-2, 2}});
  return {solved(system), solved(system, "bernstein_projection"), solved(system, "lp_reduction"),
          solved(system, "newton", 5), solved(system, "hull", 2000, "miranda")};
}

/// A byte changed, left out or put in.
void edit(Random& random, std::string& text) {
  const std::size_t at = random.below(text.size());
  const char byte =
      random.below(4) == 0 ? static_cast<char>(random.below(256)) : text[random.below(text.size())];
  switch (random.below(3)) {
    case 0:
      text[at] = byte;
      return;
    case 1:
      text.erase(at, 1);
      return;
    default:
      text.insert(at, 1, byte);
  }
}

TEST(EditedProof, IsRefused) {
  Random random(fuzz_seed(), "verifier.edited_proof");
  for (const SolvedSystem& run : runs()) {
    ASSERT_TRUE(run.verified().accepted()) << refusals_of(run.verified());
    for (std::size_t i = 0; i < fuzz_cases(120); ++i) {
      SolvedSystem copy = run;
      for (std::size_t edits = 1 + random.below(3); edits-- > 0;) edit(random, copy.proof);
      if (copy.proof == run.proof) continue;
      // The last line may end without its line feed: nothing stands behind it.
      if (copy.proof + "\n" == run.proof) continue;
      EXPECT_FALSE(copy.verified().accepted()) << copy.proof;
      copy.proof = with_hash(copy.proof);
      static_cast<void>(copy.verified());
    }
  }
}

TEST(EditedResult, IsRefusedOrSaysTheSame) {
  Random random(fuzz_seed(), "verifier.edited_result");
  std::size_t readable = 0;
  for (const SolvedSystem& run : runs()) {
    for (std::size_t i = 0; i < fuzz_cases(120); ++i) {
      std::string text = run.result.dump(1);
      edit(random, text);
      SolvedSystem copy = run;
      copy.result = Json::parse(text, nullptr, false);
      if (copy.result.is_discarded()) continue;  // no JSON at all: never judged
      ++readable;
      EXPECT_EQ(copy.verified_without_proof().accepted(), copy.result.dump() == run.result.dump()) << text;
      if (!copy.result.is_object()) continue;
      copy.sign();
      static_cast<void>(copy.verified());
    }
  }
  EXPECT_GT(readable, fuzz_cases(120));
}

}  // namespace
}  // namespace gcslab
