#include "box_solver/equation_multiples.h"

#include <algorithm>
#include <set>

namespace gcslab {
namespace {

int degree_of(const Exponents& exponents) {
  int degree = 0;
  for (const int e : exponents) degree += e;
  return degree;
}

Exponents sum_of(Exponents a, const Exponents& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

/// With repetition.
std::vector<std::uint32_t> variables_of(const Exponents& exponents) {
  std::vector<std::uint32_t> result;
  for (std::size_t i = 0; i < exponents.size(); ++i)
    result.insert(result.end(), static_cast<std::size_t>(exponents[i]), static_cast<std::uint32_t>(i));
  return result;
}

/// Whether it is x_variable g + c with a constant c other than 0 and a g of further variables.
bool has_quotient(const Polynomial& polynomial, std::size_t variable) {
  bool has_constant = false, has_others = false;
  for (const auto& [exponents, coefficient] : polynomial.terms()) {
    const int degree = degree_of(exponents);
    has_constant = has_constant || degree == 0;
    if (degree > 0 && exponents[variable] == 0) return false;
    has_others = has_others || degree > exponents[variable];
  }
  return has_constant && has_others;
}

/// The monomials of all equations that are polynomials.
std::set<Exponents> support_of(const std::vector<SystemFunction>& equations) {
  std::set<Exponents> support;
  for (const SystemFunction& equation : equations) {
    if (!equation.polynomial) continue;
    for (const auto& [exponents, coefficient] : equation.polynomial->terms()) support.insert(exponents);
  }
  return support;
}

/// The monomials other than 1 whose products with the polynomial have all their monomials in the support.
std::vector<Exponents> closed_factors(const Polynomial& polynomial, const std::set<Exponents>& support) {
  std::vector<Exponents> factors;
  const auto& terms = polynomial.terms();
  for (Exponents factor : support) {  // to which the first term is brought
    for (std::size_t i = 0; i < factor.size(); ++i) factor[i] -= terms.begin()->first[i];
    const bool is_monomial = std::ranges::all_of(factor, [](int e) { return e >= 0; });
    const auto occurs = [&](const auto& term) { return support.contains(sum_of(term.first, factor)); };
    if (!is_monomial || degree_of(factor) == 0 || degree_of(factor) > kMaximumFactorDegree) continue;
    if (std::ranges::all_of(terms, occurs)) factors.push_back(std::move(factor));
  }
  return factors;
}

Polynomial times(const Polynomial& polynomial, const Exponents& factor) {
  Polynomial product(polynomial.variables());
  for (const auto& [exponents, coefficient] : polynomial.terms())
    product.add_term(sum_of(exponents, factor), coefficient);
  return product;
}

}  // namespace

std::size_t expansion_terms(const Polynomial& polynomial) {
  std::size_t count = 0;
  for (const auto& [exponents, coefficient] : polynomial.terms()) {
    std::size_t product = 1;
    for (const int e : exponents)
      product = std::min(product * static_cast<std::size_t>(e + 1), kMaximumExpansionTerms + 1);
    count = std::min(count + product, kMaximumExpansionTerms + 1);
  }
  return count;
}

std::vector<EquationMultiple> multiples_of(const SystemFunctions& functions) {
  std::vector<EquationMultiple> multiples;
  const std::set<Exponents> support = support_of(functions.equations());
  for (std::size_t k = 0; k < functions.equations().size(); ++k) {
    const SystemFunction& equation = functions.equations()[k];
    if (!equation.polynomial || equation.polynomial->terms().empty()) continue;
    const Polynomial& polynomial = *equation.polynomial;
    if (expansion_terms(polynomial) > kMaximumExpansionTerms) continue;
    std::size_t left = kMaximumExpansionTerms;
    const auto add_if_it_fits = [&](std::size_t terms, std::vector<std::uint32_t> variables,
                                    bool is_quotient) {
      if (terms > left) return;
      left -= terms;
      multiples.push_back({static_cast<std::uint32_t>(k), std::move(variables), is_quotient});
    };
    for (const std::size_t i : equation.variables) {
      if (has_quotient(polynomial, i))
        add_if_it_fits(expansion_terms(polynomial), {static_cast<std::uint32_t>(i)}, true);
    }
    for (const Exponents& factor : closed_factors(polynomial, support))
      add_if_it_fits(expansion_terms(times(polynomial, factor)), variables_of(factor), false);
  }
  return multiples;
}

Polynomial product_of_multiple(const Polynomial& equation, const EquationMultiple& multiple) {
  Exponents factor(static_cast<std::size_t>(equation.variables()), 0);
  for (const std::uint32_t i : multiple.variables) ++factor[i];
  return times(equation, factor);
}

std::pair<Polynomial, Rational> quotient_of_multiple(const Polynomial& equation,
                                                     const EquationMultiple& multiple) {
  std::pair<Polynomial, Rational> result{Polynomial(equation.variables()), Rational(0)};
  for (const auto& [exponents, coefficient] : equation.terms()) {
    if (degree_of(exponents) == 0) {
      result.second = coefficient;
      continue;
    }
    Exponents divided = exponents;
    --divided[multiple.variables[0]];
    result.first.add_term(divided, coefficient);
  }
  return result;
}

}  // namespace gcslab
