#include "box_solver/expansion.h"

#include <algorithm>

#include "base/check.h"
#include "interval/arithmetic.h"
#include "polynomial/tensor.h"

namespace gcslab {
namespace {

/// Polynomials whose expansion has more terms than this get their mean value form.
constexpr std::size_t kMaximumTerms = 20'000;

Rational binomial(int n, int k) {
  Rational result;
  mpz_bin_uiui(result.get_num_mpz_t(), static_cast<unsigned long>(n), static_cast<unsigned long>(k));
  return result;
}

/// The number of (term, monomial of its expansion) pairs.
std::size_t expansion_terms(const Polynomial& polynomial) {
  std::size_t count = 0;
  for (const auto& [exponents, coefficient] : polynomial.terms()) {
    std::size_t product = 1;
    for (const int e : exponents) {
      product = std::min(product * static_cast<std::size_t>(e + 1), kMaximumTerms + 1);
    }
    count += product;
  }
  return count;
}

/// Whether it is x_variable g + c with a constant c other than 0 and a g of further variables.
bool has_quotient(const Polynomial& polynomial, std::size_t variable) {
  bool has_constant = false, has_others = false;
  for (const auto& [exponents, coefficient] : polynomial.terms()) {
    int degree = 0;
    for (const int e : exponents) degree += e;
    has_constant = has_constant || degree == 0;
    if (degree > 0 && exponents[variable] == 0) return false;
    has_others = has_others || degree > exponents[variable];
  }
  return has_constant && has_others;
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
  if (which == ExpandedFunctions::equations_and_quotients) {
    for (std::size_t k = 0; k < functions.equations().size(); ++k) add_quotients(k);
  }
  equation_columns_ = columns_.size();
  if (which != ExpandedFunctions::constraints) return;
  for (const SystemFunction& inequality : functions.inequalities()) add_row(inequality);
}

const SystemFunction& ExpansionPlan::function(std::size_t row) const {
  const std::size_t equations = functions_->equations().size();
  if (row < equations) return functions_->equations()[row];
  if (row < equations + quotients_.size())
    return functions_->equations()[quotients_[row - equations].equation];
  return functions_->inequalities()[row - equations];
}

void ExpansionPlan::add_row(const SystemFunction& function) {
  rows_.emplace_back();
  if (function.polynomial && expansion_terms(*function.polynomial) <= kMaximumTerms)
    add_entries(expanded(*function.polynomial));
}

void ExpansionPlan::add_quotients(std::size_t equation) {
  if (!is_expanded(equation)) return;
  const Polynomial& polynomial = *functions_->equations()[equation].polynomial;
  const std::size_t terms = expansion_terms(polynomial);
  std::size_t left = kMaximumTerms;
  for (const std::size_t i : functions_->equations()[equation].variables) {
    if (terms > left || !has_quotient(polynomial, i)) continue;
    left -= terms;
    quotients_.push_back({static_cast<std::uint32_t>(equation), static_cast<std::uint32_t>(i)});
    add_quotient(polynomial, quotients_.back().variable);
  }
}

void ExpansionPlan::add_quotient(const Polynomial& polynomial, std::uint32_t variable) {
  Polynomial g(polynomial.variables());
  Rational constant;
  for (const auto& [exponents, coefficient] : polynomial.terms()) {
    if (exponents[variable] == 0) {
      constant = coefficient;
      continue;
    }
    Exponents divided = exponents;
    --divided[variable];
    g.add_term(divided, coefficient);
  }
  Entries entries = expanded(g);
  Exponents linear(functions_->variables(), 0);
  linear[variable] = 1;
  // The column of c / x_variable, which need not occur in g.
  if (entries[linear].empty()) entries[linear].push_back({0, Exponents(functions_->variables(), 0)});
  rows_.emplace_back();
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
