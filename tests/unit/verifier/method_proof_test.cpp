// Proofs by every registered method are accepted, and refused at the very line where one number was changed
// so that the line cuts a root away or rests on nothing, whatever its kind.

#include <gtest/gtest.h>
#include <map>
#include <set>

#include "base/error.h"
#include "unit/verifier/solved_system.h"

namespace gcslab {
namespace {

std::vector<EquationSystem> systems() {
  const auto cube = [](double size, std::size_t n) { return Box(n, Interval(-size, size)); };
  return {
      system_of({"x"}, {"x^3 - x/3 + 1/30"}, cube(2, 1)),
      system_of({"x", "y"}, {"x^2 + y^2 = 1", "y - x^2"}, cube(2, 2), {"x <= 1/2"}),
      system_of({"x", "y"}, {"x^3 + y^3 = 3*x*y", "x^2 + 2*y^2 = 2"}, cube(2, 2)),
      system_of({"x", "y"}, {"x^2 - 2*x*y + y^2", "x + y - 1"}, cube(1, 2)),  // a double root
      system_of({"x", "y"}, {"x^2*y + 1/7*y^4 - 1/3", "x*y^2 - x - 1/5"}, cube(2, 2)),
      system_of({"x", "y", "z"}, {"x^2 + y^2 + z^2 = 3", "x*y + z = 1", "x - y*z + 1/5"}, cube(2, 3)),
      system_of({"x", "y"}, {"x^2 + y^2 + 1", "x - y"}, cube(2, 2)),
      system_of({"x", "y"}, {"exp(x) + y^2 = 3", "sin(x*y) + x/(1 + y^2) = 1/2"}, cube(3, 2),
                {"cos(x) - y^-2*pi <= 1"}),
  };
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  lines.pop_back();  // the hash
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

/// The bounds of a claim among the words of a row; nothing for other lines.
std::optional<std::size_t> place_of_claim(const std::string& word) {
  if (word.starts_with("hull_")) return 3;
  if (word.ends_with("_row") || word == "polytope") return 2;
  return std::nullopt;
}

/// A line that narrows a box, and the box as it was before.
struct Narrowing {
  std::size_t line;
  std::string kind;
  std::size_t place;  ///< of the lower bound among the words
  std::size_t variable;
  Box before;
};

/// All narrowings outside of case distinctions.
class Follower {
 public:
  explicit Follower(const std::vector<std::string>& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i) follow(i, words_of(lines[i]));
  }
  const std::vector<Narrowing>& narrowings() const { return narrowings_; }

 private:
  void follow(std::size_t line, const std::vector<std::string>& words) {
    if (words[0] == "start") {
      boxes_[words[1]] = box_of(words, 2);
    } else if (words[0] == "node") {
      const auto known = boxes_.find(words[1]);
      box_ = known == boxes_.end() ? std::nullopt : std::optional(known->second);
    } else if (words[0] == "cases") {
      box_.reset();
    } else if (!box_) {
      return;
    } else if (const auto place = place_of_claim(words[0])) {
      const std::size_t variable = std::stoul(words[*place - 1]);
      narrowings_.push_back({line, words[0], *place, variable, *box_});
      if (words[*place] != "empty")
        (*box_)[variable] = {value_of(words[*place]), value_of(words[*place + 1])};
    } else if (words.size() > 1 && words[1] == "cut") {
      const std::size_t variable = std::stoul(words[2]);
      boxes_[words[4]] = boxes_[words[5]] = *box_;
      boxes_[words[4]][variable].upper = boxes_[words[5]][variable].lower = value_of(words[3]);
    }
  }

  static Box box_of(const std::vector<std::string>& words, std::size_t first) {
    Box box;
    for (; first + 1 < words.size(); first += 2)
      box.emplace_back(value_of(words[first]), value_of(words[first + 1]));
    return box;
  }

  std::map<std::string, Box> boxes_;
  std::optional<Box> box_;
  std::vector<Narrowing> narrowings_;
};

bool contains_box(const Box& box, const Box& other) {
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (!subset(other[i], box[i])) return false;
  }
  return true;
}

std::vector<Box> roots_of(const SolvedSystem& run) {
  std::vector<Box> roots;
  for (const Json& solution : run.result["solutions"]) {
    Box& root = roots.emplace_back();
    for (const Json& side : solution["box"])
      root.emplace_back(value_of(side[0].get<std::string>()), value_of(side[1].get<std::string>()));
  }
  return roots;
}

/// By a thousandth at least: rounding alone takes off units in the last place, whatever the multipliers.
bool narrows_much(const Narrowing& narrowing, const std::vector<std::string>& words) {
  const double left = value_of(words[narrowing.place + 1]) - value_of(words[narrowing.place]);
  return left < 0.999 * width(narrowing.before[narrowing.variable]) && left > 1e-9;
}

/// The systems to which a contractor applies, solved with it.
std::vector<SolvedSystem> runs_of(const std::string& method, std::size_t maximum_boxes) {
  std::vector<SolvedSystem> runs;
  for (const EquationSystem& system : systems()) {
    try {
      runs.push_back(solved(system, solver_method_registry().at(method).contractor, maximum_boxes));
    } catch (const NotApplicable&) {  // Bernstein forms are of polynomials
    }
  }
  return runs;
}

class MethodProof : public testing::TestWithParam<std::string> {
 protected:
  /// Whether the run with that line in place of the old one is refused there.
  static bool is_refused_at(const SolvedSystem& run, std::vector<std::string> lines, std::size_t line,
                            const std::vector<std::string>& words) {
    lines[line] = joined(words, ' ');
    SolvedSystem copy = run;
    copy.proof = with_hash(joined(lines, '\n') + "\n");
    const VerificationReport report = copy.verified();
    return !report.accepted() && report.refusals.front().where == "proof:" + std::to_string(line + 1);
  }
};

TEST_P(MethodProof, IsAccepted) {
  const std::vector<SolvedSystem> runs = runs_of(GetParam(), 2000);
  EXPECT_GE(runs.size(), 7u);
  for (const SolvedSystem& run : runs) {
    const VerificationReport report = run.verified();
    EXPECT_TRUE(report.accepted()) << refusals_of(report);
    EXPECT_TRUE(report.completeness_proved);
  }
}

TEST_P(MethodProof, IsRefusedWhereABoundCutsARootAway) {
  std::size_t spoiled = 0;
  for (const SolvedSystem& run : runs_of(GetParam(), 2000)) {
    const std::vector<std::string> lines = lines_of(run.proof);
    const Follower follower(lines);
    for (const Narrowing& narrowing : follower.narrowings()) {
      for (const Box& root : roots_of(run)) {
        if (!contains_box(narrowing.before, root)) continue;
        std::vector<std::string> words = words_of(lines[narrowing.line]);
        const double past = std::nextafter(root[narrowing.variable].upper, 1e300);
        words[narrowing.place] = hexadecimal(past);
        if (!(past <= value_of(words[narrowing.place + 1]))) words[narrowing.place + 1] = hexadecimal(past);
        ASSERT_TRUE(is_refused_at(run, lines, narrowing.line, words)) << joined(words, ' ');
        ++spoiled;
      }
    }
  }
  EXPECT_GT(spoiled, 20u);
}

TEST_P(MethodProof, IsRefusedWhereARowRestsOnNothing) {
  constexpr std::size_t kTried = 30;
  std::map<std::string, std::size_t> tried;
  for (const SolvedSystem& run : runs_of(GetParam(), 300)) {
    const std::vector<std::string> lines = lines_of(run.proof);
    const Follower follower(lines);
    for (const Narrowing& narrowing : follower.narrowings()) {
      if (narrowing.kind.starts_with("hull") || tried[narrowing.kind]++ > kTried) continue;
      std::vector<std::string> words = words_of(lines[narrowing.line]);
      const bool is_empty = words[narrowing.place] == "empty";
      if (!is_empty && !narrows_much(narrowing, words)) continue;
      std::size_t multipliers = run.system.equations.size();
      if (narrowing.kind == "polytope") multipliers += run.system.inequalities.size();
      for (std::size_t k = 0; k < multipliers; ++k)
        words[narrowing.place + (is_empty ? 1 : 2) + k] = "0x0p+0";
      const auto is_multiple = [](const std::string& text) { return text == "q" || text == "m"; };
      words.erase(std::ranges::find_if(words, is_multiple), words.end());
      ASSERT_TRUE(is_refused_at(run, lines, narrowing.line, words)) << lines[narrowing.line];
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Every, MethodProof, testing::ValuesIn(solver_method_registry().names()));

TEST(MethodProofs, ContainEveryKindOfRow) {
  std::set<std::string> kinds;
  for (const SolverMethod& method : solver_method_registry().entries()) {
    for (const SolvedSystem& run : runs_of(method.name, 300)) {
      for (const std::string& line : lines_of(run.proof)) {
        const std::string word = words_of(line)[0];
        if (place_of_claim(word)) kinds.insert(word);
        if (std::ranges::count(words_of(line), "q") > 0) kinds.insert(word + " with quotients");
        if (std::ranges::count(words_of(line), "m") > 0) kinds.insert(word + " with products");
      }
    }
  }
  const std::set<std::string> expected = {"hull_equation",
                                          "hull_inequality",
                                          "expansion_row",
                                          "square_row",
                                          "mean_value_row",
                                          "bernstein_row",
                                          "polytope",
                                          "expansion_row with quotients",
                                          "expansion_row with products",
                                          "square_row with products"};
  EXPECT_EQ(kinds, expected);
}

TEST(BernsteinRow, ProvesWhatTheConvexHullAndItsPartsProve) {
  // 4x^2 + x - 3 on [0, 1]: coefficients -3, -5/2, 2. The hull leaves [3/5, 7/9], the polynomial 3/4.
  const EquationSystem system = system_of({"x"}, {"4*x^2 + x - 3"}, {{0, 1}});
  const auto verdict = [&](double lower, double upper, const std::string& multiplier) {
    SolvedSystem run;
    run.system = system;
    const Box left = {{lower, upper}};
    run.result = {{"status", "partial"},
                  {"completeness", "proved"},
                  {"variables", {"x"}},
                  {"solutions", Json::array()},
                  {"undecided", {{{"box", box_json(left)}, {"reason", "test"}}}}};
    run.proof = with_hash(
        "gcslab-proof 1\nbox 0x0p+0 0x1p+0\nstart 0 0x0p+0 0x1p+0\nnode 0\nexpansion\n"
        "bernstein_row 0 " +
        hexadecimal(lower) + " " + hexadecimal(upper) + " " + multiplier + "\nend undecided\nend\n");
    run.sign();
    return run.verified().accepted();
  };
  EXPECT_TRUE(verdict(std::nextafter(0.6, 0), std::nextafter(7.0 / 9, 1), "0x1p+0"));
  EXPECT_TRUE(verdict(0.75, 0.75, "0x1p+0") ||
              verdict(std::nextafter(0.75, 0), std::nextafter(0.75, 1), "0x1p+0"));
  EXPECT_TRUE(verdict(0.7, 0.76, "-0x1.8p+1"));
  EXPECT_FALSE(verdict(0.7, 0.74, "0x1p+0"));
  EXPECT_FALSE(verdict(std::nextafter(0.75, 1), 0.76, "0x1p+0"));
  EXPECT_FALSE(verdict(0.7, 0.76, "0x0p+0"));
}

TEST(BernsteinRow, IsRefusedForEquationsThatAreNoPolynomials) {
  SolvedSystem run;
  run.system = system_of({"x"}, {"sin(x) - 1/2"}, {{0, 1}});
  run.result = {{"status", "complete"},
                {"completeness", "proved"},
                {"variables", {"x"}},
                {"solutions", Json::array()},
                {"undecided", Json::array()}};
  run.proof = with_hash(
      "gcslab-proof 1\nbox 0x0p+0 0x1p+0\nstart 0 0x0p+0 0x1p+0\nnode 0\nexpansion\n"
      "bernstein_row 0 empty 0x1p+0\nend empty\nend\n");
  run.sign();
  EXPECT_FALSE(run.verified().accepted());
}

}  // namespace
}  // namespace gcslab
