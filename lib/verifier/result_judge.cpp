#include "verifier/result_judge.h"

#include <algorithm>
#include <cmath>

#include "verifier/box_relations.h"

namespace gcslab::verifier {
namespace {

/// What each theorem shows.
const std::map<std::string, std::string>& claims_of_theorems() {
  static const std::map<std::string, std::string> claims = {
      {"krawczyk", "unique"},       {"interval_newton", "unique"},
      {"kantorovich", "unique"},    {"descartes", "unique"},
      {"angle_sum", "unique"},      {"miranda", "exists"},
      {"elber_kim", "at_most_one"}, {"slope_regularity", "at_most_one"}};
  return claims;
}

}  // namespace

ResultJudge::ResultJudge(const EquationSystem& system, const Box& search_box, JudgedSystem& judged,
                         VerificationReport& report)
    : system_(&system),
      search_box_(&search_box),
      judged_(&judged),
      report_(&report),
      prover_(judged),
      miranda_(judged) {
  if (judged.variables() != 1 || judged.equations().size() != 1) return;
  const std::optional<PolynomialTerms>& terms = judged.equations()[0].polynomial;
  if (terms && !terms->empty()) counter_.emplace(*terms);
}

/// Runs a judgement; what it refuses goes to the report.
template <class Judgement>
void ResultJudge::attempt(Judgement judgement) {
  try {
    judgement();
  } catch (const Refused& refused) {
    report_->refusals.push_back({refused.where(), refused.what()});
  }
}

void ResultJudge::judge(const nlohmann::json& result) {
  const JsonPlace root(result, "");
  attempt([&] { judge_hash(root); });
  attempt([&] { judge_variables(root); });
  attempt([&] {
    for (const JsonPlace& place : root.at("solutions").items()) attempt([&] { judge_solution(place); });
    judge_distinct(root.at("solutions"));
  });
  attempt([&] {
    for (const JsonPlace& place : root.at("undecided").items()) attempt([&] { judge_undecided(place); });
  });
  if (counter_) count_roots();
  attempt([&] { note_unchecked(root); });
  for (const auto& [claim, number] : counts_) report_->checked.push_back({claim, number});
}

void ResultJudge::judge_hash(const JsonPlace& result) {
  const JsonPlace hash = result.at("content_hash");
  if (hash.text() != result_hash(result.value()))
    hash.refuse("is not the hash of the content: the file was edited");
  count("content hash");
}

void ResultJudge::judge_variables(const JsonPlace& result) {
  const JsonPlace place = result.at("variables");
  std::vector<std::string> names;
  for (const JsonPlace& name : place.items()) names.push_back(name.text());
  if (names != system_->variables) place.refuse("are not the variables of the problem, in its order");
  count("names of variables");
}

void ResultJudge::judge_solution(const JsonPlace& place) {
  if (place.at("kind").word({"real", "complex"}) == "complex") return judge_complex(place);
  Solution solution;
  const JsonPlace box = place.at("box");
  solution.box = box.box(judged_->variables());
  if (is_disjoint(solution.box, *search_box_)) box.refuse("misses the search box");
  judge_certificate(place, solution);
  attempt([&] { judge_multiplicity(place, solution); });
  attempt([&] { judge_point(place, solution); });
  attempt([&] { judge_inequalities(place, solution); });
  solutions_.push_back(std::move(solution));
}

void ResultJudge::judge_complex(const JsonPlace& place) {
  if (place.at("certificate").at("claim").word({"unique", "exists", "none"}) != "none")
    place.refuse("certificates of complex solutions are not proved here");
  report_->not_checked.push_back(place.pointer() + ": a complex solution without certificate");
}

void ResultJudge::judge_certificate(const JsonPlace& place, Solution& solution) {
  const JsonPlace certificate = place.at("certificate");
  solution.claim = certificate.at("claim").word({"unique", "exists", "none"});
  if (solution.claim == "none") {
    if (const auto evidence = certificate.find("evidence"); evidence && !evidence->items().empty())
      evidence->refuse("is given for a certificate that claims nothing");
    report_->not_checked.push_back(place.pointer() + ": a solution without certificate");
    return;
  }
  solution.root = enclosed_root(solution.box);
  if (!solution.root && (solution.claim == "unique" || !miranda_.contains_root(solution.box)))
    place.at("box").refuse("is not proved to contain a root");
  count("solutions: the box contains a root");
  const std::optional<JsonPlace> uniqueness = place.find("uniqueness_box");
  if (solution.claim == "unique" || uniqueness) {
    if (!solution.root) uniqueness->refuse("is not proved to contain no other root");
    const Box widest = uniqueness ? uniqueness->box(judged_->variables()) : solution.box;
    const JsonPlace where = uniqueness ? *uniqueness : place.at("box");
    if (!is_subset(solution.box, widest)) where.refuse("does not contain the box of the solution");
    if (!has_no_other(widest, *solution.root)) where.refuse("is not proved to contain no other root");
    count("solutions: the uniqueness box contains no other root");
    listed_.roots.push_back({*solution.root, widest});
  }
  if (const auto evidence = certificate.find("evidence"))
    attempt([&] { judge_all_evidence(*evidence, solution); });
}

/// A root in the box; a multiple one is proved to be the only one there by counting.
std::optional<EnclosedRoot> ResultJudge::enclosed_root(const Box& box) {
  std::optional<EnclosedRoot> root = prover_.enclose(box);
  if (root || !counter_ || counter_->count(box[0]) != 1) return root;
  return EnclosedRoot{ranges_of(box), {}};
}

bool ResultJudge::has_no_other(const Box& box, const EnclosedRoot& root) {
  if (!counter_) return prover_.has_no_other(box, root);
  return is_within(root.enclosure, box) && counter_->count(box[0]) == 1;
}

/// Whether the boxes listed contain every root in the search box.
void ResultJudge::count_roots() {
  listed_.counter = &*counter_;
  for (const Solution& solution : solutions_) listed_.parts.push_back(solution.box[0]);
  for (const Box& box : listed_.undecided) listed_.parts.push_back(box[0]);
  report_->completeness_proved = listed_.holds_all_roots(search_box_->front(), {});
  if (report_->completeness_proved) count("completeness: no roots beside those in the boxes, by counting");
}

/// Where evidence is given it must amount to the claim.
void ResultJudge::judge_all_evidence(const JsonPlace& list, const Solution& solution) {
  bool shows_existence = false;
  bool shows_uniqueness = false;
  for (const JsonPlace& item : list.items()) {
    const std::string claim = judge_evidence(item, solution);
    shows_existence = shows_existence || claim != "at_most_one";
    shows_uniqueness = shows_uniqueness || claim != "exists";
  }
  if (list.items().empty()) return;
  if (!shows_existence) list.refuse("does not show that a root exists");
  if (solution.claim == "unique" && !shows_uniqueness) list.refuse("does not show that the root is alone");
}

/// One theorem applied to one box: the verifier proves the claim, by its own theorem. Returns the claim.
std::string ResultJudge::judge_evidence(const JsonPlace& evidence, const Solution& solution) {
  const JsonPlace type = evidence.at("type");
  const auto theorem = claims_of_theorems().find(type.text());
  if (theorem == claims_of_theorems().end()) type.refuse("is no theorem that is known here");
  const std::string claim = evidence.at("claim").word({"unique", "exists", "at_most_one"});
  if (claim != theorem->second) evidence.at("claim").refuse("is not what this theorem shows");
  const JsonPlace place = evidence.at("box");
  const Box box = place.box(judged_->variables());
  const bool is_there =
      solution.root ? is_within(solution.root->enclosure, box) : miranda_.contains_root(box);
  if (claim != "at_most_one" && !is_there) place.refuse("is not proved to contain the root");
  if (claim != "exists" && !(solution.root && has_no_other(box, *solution.root)))
    place.refuse("is not proved to contain no other root");
  count("solutions: evidence");
  return claim;
}

void ResultJudge::judge_multiplicity(const JsonPlace& place, const Solution& solution) {
  const auto isolated = place.find("isolated");
  const auto multiplicity = place.find("multiplicity");
  const bool is_isolated = solution.root.has_value();
  if (isolated && isolated->word({"proved", "no", "unknown"}) != "unknown") {
    if ((isolated->text() == "proved") != is_isolated) isolated->refuse("is not proved");
    count("solutions: the root is isolated");
  }
  if (!multiplicity) return;
  if (!is_isolated) {
    report_->not_checked.push_back(multiplicity->pointer());
    return;
  }
  const bool is_simple = !solution.root->inverse.empty();
  const int proved = is_simple ? 1 : counter_->multiplicity(solution.box[0]);
  if (multiplicity->number() != proved) {
    multiplicity->refuse(is_simple ? "is not 1, but the Jacobian at the root is regular"
                                   : "is not " + std::to_string(proved) + ", as counted");
  }
  count(proved == 1 ? "solutions: the root is simple" : "solutions: the multiplicity of the root");
}

void ResultJudge::judge_point(const JsonPlace& place, const Solution& solution) {
  const JsonPlace where = place.at("point");
  std::vector<double> point;
  for (const JsonPlace& coordinate : where.items()) point.push_back(coordinate.number());
  if (point.size() != solution.box.size()) where.refuse("has not one coordinate a variable");
  for (std::size_t i = 0; i < point.size(); ++i) {
    if (!contains(solution.box[i], point[i])) where.refuse("lies outside of the solution's box");
  }
  count("solutions: the point lies in the box");
  const auto residual = place.find("residual");
  if (residual && !residual->value().is_null()) judge_residual(*residual, point);
}

/// The largest |f_k| at the point, give or take the rounding errors of doubles.
void ResultJudge::judge_residual(const JsonPlace& residual, const std::vector<double>& point) {
  const double claimed = residual.number();
  RangeBox box;
  for (const double x : point) box.emplace_back(x);
  double lower = 0;
  double upper = 0;
  for (JudgedFunction& equation : judged_->equations()) {
    const Interval value = abs(equation.program.evaluate(box)).outward();
    double error = std::numeric_limits<double>::infinity();
    if (equation.program.is_defined_everywhere()) {
      equation.program.gradient();
      error = equation.program.double_rounding_error();
    }
    lower = std::max(lower, value.lower - error);
    upper = std::max(upper, value.upper + error);
  }
  if (!(claimed >= lower * (1 - 1e-9) && claimed <= upper * (1 + 1e-9)))
    residual.refuse("is not the largest |f| at the point, to rounding");
  count("solutions: residual");
}

void ResultJudge::judge_inequalities(const JsonPlace& place, const Solution& solution) {
  const auto state = place.find("inequalities");
  if (state) state->word({"proved", "undecided"});
  const bool claims = state && state->text() == "proved";
  const RangeBox where = place_of(solution);
  for (JudgedFunction& inequality : judged_->inequalities()) {
    const Range value = inequality.program.evaluate(where);
    if (value.is_empty() || mpfr_sgn(value.lower()) > 0) place.refuse("violates an inequality");
    if (claims && (mpfr_sgn(value.upper()) > 0 || !inequality.program.is_defined_everywhere()))
      state->refuse("an inequality is not proved");
    if (claims) count("solutions: inequalities");
  }
}

RangeBox ResultJudge::place_of(const Solution& solution) {
  return solution.root ? solution.root->enclosure : ranges_of(solution.box);
}

void ResultJudge::judge_distinct(const JsonPlace& solutions) {
  for (std::size_t i = 0; i < solutions_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (solutions_[i].claim == "none" || solutions_[j].claim == "none") continue;
      if (!are_apart(place_of(solutions_[i]), place_of(solutions_[j]))) {
        solutions.refuse("lists a root twice: in " + to_string(solutions_[i].box.front()) + " ... and in " +
                         to_string(solutions_[j].box.front()) + " ...");
      }
      count("pairs of solutions: different roots");
    }
  }
}

void ResultJudge::judge_undecided(const JsonPlace& place) {
  place.at("reason").text();
  listed_.undecided.push_back(place.at("box").box(judged_->variables()));
}

void ResultJudge::note_unchecked(const JsonPlace& result) {
  static const std::vector<std::string> judged = {"content_hash", "variables",    "solutions",
                                                  "undecided",    "completeness", "status"};
  for (const auto& [key, value] : result.value().items()) {
    if (std::ranges::find(judged, key) == judged.end()) report_->not_checked.push_back("/" + key);
  }
}

void ResultJudge::judge_summary(const nlohmann::json& result, bool has_proof) {
  const JsonPlace root(result, "");
  attempt([&] {
    const JsonPlace completeness = root.at("completeness");
    const JsonPlace status = root.at("status");
    const std::string word = completeness.word({"proved", "probable", "none"});
    status.word({"complete", "partial", "budget_exhausted", "not_applicable", "failed"});
    if (word == "proved" && has_proof && !report_->completeness_proved)
      completeness.refuse("is not proved by the proof file");
    if (word == "proved" && !has_proof && !report_->completeness_proved)
      report_->not_checked.push_back("/completeness: that nothing is missing; give the proof file");
    if (word == "probable") report_->not_checked.push_back("/completeness: probable");
    const bool is_complete = word == "proved" && listed_.undecided.empty();
    if (status.text() == "complete" && !is_complete)
      status.refuse("is complete, but completeness is not proved or a box is undecided");
    if (status.text() == "partial" && is_complete)
      status.refuse("is partial, but completeness is proved and nothing is undecided");
    report_->checked.push_back({"status and completeness agree", 1});
  });
}

}  // namespace gcslab::verifier
