#include "verifier/expansion.h"

#include <algorithm>

#include "base/check.h"

namespace gcslab::verifier {
namespace {

constexpr std::size_t kMaximumTerms = 20'000;

Rational binomial(int n, int k) {
  Rational result;
  mpz_bin_uiui(result.get_num_mpz_t(), static_cast<unsigned long>(n), static_cast<unsigned long>(k));
  return result;
}

/// The number of terms of all expansions of its terms together.
std::size_t expansion_terms(const PolynomialTerms& polynomial) {
  std::size_t count = 0;
  for (const auto& [exponents, coefficient] : polynomial) {
    std::size_t product = 1;
    for (const int e : exponents)
      product = std::min(product * (static_cast<std::size_t>(e) + 1), kMaximumTerms + 1);
    count += product;
  }
  return count;
}

/// The next of all vectors between 0 and `last`; false after the last one.
bool advance(std::vector<int>& index, const std::vector<int>& last) {
  for (std::size_t i = 0; i < index.size(); ++i) {
    if (index[i] < last[i]) {
      ++index[i];
      return true;
    }
    index[i] = 0;
  }
  return false;
}

}  // namespace

Expansion::Expansion(JudgedSystem& system)
    : system_(&system),
      products_(1),
      midpoints_(system.variables()),
      radii_(system.variables()),
      rows_(system.equations().size() + system.inequalities().size()) {
  for (std::size_t i = 0; i < system.variables(); ++i) {
    std::vector<int> exponents(system.variables(), 0);
    exponents[i] = 1;
    column_of(exponents);
  }
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    entries_.emplace_back();
    const std::optional<PolynomialTerms>& polynomial = function(k).polynomial;
    if (polynomial && expansion_terms(*polynomial) <= kMaximumTerms) plan(*polynomial, entries_.back());
  }
}

bool Expansion::has_multiple(const EquationMultiple& multiple) {
  auto found = multiples_.find(multiple);
  if (found == multiples_.end()) found = multiples_.emplace(multiple, planned(multiple)).first;
  return found->second.is_there;
}

Expansion::MultipleRow Expansion::planned(const EquationMultiple& multiple) {
  MultipleRow result;
  if (entries_[multiple.equation].empty()) return result;
  PolynomialTerms polynomial;
  for (const auto& [exponents, coefficient] : *system_->equations()[multiple.equation].polynomial) {
    if (multiple.is_quotient && std::ranges::all_of(exponents, [](int e) { return e == 0; })) {
      result.constant = Range(coefficient);
      continue;
    }
    std::vector<int> powers = exponents;
    for (const auto& [variable, power] : multiple.factor)
      powers[variable] += multiple.is_quotient ? -power : power;
    if (std::ranges::any_of(powers, [](int e) { return e < 0; })) return result;
    polynomial.emplace(std::move(powers), coefficient);
  }
  result.is_there = !polynomial.empty() && expansion_terms(polynomial) <= kMaximumTerms;
  if (result.is_there) plan(polynomial, result.entries);
  return result;
}

JudgedFunction& Expansion::function(std::size_t row) {
  const std::size_t equations = system_->equations().size();
  return row < equations ? system_->equations()[row] : system_->inequalities()[row - equations];
}

/// c x^e = c (m + r z)^e = sum over t <= e of c binomial(e, t) m^(e - t) r^t z^t.
void Expansion::plan(const PolynomialTerms& polynomial, std::vector<Entry>& entries) {
  std::map<std::vector<int>, std::vector<Term>> terms_of_power;
  for (const auto& [exponents, coefficient] : polynomial) {
    std::vector<int> taken(exponents.size(), 0);
    do {
      Rational factor = coefficient;
      std::vector<int> left = exponents;
      for (std::size_t i = 0; i < exponents.size(); ++i) {
        factor *= binomial(exponents[i], taken[i]);
        left[i] -= taken[i];
      }
      terms_of_power[taken].push_back({Range(factor), product_of(left)});
    } while (advance(taken, exponents));
  }
  for (auto& [taken, terms] : terms_of_power) {
    const bool is_constant = std::ranges::all_of(taken, [](int e) { return e == 0; });
    entries.push_back({is_constant ? kConstant : column_of(taken), std::move(terms)});
  }
}

std::uint32_t Expansion::column_of(const std::vector<int>& exponents) {
  Monomial monomial;
  for (std::size_t i = 0; i < exponents.size(); ++i) {
    if (exponents[i] > 0) monomial.emplace_back(static_cast<std::uint32_t>(i), exponents[i]);
  }
  const auto [place, is_new] =
      number_of_column_.try_emplace(monomial, static_cast<std::uint32_t>(columns_.size()));
  if (is_new) {
    columns_.push_back(monomial);
    column_products_.push_back(product_of(exponents));
  }
  return place->second;
}

std::uint32_t Expansion::product_of(const std::vector<int>& exponents) {
  std::uint32_t product = 0;
  for (std::uint32_t i = 0; i < exponents.size(); ++i) {
    for (int e = 0; e < exponents[i]; ++e) {
      const std::pair step(product, i);
      const auto [place, is_new] =
          number_of_product_.try_emplace(step, static_cast<std::uint32_t>(products_.size()));
      if (is_new) products_.push_back(step);
      product = place->second;
    }
  }
  return product;
}

void Expansion::expand(const Box& box) {
  box_ = box;
  for (std::size_t i = 0; i < box.size(); ++i) {
    GCSLAB_CHECK(is_bounded(box[i]));
    midpoints_[i] = midpoint(box[i]);
    radii_[i] = radius(box[i]);
  }
  compute_products();
  has_row_.assign(rows_.size(), false);
  for (auto& [multiple, row] : multiples_) row.is_made = false;
}

void Expansion::compute_products() {
  compute_products(midpoints_, midpoint_products_);
  compute_products(radii_, radius_products_);
}

void Expansion::compute_products(const std::vector<double>& numbers, std::vector<Range>& products) const {
  products.resize(products_.size());
  products[0] = 1.0;
  for (std::size_t p = 1; p < products.size(); ++p) {
    const auto& [parent, variable] = products_[p];
    products[p] = products[parent] * Range(numbers[variable]);
  }
}

const ExpandedRow& Expansion::row(std::size_t number) {
  ExpandedRow& row = rows_[number];
  if (has_row_[number]) return row;
  has_row_[number] = true;
  row.columns.clear();
  row.values.clear();
  if (entries_[number].empty()) {
    expand_by_mean_value(function(number).program, row);
  } else {
    expand_polynomial(entries_[number], row);
  }
  return row;
}

const ExpandedRow& Expansion::row(const EquationMultiple& multiple) {
  MultipleRow& made = multiples_.at(multiple);
  ExpandedRow& row = made.row;
  if (made.is_made) return row;
  made.is_made = true;
  row.columns.clear();
  row.values.clear();
  if (multiple.is_quotient && Range(box_[multiple.factor[0].first]).contains_zero()) {
    row.constant = Range::entire();
    return row;
  }
  if (midpoint_products_.size() < products_.size()) compute_products();  // planned after `expand`
  expand_polynomial(made.entries, row);
  if (multiple.is_quotient) add_reciprocal(made, multiple.factor[0].first, row);
  return row;
}

/// c / x = c / m - c / (m x) (x - m).
void Expansion::add_reciprocal(const MultipleRow& multiple, std::size_t variable, ExpandedRow& row) const {
  const Range at_centre = multiple.constant / Range(midpoints_[variable]);
  const Range slope = -(at_centre / Range(box_[variable]) * Range(radii_[variable]));
  row.constant = row.constant + at_centre;
  const auto column = std::ranges::find(row.columns, variable);
  if (column != row.columns.end()) {
    Range& value = row.values[static_cast<std::size_t>(column - row.columns.begin())];
    value = value + slope;
  } else {
    row.columns.push_back(static_cast<std::uint32_t>(variable));
    row.values.push_back(slope);
  }
}

void Expansion::expand_polynomial(const std::vector<Entry>& entries, ExpandedRow& row) const {
  row.constant = 0.0;
  for (const auto& [column, terms] : entries) {
    Range sum;
    for (const Term& term : terms) sum = sum + term.coefficient * midpoint_products_[term.product];
    if (column == kConstant) {
      row.constant = sum;
    } else {
      row.columns.push_back(column);
      row.values.push_back(sum * radius_products_[column_products_[column]]);
    }
  }
}

void Expansion::expand_by_mean_value(Program& program, ExpandedRow& row) {
  RangeBox centre;
  for (const double m : midpoints_) centre.emplace_back(m);
  row.constant = program.evaluate(centre);
  program.evaluate(ranges_of(box_));
  if (!program.is_defined_everywhere()) {
    row.constant = Range::entire();
    return;
  }
  const std::vector<Range>& slopes = program.gradient();
  for (const std::size_t i : program.variables()) {
    row.columns.push_back(static_cast<std::uint32_t>(i));
    row.values.push_back(slopes[i] * Range(radii_[i]));
  }
}

}  // namespace gcslab::verifier
