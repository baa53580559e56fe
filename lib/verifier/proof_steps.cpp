// The steps inside a node of a proof.

#include <algorithm>
#include <cmath>
#include <map>

#include "verifier/proof_replay.h"

namespace gcslab::verifier {

/// One step; false after the end of the node.
bool ProofReplay::read_step(std::string_view word) {
  if (word == "end") {
    end_node();
    return false;
  }
  if (word == "otherwise") {
    open_other_case();
  } else if (word == "join") {
    join_cases();
  } else if (part_.is_empty) {
    reader_->refuse("nothing is left of the box, so that '" + std::string(word) + "' has no place here");
  } else if (word == "hull_equation" || word == "hull_inequality") {
    read_propagation(word == "hull_equation");
  } else if (word == "expansion") {
    read_expansion();
  } else if (word == "expansion_row" || word == "square_row" || word == "mean_value_row" ||
             word == "bernstein_row") {
    read_row(word);
  } else if (word == "polytope") {
    read_polytope();
  } else if (word == "cases") {
    open_cases();
  } else {
    reader_->refuse("'" + std::string(word) + "' is no step that can be proved again");
  }
  return true;
}

/// Accepts a claim about a variable that contains what is proved.
void ProofReplay::take_claim(std::size_t variable, const Interval& claim, const Range& proved) {
  if (!proved.is_within(claim)) {
    const std::string left = to_string(proved.outward());
    reader_->refuse(is_empty(claim)
                        ? "a root may be left: the variable is only proved to lie in " + left
                        : "the variable is only proved to lie in " + left + ", not in " + to_string(claim));
  }
  Interval& side = part_.box[variable];
  side = intersection(side, claim);
  part_.is_empty = is_empty(side);
  ++summary_.counts["narrowings"];
}

void ProofReplay::read_propagation(bool is_equation) {
  const std::size_t count = (is_equation ? system_->equations() : system_->inequalities()).size();
  const std::size_t function = reader_->index(count, is_equation ? "equation" : "inequality");
  const std::size_t variable = reader_->index(system_->variables(), "variable");
  const Interval claim = reader_->interval_or_empty();
  reader_->end_line();
  take_claim(variable, claim, judge_.propagate(is_equation, function, variable, part_.box, claim));
}

void ProofReplay::read_expansion() {
  Box terms;
  if (!reader_->at_end_of_line()) terms = reader_->box(judge_.terms().size());
  reader_->end_line();
  for (const Box* box : {&part_.box, &terms}) {
    if (!std::ranges::all_of(*box, is_bounded))
      reader_->refuse("the box is unbounded: it has no midpoint to expand about");
  }
  if (!terms.empty() && !judge_.terms().lie_within(terms, part_.box))
    reader_->refuse("the sides named do not contain the terms");
  part_.expansion = judge_.expansion_about(part_.box, std::move(terms));
}

std::size_t ProofReplay::read_claim(Interval& claim, std::size_t equations) {
  const std::size_t variable = reader_->index(system_->variables(), "variable");
  claim = reader_->interval_or_empty();
  multipliers_.clear();
  for (std::size_t k = 0; k < equations; ++k) multipliers_.push_back(read_multiplier());
  return variable;
}

double ProofReplay::read_multiplier() {
  const double multiplier = reader_->number();
  if (!std::isfinite(multiplier)) reader_->refuse("a multiplier is infinite");
  return multiplier;
}

void ProofReplay::read_row(std::string_view word) {
  Interval claim;
  const std::size_t variable = read_claim(claim, system_->equations().size());
  const bool is_expanded = word == "expansion_row" || word == "square_row";
  EquationSum sum{multipliers_};
  while (is_expanded && !reader_->at_end_of_line()) sum.multiples.push_back(read_multiple());
  reader_->end_line();
  if (part_.expansion.number == 0) reader_->refuse("no 'expansion' came before");
  if (word == "bernstein_row" && !judge_.bernstein_refusal().empty())
    reader_->refuse(judge_.bernstein_refusal());
  const Range proved =
      word == "bernstein_row"
          ? judge_.bernstein_row(part_.expansion, variable, multipliers_, claim, part_.box)
      : word == "mean_value_row" ? judge_.mean_value_row(part_.expansion, variable, multipliers_, part_.box)
      : word == "square_row"     ? judge_.square_row(part_.expansion, variable, sum, part_.box)
                                 : judge_.expansion_row(part_.expansion, variable, sum, part_.box);
  take_claim(variable, claim, proved);
}

std::pair<EquationMultiple, double> ProofReplay::read_multiple() {
  constexpr int kMaximumFactors = 16;
  const std::string_view kind = reader_->word();
  if (kind != "q" && kind != "m") reader_->refuse("'" + std::string(kind) + "' is none of q, m");
  EquationMultiple multiple{reader_->index(system_->equations().size(), "equation"), {}, kind == "q"};
  multiple.factor = monomial(reader_->word(), system_->variables());
  int factors = 0;
  for (const auto& [variable, power] : multiple.factor) factors += power;
  if (multiple.is_quotient && factors != 1) reader_->refuse("a quotient is by one variable");
  if (factors > kMaximumFactors) reader_->refuse("a product by too many variables");
  if (!judge_.has_multiple(multiple)) {
    reader_->refuse(
        multiple.is_quotient
            ? "that equation has no quotient by that variable: it is no polynomial whose terms all "
              "contain the variable, but for a constant, or too large a one"
            : "that equation has no product: it is no polynomial, or too large a one");
  }
  reader_->expect(":");
  return {multiple, read_multiplier()};
}

void ProofReplay::read_polytope() {
  if (part_.expansion.number == 0) reader_->refuse("no 'expansion' came before");
  JudgedSystem& functions = judge_.expanded_system(part_.expansion);
  Interval claim;
  const std::size_t variable = read_claim(claim, functions.equations().size());
  for (std::size_t k = 0; k < functions.inequalities().size(); ++k) {
    multipliers_.push_back(read_multiplier());
    if (multipliers_.back() > 0) reader_->refuse("the multiplier of an inequality is positive");
  }
  reader_->expect(";");
  PolytopeSum sum{multipliers_, {}, {}};
  while (!reader_->at_end_of_line()) {
    const std::string_view kind = reader_->word();
    if (kind == "g") {
      sum.strips.push_back(read_strip());
    } else {
      sum.products.push_back(read_product(kind, functions.variables()));
    }
  }
  reader_->end_line();
  take_claim(variable, claim, judge_.polytope(part_.expansion, variable, sum, part_.box));
}

GraphStrip ProofReplay::read_strip() {
  if (part_.expansion.terms.empty()) reader_->refuse("the last 'expansion' names no terms");
  const std::size_t term = reader_->index(judge_.terms().size(), "term");
  if (!judge_.terms().argument(term)) reader_->refuse("that term is no function of one variable");
  const double slope = read_multiplier();
  reader_->expect(":");
  return {term, slope, read_multiplier()};
}

PositiveProduct ProofReplay::read_product(std::string_view kind, std::size_t variables) {
  constexpr std::size_t kMaximumFactors = 8;  // 2^8 terms
  PositiveProduct product{};
  if (kind != "p" && kind != "s") reader_->refuse("'" + std::string(kind) + "' is none of p, s, g");
  product.is_square = kind == "s";
  for (std::string_view text = reader_->word(); text != ":"; text = reader_->word())
    product.factors.push_back(signed_monomial(text, variables));
  if (product.factors.empty()) reader_->refuse("a product without factors");
  if (product.factors.size() > kMaximumFactors) reader_->refuse("a product of too many factors");
  product.multiplier = read_multiplier();
  if (product.multiplier < 0) reader_->refuse("the multiplier of a product is negative");
  return product;
}

/// A sign, then variables joined by '*', with repetition.
std::pair<int, Monomial> ProofReplay::signed_monomial(std::string_view text, std::size_t variables) {
  if (text.empty() || (text[0] != '+' && text[0] != '-'))
    reader_->refuse("'" + std::string(text) + "' has no sign");
  return {text[0] == '+' ? 1 : -1, monomial(text.substr(1), variables)};
}

/// Variables joined by '*', with repetition.
Monomial ProofReplay::monomial(std::string_view text, std::size_t variables) {
  std::map<std::uint32_t, int> powers;
  for (const std::size_t variable : reader_->joined_indices(text, variables, "variable"))
    ++powers[static_cast<std::uint32_t>(variable)];
  return {powers.begin(), powers.end()};
}

void ProofReplay::open_cases() {
  const std::size_t variable = reader_->index(system_->variables(), "variable");
  const double point = reader_->number();
  reader_->end_line();
  if (!contains(part_.box[variable], point)) reader_->refuse("the cases part the box outside of itself");
  cases_.push_back({part_, variable, point, std::nullopt});
  part_.box[variable].upper = point;
  judge_.forget_propagation();
}

void ProofReplay::open_other_case() {
  reader_->end_line();
  if (cases_.empty() || cases_.back().first) reader_->refuse("'otherwise' without 'cases'");
  Cases& cases = cases_.back();
  cases.first = std::move(part_);
  part_ = cases.before;
  part_.box[cases.variable].lower = cases.point;
  judge_.forget_propagation();
}

/// What is left of both cases together; expansions are those from before.
void ProofReplay::join_cases() {
  reader_->end_line();
  if (cases_.empty() || !cases_.back().first) reader_->refuse("'join' without 'cases' and 'otherwise'");
  Cases& cases = cases_.back();
  Part joined{part_.box, part_.is_empty && cases.first->is_empty, std::move(cases.before.expansion)};
  if (part_.is_empty) {
    joined.box = cases.first->box;
  } else if (!cases.first->is_empty) {
    for (std::size_t i = 0; i < joined.box.size(); ++i)
      joined.box[i] = hull(joined.box[i], cases.first->box[i]);
  }
  part_ = std::move(joined);
  cases_.pop_back();
  judge_.forget_propagation();
  ++summary_.counts["case distinctions"];
}

}  // namespace gcslab::verifier
