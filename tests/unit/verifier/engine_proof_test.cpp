// Proofs that the engine writes are accepted; spoiled ones, whatever the spoiling, never prove what is false.

#include <gtest/gtest.h>
#include <map>

#include "base/random.h"
#include "support/fuzz.h"
#include "unit/verifier/solved_system.h"

namespace gcslab {
namespace {

std::vector<EquationSystem> systems() {
  const auto square = [](double size) { return Box{{-size, size}, {-size, size}}; };
  return {
      system_of({"x"}, {"x^2 - 2"}, {{-3, 3}}),
      system_of({"x"}, {"x^3 - x/3 + 1/30"}, {{-2, 2}}),
      system_of({"x", "y"}, {"x^2 + y^2 = 1", "y - x^2"}, square(2)),
      system_of({"x", "y"}, {"x^2 + y^2 = 1", "y - x^2"}, square(2), {"x <= 1/2"}),
      system_of({"x", "y"}, {"x^3 + y^3 = 3*x*y", "x^2 + 2*y^2 = 2"}, square(2)),
      system_of({"x", "y"}, {"sin(3*x) + cos(2*y) = 1/2", "exp(x) - y^2 - 1/3"}, square(2)),
      system_of({"x", "y"}, {"sqrt(x + 3) - y^2", "x*abs(y) + log(y + 4) - 1"}, square(2)),
      system_of({"x", "y"}, {"cbrt(x) - y", "x^2 + atan(y) - 1/2"}, square(2)),
      system_of({"x", "y"}, {"min(x, y) + 1/3", "x/(y^2 + 1) + max(x, 2*y) - 1"}, square(2)),
      system_of({"x", "y"}, {"x - 1/2", "x*y^2 - 1/4 - x^5*y^4"}, square(2)),
      system_of({"x", "y", "z"}, {"x^2 + y^2 + z^2 = 3", "x*y + z = 1", "x - y*z + 1/5"},
                {{-2, 2}, {-2, 2}, {-2, 2}}),
      system_of({"x", "y"}, {"x^2 - 2*x*y + y^2", "x + y - 1"}, square(1)),  // double root
      system_of({"x"}, {"x^2 + 1"}, {{-3, 3}}),
      system_of({"x"}, {"x^2 - 2"}, {Interval::entire()}),
      system_of({"x", "y"}, {"x*y - 1", "x^2 + y^2 - 4"}, {{0, Interval::entire().upper}, {-5, 5}}),
      system_of({"x"}, {"x^2 - 2", "x^3 - 2*x"}, {{-3, 3}}),  // more equations than variables
      system_of({"x", "y"}, {"x^2 + 2*y^2 - 1"}, square(2)),  // and fewer
      // Roots with y = 0, which propagation approaches down to numbers of any size.
      system_of({"x", "y"}, {"-4/7 - 2*x*y + y - 7/5*y^3 + 11/6*x^2", "17/8*x^2*y - 15/8*y^2"}, square(2)),
  };
}

const char* const kContractors[] = {"hull", "multipliers", "hull+multipliers", "hull+lp_reduction"};

TEST(EngineProof, IsAccepted) {
  for (const EquationSystem& system : systems()) {
    for (const char* contractor : kContractors) {
      const SolvedSystem run = solved(system, contractor, 3000);
      const VerificationReport report = run.verified();
      EXPECT_TRUE(report.accepted()) << contractor << "\n" << refusals_of(report);
      EXPECT_TRUE(report.completeness_proved) << contractor;
    }
  }
}

TEST(EngineProof, OfABudgetThatEndedIsAccepted) {
  const SolvedSystem run = solved(systems()[11], "hull", 40);
  ASSERT_EQ(run.result["status"], "budget_exhausted");
  const VerificationReport report = run.verified();
  EXPECT_TRUE(report.accepted()) << refusals_of(report);
  EXPECT_TRUE(report.completeness_proved);
  SolvedSystem shortened = run;
  shortened.result["undecided"].erase(0);
  shortened.sign();
  EXPECT_FALSE(shortened.verified().accepted());
}

/// c_0 + c_1 x + ... as a text, dense of degree 2 or 3 in all variables.
std::string random_polynomial(Random& random, const std::vector<std::string>& variables) {
  std::string text = std::to_string(random.integer(-5, 5)) + "/7";
  for (std::size_t term = 0; term < 3 + random.below(5); ++term) {
    text += " + (" + std::to_string(random.integer(-9, 9)) + "/" + std::to_string(random.integer(1, 9)) + ")";
    for (std::size_t factor = 0; factor < 1 + random.below(3); ++factor)
      text += "*" + variables[random.below(variables.size())];
  }
  return text;
}

TEST(EngineProof, OfRandomSystemsIsAccepted) {
  Random random(fuzz_seed(), "verifier.engine");
  std::size_t roots = 0;
  for (std::size_t i = 0; i < fuzz_cases(60); ++i) {
    const std::vector<std::string> variables = {"x", "y"};
    const EquationSystem system =
        system_of(variables, {random_polynomial(random, variables), random_polynomial(random, variables)},
                  {{-2, 2}, {-2, 2}});
    const SolvedSystem run = solved(system, kContractors[i % 3], 500);
    const VerificationReport report = run.verified();
    EXPECT_TRUE(report.accepted()) << refusals_of(report);
    EXPECT_TRUE(report.completeness_proved);
    roots += run.result["solutions"].size();
  }
  EXPECT_GT(roots, 20u);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::string joined(const std::vector<std::string>& parts, char separator) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : std::string(1, separator)) + part;
  return text;
}

double value_of(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

/// Another number: a unit beside, far away, of the other sign, or another one of the file.
std::string other_number(Random& random, const std::string& text) {
  const double value = value_of(text);
  switch (random.below(6)) {
    case 0:
      return hexadecimal(std::nextafter(value, 1e300));
    case 1:
      return hexadecimal(std::nextafter(value, -1e300));
    case 2:
      return hexadecimal(value + random.uniform(-1, 1));
    case 3:
      return hexadecimal(-value);
    case 4:
      return hexadecimal(value * (1 + random.uniform(-1e-3, 1e-3)));
    default:
      return "0x0p+0";
  }
}

/// One random edit of a proof.
void spoil(Random& random, std::vector<std::string>& lines) {
  const auto any_line = [&] { return 2 + random.below(lines.size() - 3); };
  const std::size_t at = any_line();
  switch (random.below(8)) {
    case 0:
      lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(at));
      return;
    case 1:
      std::swap(lines[at], lines[any_line()]);
      return;
    case 2:
      lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(at), lines[any_line()]);
      return;
    case 3:
      lines[at] = lines[any_line()];
      return;
    default:
      break;
  }
  std::vector<std::string> words = words_of(lines[at]);
  if (words.size() < 2) return;
  if (words[0] == "end" && random.below(2) == 0) {
    words = {"end", "empty"};
  } else if (words[0].starts_with("hull") && random.below(4) == 0) {
    words.resize(3);
    words.push_back("empty");
  } else {
    std::string& word = words[1 + random.below(words.size() - 1)];
    if (word.find('x') != std::string::npos) {
      word = other_number(random, word);
    } else if (!word.empty() && std::isdigit(static_cast<unsigned char>(word[0])) != 0) {
      word = std::to_string(random.below(12));
    }
  }
  lines[at] = joined(words, ' ');
}

/// Drops a proven root from the result: whatever claims completeness from then on is false.
TEST(EngineProof, ARootThatIsMissingIsNeverProvedAway) {
  Random random(fuzz_seed(), "verifier.spoil");
  std::map<int, SolvedSystem> runs;
  int index = 0;
  for (const EquationSystem& system : systems()) {
    for (const char* contractor : kContractors) {
      SolvedSystem run = solved(system, contractor, 300);
      if (!run.result["solutions"].empty() && run.result["undecided"].empty()) runs.emplace(index++, run);
    }
  }
  ASSERT_GT(index, 20);
  for (std::size_t i = 0; i < fuzz_cases(2000); ++i) {
    SolvedSystem run = runs.at(static_cast<int>(random.below(static_cast<std::uint64_t>(index))));
    run.result["solutions"].erase(random.below(run.result["solutions"].size()));
    run.sign();
    std::vector<std::string> lines = lines_of(run.proof);
    lines.pop_back();  // the hash
    for (std::size_t edits = random.below(4); edits-- > 0;) spoil(random, lines);
    run.proof = with_hash(joined(lines, '\n') + "\n");
    const VerificationReport report = run.verified();
    EXPECT_FALSE(report.completeness_proved) << run.proof;
    EXPECT_FALSE(report.accepted());
  }
}

/// Every box of a proof as it is before each line that narrows it.
class Follower {
 public:
  explicit Follower(const std::vector<std::string>& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i) follow(i, words_of(lines[i]));
  }
  struct Narrowing {
    std::size_t line;
    std::size_t variable;
    std::size_t place;  ///< of the lower bound among the words
    Box before;
  };
  const std::vector<Narrowing>& narrowings() const { return narrowings_; }

 private:
  static Box box_of(const std::vector<std::string>& words, std::size_t first) {
    Box box;
    for (; first + 1 < words.size(); first += 2)
      box.emplace_back(value_of(words[first]), value_of(words[first + 1]));
    return box;
  }

  void follow(std::size_t line, const std::vector<std::string>& words) {
    if (words[0] == "start") {
      boxes_[words[1]] = box_of(words, 2);
    } else if (words[0] == "node") {
      box_ = boxes_.at(words[1]);
    } else if (words[0].starts_with("hull") || words[0] == "expansion_row") {
      const std::size_t place = words[0].starts_with("hull") ? 3 : 2;
      const std::size_t variable = std::stoul(words[place - 1]);
      narrowings_.push_back({line, variable, place, box_});
      if (words[place] != "empty") box_[variable] = {value_of(words[place]), value_of(words[place + 1])};
    } else if (words[0] == "end" && words.size() > 1 && words[1] == "cut") {
      const std::size_t variable = std::stoul(words[2]);
      boxes_[words[4]] = boxes_[words[5]] = box_;
      boxes_[words[4]][variable].upper = boxes_[words[5]][variable].lower = value_of(words[3]);
    }
  }

  std::map<std::string, Box> boxes_;
  Box box_;
  std::vector<Narrowing> narrowings_;
};

/// Every single narrowing that cuts a root of its box away, in turn.
TEST(EngineProof, ANarrowingThatCutsARootAwayIsRefused) {
  std::size_t spoiled = 0;
  for (const EquationSystem& system : systems()) {
    const SolvedSystem run = solved(system, "hull+multipliers", 300);
    std::vector<std::string> lines = lines_of(run.proof);
    lines.pop_back();
    const Follower follower(lines);
    for (const auto& [line, variable, place, before] : follower.narrowings()) {
      for (const Json& solution : run.result["solutions"]) {
        Box root;
        for (const Json& side : solution["box"])
          root.emplace_back(value_of(side[0].get<std::string>()), value_of(side[1].get<std::string>()));
        bool is_inside = true;
        for (std::size_t i = 0; i < root.size(); ++i) is_inside = is_inside && subset(root[i], before[i]);
        if (!is_inside) continue;
        std::vector<std::string> edited = lines;
        std::vector<std::string> words = words_of(lines[line]);
        const double past = std::nextafter(root[variable].upper, 1e300);
        words[place] = hexadecimal(past);
        if (!(past <= value_of(words[place + 1]))) words[place + 1] = words[place];
        edited[line] = joined(words, ' ');
        SolvedSystem copy = run;
        copy.proof = with_hash(joined(edited, '\n') + "\n");
        const VerificationReport report = copy.verified();
        ASSERT_FALSE(report.accepted()) << edited[line];
        EXPECT_EQ(report.refusals.front().where, "proof:" + std::to_string(line + 1)) << edited[line];
        ++spoiled;
      }
    }
  }
  EXPECT_GT(spoiled, 100u);
}

}  // namespace
}  // namespace gcslab
