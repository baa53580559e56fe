#include "polynomial/horner.h"

#include <algorithm>
#include <functional>

namespace gcslab {
namespace {

using Term = std::pair<Exponents, Rational>;
using TermList = std::vector<Term>;

/// The variable that occurs in most terms; the first such one; -1 when none occurs twice.
int most_frequent_variable(const TermList& terms) {
  int best = -1;
  std::ptrdiff_t best_count = 1;
  for (std::size_t i = 0; i < terms.front().first.size(); ++i) {
    const auto count = std::ranges::count_if(terms, [i](const Term& term) { return term.first[i] > 0; });
    if (count <= best_count) continue;
    best = static_cast<int>(i);
    best_count = count;
  }
  return best;
}

/// Divides the terms by the largest monomial that divides all of them, and returns it.
Exponents take_shared_monomial(TermList& terms) {
  Exponents shared = terms.front().first;
  for (const Term& term : terms) {
    std::ranges::transform(shared, term.first, shared.begin(), [](int a, int b) { return std::min(a, b); });
  }
  for (Term& term : terms) {
    std::ranges::transform(term.first, shared, term.first.begin(), std::minus<>());
  }
  return shared;
}

Expression sum_of_monomials(const TermList& terms, ExpressionGraph& graph) {
  Expression result = graph.constant(0);
  for (const auto& [exponents, coefficient] : terms) {
    result = result + graph.constant(coefficient) * monomial_expression(graph, exponents);
  }
  return result;
}

Expression horner_of(TermList terms, ExpressionGraph& graph) {
  if (terms.empty()) return graph.constant(0);
  const int variable = most_frequent_variable(terms);
  if (variable < 0) return sum_of_monomials(terms, graph);
  const auto x = static_cast<std::size_t>(variable);
  const auto rest =
      std::stable_partition(terms.begin(), terms.end(), [x](const Term& term) { return term.first[x] > 0; });
  const TermList without(std::make_move_iterator(rest), std::make_move_iterator(terms.end()));
  terms.erase(rest, terms.end());
  const Exponents shared = take_shared_monomial(terms);
  return monomial_expression(graph, shared) * horner_of(std::move(terms), graph) + horner_of(without, graph);
}

}  // namespace

Expression horner_form(const Polynomial& polynomial, ExpressionGraph& graph) {
  return horner_of(TermList(polynomial.terms().rbegin(), polynomial.terms().rend()), graph);
}

}  // namespace gcslab
