#include "box_solver/monomial_polytope.h"

#include <algorithm>
#include <span>

#include "base/check.h"

namespace gcslab {
namespace {

/// Writes polynomials in the scaled unknowns z in terms of x = m + r z.
class Unscaling {
 public:
  Unscaling(const Expansion<FastInterval>& expansion, const std::vector<Exponents>& monomials)
      : variables_(static_cast<int>(expansion.midpoints().size())), monomials_(monomials) {
    for (int i = 0; i < variables_; ++i) {
      const auto number = static_cast<std::size_t>(i);
      Polynomial z = Polynomial::variable(variables_, i);
      z -= Polynomial::constant(variables_, Rational(expansion.midpoints()[number]));
      z *= 1 / Rational(expansion.radii()[number]);
      scaled_.push_back(std::move(z));
    }
  }

  Polynomial monomial(const ScaledMonomial& monomial) const {
    Polynomial result = Polynomial::constant(variables_, 1);
    for (const auto& [variable, power] : monomial.factors) result = result * pow(scaled_[variable], power);
    return result;
  }

  Polynomial constant(const Rational& value) const { return Polynomial::constant(variables_, value); }

  /// polynomial >= 0, each monomial by its coordinate.
  HalfSpace half_space(const Polynomial& polynomial) const {
    HalfSpace result{std::vector<Rational>(monomials_.size()), 0};
    for (const auto& [exponents, coefficient] : polynomial.terms()) {
      const auto found = std::ranges::find(monomials_, exponents);
      if (found != monomials_.end()) {
        result.normal[static_cast<std::size_t>(found - monomials_.begin())] = coefficient;
      } else {
        GCSLAB_CHECK(std::ranges::all_of(exponents, [](int power) { return power == 0; }));
        result.least = -coefficient;
      }
    }
    return result;
  }

 private:
  int variables_;
  const std::vector<Exponents>& monomials_;
  std::vector<Polynomial> scaled_;
};

/// The monomials that have a column in the model: the first ones of the plan.
std::span<const ScaledMonomial> columns_of(const BernsteinPolytope& polytope,
                                           const Expansion<FastInterval>& expansion) {
  return std::span(expansion.plan().columns()).first(static_cast<std::size_t>(polytope.model().columns()));
}

std::vector<Exponents> exponents_of(std::span<const ScaledMonomial> columns, std::size_t variables) {
  std::vector<Exponents> result;
  for (const ScaledMonomial& column : columns) {
    result.emplace_back(variables, 0);
    for (const auto& [variable, power] : column.factors) result.back()[variable] = power;
  }
  return result;
}

bool is_wanted(const ProductRow& row, PolytopeParts parts) {
  if (!row.is_square || parts == PolytopeParts::all) return true;
  return parts == PolytopeParts::published && row.factors.back().sign < 0;
}

class HalfSpaces {
 public:
  HalfSpaces(const BernsteinPolytope& polytope, const Expansion<FastInterval>& expansion,
             const MonomialPolytope& target, PolytopeParts parts)
      : polytope_(polytope),
        columns_(columns_of(polytope, expansion)),
        unscaling_(expansion, target.monomials),
        parts_(parts) {}

  std::vector<HalfSpace> run() {
    add_rows();
    add_bounds();
    return std::move(result_);
  }

 private:
  void add_rows() {
    const LpModel& model = polytope_.model();
    const int equations = model.rows() - static_cast<int>(polytope_.products().size());
    for (std::size_t k = 0; k < polytope_.products().size(); ++k) {
      if (!is_wanted(polytope_.products()[k], parts_)) continue;
      const int row = equations + static_cast<int>(k);
      Polynomial sum = unscaling_.constant(-Rational(model.sides(row).lower));
      for (std::size_t entry = 0; entry < model.row_columns(row).size(); ++entry) {
        const auto column = static_cast<std::size_t>(model.row_columns(row)[entry]);
        sum += unscaling_.monomial(columns_[column]) * Rational(model.row_midpoints(row)[entry]);
      }
      result_.push_back(unscaling_.half_space(sum));
    }
  }

  /// The upper bound of a square is the product (1 + z)(1 - z) >= 0, its lower one the square itself.
  void add_bounds() {
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      const bool is_square = columns_[column].factors.size() == 1 && columns_[column].factors[0].power == 2;
      const Interval& bounds = polytope_.model().column(static_cast<int>(column));
      const Polynomial monomial = unscaling_.monomial(columns_[column]);
      if (is_square || parts_ == PolytopeParts::all)
        result_.push_back(unscaling_.half_space(unscaling_.constant(Rational(bounds.upper)) - monomial));
      if (parts_ == PolytopeParts::all || (is_square && parts_ == PolytopeParts::published))
        result_.push_back(unscaling_.half_space(monomial - unscaling_.constant(Rational(bounds.lower))));
    }
  }

  const BernsteinPolytope& polytope_;
  std::span<const ScaledMonomial> columns_;
  Unscaling unscaling_;
  PolytopeParts parts_;
  std::vector<HalfSpace> result_;
};

}  // namespace

MonomialPolytope monomial_polytope(const BernsteinPolytope& polytope,
                                   const Expansion<FastInterval>& expansion, PolytopeParts parts) {
  MonomialPolytope result;
  result.monomials = exponents_of(columns_of(polytope, expansion), expansion.midpoints().size());
  result.half_spaces = HalfSpaces(polytope, expansion, result, parts).run();
  return result;
}

MonomialPolytope bernstein_simplex(const Rational& lower, const Rational& upper, int degree) {
  MonomialPolytope result;
  for (int k = 1; k <= degree; ++k) result.monomials.push_back({k});
  const Polynomial x = Polynomial::variable(1, 0);
  const Polynomial from_lower = x - Polynomial::constant(1, lower);
  const Polynomial to_upper = Polynomial::constant(1, upper) - x;
  for (int i = 0; i <= degree; ++i) {
    const Polynomial product = pow(from_lower, i) * pow(to_upper, degree - i);
    HalfSpace side{std::vector<Rational>(static_cast<std::size_t>(degree)), -product.coefficient({0})};
    for (int k = 1; k <= degree; ++k) side.normal[static_cast<std::size_t>(k - 1)] = product.coefficient({k});
    result.half_spaces.push_back(std::move(side));
  }
  return result;
}

}  // namespace gcslab
