#include "box_solver/polytope.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "box_solver/combined_row.h"
#include "interval/fast_interval.h"

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Factors = std::vector<ScaledMonomial::Factor>;

bool is_square(const ScaledMonomial& monomial) {
  return std::ranges::all_of(monomial.factors, [](const auto& f) { return f.power % 2 == 0; });
}

/// The values of a monomial on [-1, 1]^n.
Interval range_of(const ScaledMonomial& monomial) {
  return is_square(monomial) ? Interval(0, 1) : Interval(-1, 1);
}

bool is_usable(const ExpansionRow<FastInterval>& row) {
  return is_bounded(row.constant.interval()) &&
         std::ranges::all_of(row.values, [](const FastInterval& v) { return is_bounded(v.interval()); });
}

/// A power of 2 that brings the largest coefficient near 1.
double scale_of(const ExpansionRow<FastInterval>& row) {
  double largest = 0;
  for (const FastInterval& value : row.values) largest = std::max(largest, magnitude(value.interval()));
  return largest > 0 ? std::ldexp(1, std::clamp(-std::ilogb(largest), -1000, 1000)) : 1;
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

BernsteinPolytope::BernsteinPolytope(const ExpansionPlan& plan)
    : plan_(&plan), columns_(std::span(plan.columns()).first(columns_for(plan))) {
  add_columns();
  add_functions();
  add_products();
  add_complements();
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

/// 1 + s z^a + t z^b + s t z^a z^b >= 0 for the signs s and t; with a = b the squares 1 +- 2 z^a + z^2a >= 0.
void BernsteinPolytope::add_products() {
  const std::span<const ScaledMonomial> columns = columns_;
  for (std::size_t product = 0; product < columns.size(); ++product) {
    for (std::size_t first = 0; first < columns.size(); ++first) {
      const auto rest = quotient(columns[product], columns[first]);
      if (!rest || rest->factors.empty()) continue;
      const auto found = std::ranges::find(columns, *rest);
      const auto second = static_cast<std::size_t>(found - columns.begin());
      if (found == columns.end() || second < first) continue;
      const int a = static_cast<int>(first), b = static_cast<int>(second), p = static_cast<int>(product);
      for (const double s : {-1.0, 1.0}) {
        if (a == b) {
          add_row({first, second, static_cast<int>(s), static_cast<int>(s)},
                  std::vector<LinearTerm>{{a, 2 * s}, {p, 1}}, -1);
          continue;
        }
        for (const double t : {-1.0, 1.0})
          add_row({first, second, static_cast<int>(s), static_cast<int>(t)},
                  std::vector<LinearTerm>{{a, s}, {b, t}, {p, s * t}}, -1);
      }
    }
  }
}

void BernsteinPolytope::add_row(const ProductRow& meaning, const std::vector<LinearTerm>& terms,
                                double least) {
  model_.add_row(terms, Interval(least, kInfinity));
  meanings_.push_back(meaning);
}

int BernsteinPolytope::column_of_product(std::size_t first, std::size_t second) const {
  Factors factors;
  if (first == second) {
    factors = {{static_cast<std::uint32_t>(first), 2}};
  } else {
    factors = {{static_cast<std::uint32_t>(first), 1}, {static_cast<std::uint32_t>(second), 1}};
  }
  const auto found = std::ranges::find(columns_, ScaledMonomial{factors});
  return found == columns_.end() ? -1 : static_cast<int>(found - columns_.begin());
}

void BernsteinPolytope::add_complements() {
  const std::size_t n = plan_->functions().variables();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const int product = column_of_product(i, j);
      const int first = column_of_product(i, i);
      const int second = column_of_product(j, j);
      if (product < 0 || first < 0 || second < 0) continue;
      for (const int s : {-1, 1})
        add_row({i, j, s, 0}, std::vector<LinearTerm>{{first, 1}, {second, 1}, {product, 2.0 * s}}, 0);
    }
  }
}

void BernsteinPolytope::refill(const Expansion<FastInterval>& expansion) {
  const NumberTraits<FastInterval>::Scope scope;
  scales_.assign(plan_->rows(), 1);
  for (std::size_t k = 0; k < plan_->rows(); ++k) refill_row(k, expansion.row(k));
}

void BernsteinPolytope::refill_row(std::size_t k, const ExpansionRow<FastInterval>& row) {
  const int number = static_cast<int>(k);
  coefficients_.clear();
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

}  // namespace gcslab
