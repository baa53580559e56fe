#include "box_solver/polytope.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/error.h"
#include "box_solver/combined_row.h"
#include "interval/fast_interval.h"

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool is_square(const ScaledMonomial& monomial) {
  return std::ranges::all_of(monomial.factors, [](const auto& f) { return f.power % 2 == 0; });
}

/// The values of a monomial on [-1, 1]^n.
Interval range_of(const ScaledMonomial& monomial) {
  return is_square(monomial) ? Interval(0, 1) : Interval(-1, 1);
}

double largest_coefficient(const ExpansionRow<FastInterval>& row) {
  double largest = 0;
  for (const FastInterval& value : row.values) largest = std::max(largest, magnitude(value.interval()));
  return largest;
}

/// Multipliers of rows with coefficients below kSmallest would overflow; the box is then far below the
/// resolution of any search.
bool is_usable(const ExpansionRow<FastInterval>& row) {
  constexpr double kSmallest = 0x1p-600;
  const double largest = largest_coefficient(row);
  return is_bounded(row.constant.interval()) && (largest == 0 || largest > kSmallest) &&
         std::ranges::all_of(row.values, [](const FastInterval& v) { return is_bounded(v.interval()); });
}

/// A power of 2 that brings the largest coefficient near 1.
double scale_of(const ExpansionRow<FastInterval>& row) {
  const double largest = largest_coefficient(row);
  return largest > 0 ? std::ldexp(1, std::clamp(-std::ilogb(largest), -1000, 1000)) : 1;
}

int degree_of(const ScaledMonomial& monomial) {
  int degree = 0;
  for (const auto& factor : monomial.factors) degree += factor.power;
  return degree;
}

ScaledMonomial times(const ScaledMonomial& a, const ScaledMonomial& b) {
  std::map<std::uint32_t, int> powers;
  for (const ScaledMonomial* monomial : {&a, &b}) {
    for (const auto& [variable, power] : monomial->factors) powers[variable] += power;
  }
  ScaledMonomial result;
  for (const auto& [variable, power] : powers) result.factors.push_back({variable, power});
  return result;
}

/// The quotient of two monomials, if there is one.
std::optional<ScaledMonomial> quotient(const ScaledMonomial& product, const ScaledMonomial& factor) {
  std::map<std::uint32_t, int> powers;
  for (const auto& [variable, power] : product.factors) powers[variable] = power;
  for (const auto& [variable, power] : factor.factors) {
    if ((powers[variable] -= power) < 0) return std::nullopt;
  }
  ScaledMonomial result;
  for (const auto& [variable, power] : powers) {
    if (power > 0) result.factors.push_back({variable, power});
  }
  return result;
}

}  // namespace

std::size_t BernsteinPolytope::columns_for(const ExpansionPlan& plan) {
  const std::size_t own = plan.equation_columns();
  const std::size_t others = plan.columns().size() - own;
  const bool is_determined = plan.functions().constraints() >= plan.functions().variables();
  return others <= own / 4 || !is_determined ? own + others : own;
}

BoundProducts bound_products_from_name(const std::string& name) {
  if (name == "pairs") return BoundProducts::pairs;
  if (name == "factors") return BoundProducts::factors;
  if (name == "both") return BoundProducts::both;
  throw InputError("lp_products is '" + name + "'; expected one of pairs, factors, both");
}

BernsteinPolytope::BernsteinPolytope(const ExpansionPlan& plan, BoundProducts products,
                                     std::span<const GraphColumns> graphs)
    : plan_(&plan),
      columns_(std::span(plan.columns()).first(columns_for(plan))),
      products_(products),
      graphs_(graphs.begin(), graphs.end()) {
  add_columns();
  add_functions();
  add_pairs();
  if (products_ != BoundProducts::pairs) add_bound_factors();
  add_complements();
  add_strips();
  scales_.assign(static_cast<std::size_t>(model_.rows()), 1);
}

void BernsteinPolytope::add_columns() {
  for (const ScaledMonomial& monomial : columns_) model_.add_column(range_of(monomial));
}

/// The first rows; their numbers come with `refill`.
void BernsteinPolytope::add_functions() {
  const NumberTraits<FastInterval>::Scope scope;
  const Expansion<FastInterval> empty(*plan_);
  for (std::size_t k = 0; k < plan_->rows(); ++k) {
    std::vector<LinearTerm> terms;
    for (const std::uint32_t column : empty.row(k).columns) {
      if (column < columns_.size()) terms.push_back({static_cast<int>(column), 1});
    }
    model_.add_row(terms, Interval::entire());
  }
}

std::optional<std::size_t> BernsteinPolytope::column_of(const ScaledMonomial& monomial) const {
  const auto found = std::ranges::find(columns_, monomial);
  if (found == columns_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns_.begin());
}

void BernsteinPolytope::add_pairs() {
  for (const ScaledMonomial& product : columns_) {
    if (products_ == BoundProducts::factors && degree_of(product) > 2) continue;
    for (std::size_t first = 0; first < columns_.size(); ++first) {
      const auto rest = quotient(product, columns_[first]);
      if (!rest || rest->factors.empty()) continue;
      const auto second = column_of(*rest);
      if (second && *second >= first) add_pair(first, *second);
    }
  }
}

void BernsteinPolytope::add_pair(std::size_t first, std::size_t second) {
  for (const int s : {-1, 1}) {
    for (const int t : {-1, 1}) {
      // (1 + z)(1 - z) >= 0 is the upper bound of the square.
      if (first != second || s == t) add_row({{{first, s}, {second, t}}});
    }
  }
}

/// For x^2 y: (1 +- x)(1 +- x)(1 +- y), each choice of signs once.
void BernsteinPolytope::add_bound_factors() {
  constexpr int kMaximumDegree = 6;
  for (const ScaledMonomial& monomial : columns_) {
    const int degree = degree_of(monomial);
    if (degree < 3 || degree > kMaximumDegree) continue;
    std::vector<std::vector<SignedColumn>> products = {{}};
    for (const auto& [variable, power] : monomial.factors) {
      std::vector<std::vector<SignedColumn>> longer;
      for (const std::vector<SignedColumn>& product : products) {
        for (int negative = 0; negative <= power; ++negative) {
          longer.push_back(product);
          for (int k = 0; k < power; ++k) longer.back().push_back({variable, k < negative ? -1 : 1});
        }
      }
      products = std::move(longer);
    }
    for (std::vector<SignedColumn>& product : products) add_row({std::move(product)});
  }
}

void BernsteinPolytope::add_complements() {
  const std::size_t n = plan_->functions().variables();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      for (const int s : {-1, 1}) add_row({{{i, 1}, {j, s}}, true});
    }
  }
}

/// Their numbers come with `refill_strips`.
void BernsteinPolytope::add_strips() {
  for (const auto& [value, argument] : graphs_) {
    const std::array<LinearTerm, 2> terms = {{{static_cast<int>(value), 1}, {static_cast<int>(argument), 1}}};
    for (std::size_t i = 0; i < kStripsOfGraph; ++i) model_.add_row(terms, Interval::entire());
  }
}

/// The row, if all its monomials have columns.
void BernsteinPolytope::add_row(const ProductRow& row) {
  const MonomialSum sum = row.is_square ? square_of(row) : product_of(row);
  double constant = 0;
  std::vector<LinearTerm> terms;
  for (const auto& [monomial, coefficient] : sum.terms()) {
    if (monomial.factors.empty()) constant = coefficient;
    if (monomial.factors.empty() || coefficient == 0) continue;
    const auto column = column_of(monomial);
    if (!column) return;
    terms.push_back({static_cast<int>(*column), coefficient});
  }
  model_.add_row(terms, Interval(-constant, kInfinity));
  meanings_.push_back(row);
}

MonomialSum BernsteinPolytope::product_of(const ProductRow& row) const {
  MonomialSum sum;
  sum.add({}, 1);
  for (const auto& [column, sign] : row.factors) {
    const std::vector<MonomialSum::Term> terms = sum.terms();
    for (const auto& [monomial, coefficient] : terms)
      sum.add(times(monomial, columns_[column]), sign * coefficient);
  }
  return sum;
}

MonomialSum BernsteinPolytope::square_of(const ProductRow& row) const {
  MonomialSum sum;
  for (const SignedColumn& a : row.factors) sum.add(times(columns_[a.column], columns_[a.column]), 1);
  for (std::size_t i = 0; i < row.factors.size(); ++i) {
    for (std::size_t j = i + 1; j < row.factors.size(); ++j) {
      const auto& [a, s] = row.factors[i];
      const auto& [b, t] = row.factors[j];
      sum.add(times(columns_[a], columns_[b]), 2 * s * t);
    }
  }
  return sum;
}

void MonomialSum::add(const ScaledMonomial& monomial, double coefficient) {
  const auto found = std::ranges::find(terms_, monomial, &Term::first);
  if (found == terms_.end()) {
    terms_.emplace_back(monomial, coefficient);
  } else {
    found->second += coefficient;
  }
}

void BernsteinPolytope::refill(const Expansion<FastInterval>& expansion) {
  const NumberTraits<FastInterval>::Scope scope;
  for (std::size_t k = 0; k < plan_->rows(); ++k) refill_row(k, expansion.row(k));
}

void BernsteinPolytope::refill_row(std::size_t k, const ExpansionRow<FastInterval>& row) {
  const int number = static_cast<int>(k);
  coefficients_.clear();
  scales_[k] = 1;
  if (!is_usable(row)) {
    const auto has_column = [&](std::uint32_t column) { return column < columns_.size(); };
    coefficients_.assign(static_cast<std::size_t>(std::ranges::count_if(row.columns, has_column)),
                         Interval(0));
    model_.set_coefficients(number, coefficients_);
    model_.set_sides(number, Interval::entire());
    return;
  }
  scales_[k] = scale_of(row);
  FastInterval rest = scaled(scales_[k], row.constant);
  for (std::size_t c = 0; c < row.columns.size(); ++c) {
    const FastInterval value = scaled(scales_[k], row.values[c]);
    const std::uint32_t column = row.columns[c];
    const bool has_column = column < columns_.size();
    const Interval middle(has_column ? midpoint(value.interval()) : 0);
    rest = rest + (value - FastInterval(middle)) * FastInterval(range_of(plan_->columns()[column]));
    if (has_column) coefficients_.push_back(middle);
  }
  model_.set_coefficients(number, coefficients_);
  const double least = plan_->is_inequality(k) ? -kInfinity : -rest.interval().upper;
  model_.set_sides(number, Interval(least, -rest.interval().lower));
}

/// t - s x = (m_t + r_t z_t) - s (m_x + r_x z_x), with what rounding makes of the coefficients in the sides.
void BernsteinPolytope::refill_strips(std::size_t graph, const StripsOfGraph& strips,
                                      const Expansion<FastInterval>& about) {
  const NumberTraits<FastInterval>::Scope scope;
  const auto& [value, argument] = graphs_[graph];
  const double height = about.radii()[value];
  std::size_t row = first_strip() + graph * kStripsOfGraph;
  for (const auto& [slope, range] : strips) {
    const double width = slope * about.radii()[argument];
    const double largest = std::max(std::abs(height), std::abs(width));
    const bool is_usable = is_bounded(range) && largest > 0x1p-600 && largest < 0x1p600;
    const double scale = is_usable ? std::ldexp(1, -std::ilogb(largest)) : 1;
    const FastInterval s(slope);
    const FastInterval rest =
        FastInterval(about.midpoints()[value]) - s * FastInterval(about.midpoints()[argument]);
    const FastInterval error =
        (FastInterval(width) - s * FastInterval(about.radii()[argument])) * FastInterval(-1, 1);
    const FastInterval sides = scaled(scale, FastInterval(range) - rest - error);
    const std::array<Interval, 2> coefficients = {Interval(is_usable ? scale * height : 0),
                                                  Interval(is_usable ? -scale * width : 0)};
    scales_[row] = scale;
    model_.set_coefficients(static_cast<int>(row), coefficients);
    model_.set_sides(static_cast<int>(row), is_usable ? sides.interval() : Interval::entire());
    ++row;
  }
}

}  // namespace gcslab
