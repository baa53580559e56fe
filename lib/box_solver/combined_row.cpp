#include "box_solver/combined_row.h"

#include <algorithm>

#include "interval/arithmetic.h"

namespace gcslab {
namespace {

template <class T>
bool is_zero(const T& x) {
  return NumberTraits<T>::enclosure(x) == Interval(0);
}

bool is_zero(FastInterval x) { return _mm_movemask_pd(_mm_cmpeq_pd(x.raw(), _mm_setzero_pd())) == 3; }

template <class T>
T number(double value) {
  return NumberTraits<T>::from_interval(Interval(value));
}

/// Encloses {a z + q z^2 : z in `z`}: by its ends where it is monotone, with its vertex elsewhere. The ends
/// are doubles around those of z, so that it must be monotone as far as they reach.
template <class T>
T quadratic_range(const T& a, const T& q, const T& z) {
  const Interval side = NumberTraits<T>::enclosure(z);
  const T slope = a + number<T>(2) * q * NumberTraits<T>::from_interval(side);
  const auto value_at = [&](double end) {
    const T point = number<T>(end);
    return point * (a + q * point);
  };
  T ends = hull(value_at(side.lower), value_at(side.upper));
  if (!contains(NumberTraits<T>::enclosure(slope), 0)) return ends;
  T direct = intersection(a * z + q * sqr(z), z * (a + q * z));
  if (contains(NumberTraits<T>::enclosure(q), 0)) return direct;
  return intersection(direct, hull(ends, -(sqr(a) / (number<T>(4) * q))));
}

}  // namespace

template <class T>
CombinedRow<T>::CombinedRow(const ExpansionPlan& plan)
    : plan_(&plan),
      square_columns_(plan.functions().variables(), kNone),
      zero_(number<T>(0)),
      constant_(zero_),
      values_(plan.columns().size(), zero_) {
  for (std::uint32_t c = 0; c < plan.columns().size(); ++c) {
    const auto& factors = plan.columns()[c].factors;
    if (factors.size() == 1 && factors[0].power == 1) continue;
    if (factors.size() == 1 && factors[0].power == 2) {
      square_columns_[factors[0].variable] = c;
    } else if (factors.size() == 2 && factors[0].power == 1 && factors[1].power == 1) {
      products_.push_back({c, factors[0].variable, factors[1].variable});
    } else {
      higher_.push_back(c);
    }
  }
}

template <class T>
void CombinedRow<T>::combine(const Expansion<T>& expansion, std::span<const double> multipliers) {
  constant_ = zero_;
  std::ranges::fill(values_, zero_);
  for (std::size_t k = 0; k < multipliers.size(); ++k) {
    const double multiplier = multipliers[k];
    if (multiplier == 0) continue;
    const ExpansionRow<T>& row = expansion.row(k);
    constant_ = constant_ + scaled(multiplier, row.constant);
    for (std::size_t c = 0; c < row.columns.size(); ++c) {
      T& sum = values_[row.columns[c]];
      sum = sum + scaled(multiplier, row.values[c]);
    }
  }
}

/// The range of a monomial over z, with one power of a variable left out.
template <class T>
T CombinedRow<T>::range_without_one(std::size_t column, std::span<const T> z, std::size_t without) const {
  T product = number<T>(1);
  for (const auto& [variable, power] : plan_->columns()[column].factors) {
    const int left = power - (variable == without ? 1 : 0);
    if (left > 0) product = product * (left == 1 ? z[variable] : pow(z[variable], left));
  }
  return product;
}

template <class T>
typename CombinedRow<T>::Solvable CombinedRow<T>::gathered(std::size_t variable, std::span<const T> z,
                                                           const Expansion<T>& expansion) const {
  T rest = constant_;
  T a = values_[variable];
  for (std::size_t j = 0; j < square_columns_.size(); ++j) {
    if (j == variable) continue;
    const T& linear = values_[j];
    const std::uint32_t square = square_columns_[j];
    if (square == kNone || is_zero(values_[square])) {
      if (!is_zero(linear)) rest = rest + linear * z[j];
    } else {
      rest = rest + quadratic_range(linear, values_[square], z[j]);
    }
  }
  for (const auto& [column, first, second] : products_) {
    const T& value = values_[column];
    if (is_zero(value)) continue;
    if (first == variable) {
      a = a + value * z[second];
    } else if (second == variable) {
      a = a + value * z[first];
    } else {
      rest = rest + value * (z[first] * z[second]);
    }
  }
  for (const std::uint32_t column : higher_) {
    const T& value = values_[column];
    if (is_zero(value)) continue;
    const auto& factors = plan_->columns()[column].factors;
    const bool occurs = std::ranges::any_of(factors, [&](const auto& f) { return f.variable == variable; });
    if (occurs) {
      a = a + value * range_without_one(column, z, variable);
    } else {
      rest = rest + value * expansion.column_range(column);
    }
  }
  const std::uint32_t square = square_columns_[variable];
  return {rest, a, square == kNone || is_zero(values_[square]) ? nullptr : &values_[square]};
}

/// z_i lies in -(rest + q z_i^2) / a and in -rest / (a + q z_i).
template <class T>
T CombinedRow<T>::solve(std::size_t variable, std::span<const T> z, const Expansion<T>& expansion) const {
  const auto [rest, a, q] = gathered(variable, z, expansion);
  if (q == nullptr) return reverse_multiply<T>(-rest, a, z[variable]);
  const T solved = reverse_multiply<T>(-(rest + *q * sqr(z[variable])), a, z[variable]);
  return reverse_multiply<T>(-rest, a + *q * z[variable], solved);
}

/// z_i^2 lies in -(rest + a z_i) / q.
template <class T>
T CombinedRow<T>::solve_square(std::size_t variable, std::span<const T> z,
                               const Expansion<T>& expansion) const {
  const auto [rest, a, q] = gathered(variable, z, expansion);
  if (q == nullptr) return z[variable];
  const T square = reverse_multiply<T>(-(rest + a * z[variable]), *q, sqr(z[variable]));
  return reverse_sqr<T>(square, z[variable]);
}

template <class T>
std::size_t CombinedRow<T>::dominant_variable() const {
  std::size_t dominant = 0;
  for (std::size_t i = 1; i < square_columns_.size(); ++i) {
    if (magnitude(NumberTraits<T>::enclosure(values_[i])) >
        magnitude(NumberTraits<T>::enclosure(values_[dominant])))
      dominant = i;
  }
  return dominant;
}

template <class T>
std::optional<std::size_t> CombinedRow<T>::square_column(std::size_t variable) const {
  if (square_columns_[variable] == kNone) return std::nullopt;
  return square_columns_[variable];
}

template class CombinedRow<FastInterval>;
template class CombinedRow<BoostInterval>;
template class CombinedRow<MpfrInterval>;
template class CombinedRow<UnroundedInterval>;

}  // namespace gcslab
