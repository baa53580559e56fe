#include "box_solver/expansion.h"

#include <algorithm>

#include "base/check.h"
#include "box_solver/equation_multiples.h"
#include "interval/arithmetic.h"
#include "polynomial/tensor.h"

namespace gcslab {
namespace {

Rational binomial(int n, int k) {
  Rational result;
  mpz_bin_uiui(result.get_num_mpz_t(), static_cast<unsigned long>(n), static_cast<unsigned long>(k));
  return result;
}

ScaledMonomial monomial_of(const Exponents& exponents) {
  ScaledMonomial result;
  for (std::size_t i = 0; i < exponents.size(); ++i) {
    if (exponents[i] > 0) result.factors.push_back({static_cast<std::uint32_t>(i), exponents[i]});
  }
  return result;
}

}  // namespace

ExpansionPlan::ExpansionPlan(const SystemFunctions& functions, ExpandedFunctions which)
    : functions_(&functions), products_(1) {
  for (std::size_t i = 0; i < functions.variables(); ++i) {
    Exponents exponents(functions.variables(), 0);
    exponents[i] = 1;
    static_cast<void>(column_of(exponents));
  }
  for (const SystemFunction& equation : functions.equations()) add_row(equation);
  if (which == ExpandedFunctions::equations_and_multiples) {
    for (const EquationMultiple& multiple : multiples_of(functions)) add_multiple(multiple);
  }
  equation_columns_ = columns_.size();
  if (which != ExpandedFunctions::constraints) return;
  for (const SystemFunction& inequality : functions.inequalities()) add_row(inequality);
}

const SystemFunction& ExpansionPlan::function(std::size_t row) const {
  const std::size_t equations = functions_->equations().size();
  if (row < equations) return functions_->equations()[row];
  if (row < equations + multiples_.size())
    return functions_->equations()[multiples_[row - equations].equation];
  return functions_->inequalities()[row - equations];
}

void ExpansionPlan::add_row(const SystemFunction& function) {
  rows_.emplace_back();
  if (function.polynomial && expansion_terms(*function.polynomial) <= kMaximumExpansionTerms)
    add_entries(expanded(*function.polynomial));
}

/// A quotient's constant over its variable, and the polynomial of the multiple.
void ExpansionPlan::add_multiple(const EquationMultiple& multiple) {
  const Polynomial& equation = *functions_->equations()[multiple.equation].polynomial;
  multiples_.push_back(multiple);
  rows_.emplace_back();
  if (!multiple.is_quotient) {
    add_entries(expanded(product_of_multiple(equation, multiple)));
    return;
  }
  const std::uint32_t variable = multiple.variables[0];
  const auto [g, constant] = quotient_of_multiple(equation, multiple);
  Entries entries = expanded(g);
  Exponents linear(functions_->variables(), 0);
  linear[variable] = 1;
  // The column of c / x_variable, which need not occur in g.
  if (entries[linear].empty()) entries[linear].push_back({0, Exponents(functions_->variables(), 0)});
  add_entries(entries);
  Row& row = rows_.back();
  const auto place = std::ranges::find(row.entries, variable, &Entry::column);
  row.reciprocal = Reciprocal{static_cast<std::uint32_t>(coefficients_.size()), variable,
                              static_cast<std::size_t>(place - row.entries.begin())};
  coefficients_.push_back(constant);
}

ExpansionPlan::Entries ExpansionPlan::expanded(const Polynomial& polynomial) {
  Entries entries;
  for (const auto& [exponents, coefficient] : polynomial.terms()) {
    Exponents taken(exponents.size(), 0);
    do {
      Contribution part{coefficient, exponents};
      for (std::size_t i = 0; i < exponents.size(); ++i) {
        part.coefficient *= binomial(exponents[i], taken[i]);
        part.midpoint_powers[i] -= taken[i];
      }
      entries[taken].push_back(std::move(part));
    } while (next_index(taken, exponents));
  }
  return entries;
}

void ExpansionPlan::add_entries(const Entries& entries) {
  for (const auto& [exponents, contributions] : entries) {
    const bool is_constant = std::ranges::all_of(exponents, [](int e) { return e == 0; });
    Entry entry{is_constant ? kConstant : column_of(exponents), product_of(exponents),
                static_cast<std::uint32_t>(terms_.size()), 0};
    for (const Contribution& part : contributions) {
      terms_.push_back({static_cast<std::uint32_t>(coefficients_.size()), product_of(part.midpoint_powers)});
      coefficients_.push_back(part.coefficient);
    }
    entry.end_term = static_cast<std::uint32_t>(terms_.size());
    rows_.back().entries.push_back(entry);
  }
  std::ranges::sort(rows_.back().entries, {}, &Entry::column);
}

std::uint32_t ExpansionPlan::column_of(const Exponents& exponents) {
  const std::uint32_t product = product_of(exponents);
  const auto found = std::ranges::find(column_products_, product);
  if (found != column_products_.end()) return static_cast<std::uint32_t>(found - column_products_.begin());
  columns_.push_back(monomial_of(exponents));
  column_products_.push_back(product);
  return static_cast<std::uint32_t>(columns_.size() - 1);
}

std::uint32_t ExpansionPlan::product_of(const Exponents& exponents) {
  std::uint32_t product = 0;
  for (std::size_t i = 0; i < exponents.size(); ++i) {
    if (exponents[i] == 0) continue;
    const Product wanted{product, static_cast<std::uint32_t>(i), exponents[i]};
    const auto [place, is_new] =
        product_numbers_.try_emplace(wanted, static_cast<std::uint32_t>(products_.size()));
    if (is_new) products_.push_back(wanted);
    product = place->second;
  }
  return product;
}

template <class T>
Expansion<T>::Expansion(const ExpansionPlan& plan)
    : plan_(&plan),
      midpoints_(plan.functions().variables()),
      radii_(plan.functions().variables()),
      rows_(plan.rows_.size()) {
  for (const Rational& c : plan.coefficients_) coefficients_.push_back(NumberTraits<T>::from_rational(c));
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    evaluators_.emplace_back(plan.function(k).tape);
    for (const auto& entry : plan.rows_[k].entries) {
      if (entry.column != ExpansionPlan::kConstant) rows_[k].columns.push_back(entry.column);
    }
    if (plan.is_expanded(k)) continue;
    for (const std::size_t i : plan.function(k).variables)
      rows_[k].columns.push_back(static_cast<std::uint32_t>(i));
  }
  for (ExpansionRow<T>& row : rows_) row.values.resize(row.columns.size());
}

template <class T>
void Expansion<T>::expand(const Box& box) {
  box_.clear();
  centre_.clear();
  radius_box_.clear();
  for (std::size_t i = 0; i < box.size(); ++i) {
    midpoints_[i] = midpoint(box[i]);
    radii_[i] = radius(box[i]);
    box_.push_back(NumberTraits<T>::from_interval(box[i]));
    centre_.push_back(NumberTraits<T>::from_interval(Interval(midpoints_[i])));
    radius_box_.push_back(NumberTraits<T>::from_interval(Interval(radii_[i])));
  }
  compute_products(centre_, midpoint_products_);
  compute_products(radius_box_, radius_products_);
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    if (plan_->is_expanded(k)) {
      expand_polynomial(k);
    } else {
      expand_by_mean_value(k);
    }
  }
}

template <class T>
void Expansion<T>::bound_columns(std::span<const T> z) {
  compute_products(z, z_products_);
}

template <class T>
void Expansion<T>::compute_products(std::span<const T> numbers, std::vector<T>& products) const {
  products.resize(plan_->products_.size());
  products[0] = NumberTraits<T>::from_interval(Interval(1));
  for (std::size_t p = 1; p < products.size(); ++p) {
    const auto& [parent, variable, power] = plan_->products_[p];
    const T& number = numbers[variable];
    const T factor = power == 1 ? number : power == 2 ? sqr(number) : pow(number, power);
    products[p] = parent == 0 ? factor : products[parent] * factor;
  }
}

template <class T>
void Expansion<T>::expand_polynomial(std::size_t number) {
  ExpansionRow<T>& row = rows_[number];
  row.constant = NumberTraits<T>::from_interval(Interval(0));
  T* value = row.values.data();
  for (const auto& entry : plan_->rows_[number].entries) {
    const auto term = [&](std::uint32_t t) {
      const auto& [coefficient, product] = plan_->terms_[t];
      return product == 0 ? coefficients_[coefficient]
                          : coefficients_[coefficient] * midpoint_products_[product];
    };
    T sum = term(entry.first_term);
    for (std::uint32_t t = entry.first_term + 1; t < entry.end_term; ++t) sum = sum + term(t);
    if (entry.column == ExpansionPlan::kConstant) {
      row.constant = sum;
    } else {
      *value++ = sum * radius_products_[entry.product];
    }
  }
  if (plan_->rows_[number].reciprocal) add_reciprocal(number);
}

/// c / x = c / m - c / (m x) (x - m).
template <class T>
void Expansion<T>::add_reciprocal(std::size_t number) {
  ExpansionRow<T>& row = rows_[number];
  const auto& [coefficient, i, place] = *plan_->rows_[number].reciprocal;
  if (contains(NumberTraits<T>::enclosure(box_[i]), 0)) {
    make_empty(row);
    return;
  }
  const T at_centre = coefficients_[coefficient] / centre_[i];
  row.constant = row.constant + at_centre;
  row.values[place] = row.values[place] - at_centre / box_[i] * radius_box_[i];
}

template <class T>
void Expansion<T>::make_empty(ExpansionRow<T>& row) {
  row.constant = NumberTraits<T>::from_interval(Interval::entire());
  std::ranges::fill(row.values, NumberTraits<T>::from_interval(Interval(0)));
}

template <class T>
void Expansion<T>::expand_by_mean_value(std::size_t number) {
  ExpansionRow<T>& row = rows_[number];
  TapeEvaluator<T>& evaluator = evaluators_[number];
  evaluator.evaluate(centre_);
  row.constant = evaluator.value();
  evaluator.evaluate(box_);
  if (!evaluator.defined_everywhere()) {
    make_empty(row);
    return;
  }
  const std::span<const T> gradient = evaluator.reverse_gradient();
  for (std::size_t c = 0; c < row.columns.size(); ++c) {
    const std::uint32_t variable = row.columns[c];
    row.values[c] = gradient[variable] * NumberTraits<T>::from_interval(Interval(radii_[variable]));
  }
}

template class Expansion<FastInterval>;
template class Expansion<BoostInterval>;
template class Expansion<MpfrInterval>;
template class Expansion<UnroundedInterval>;

}  // namespace gcslab
