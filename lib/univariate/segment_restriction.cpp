#include "univariate/segment_restriction.h"

#include "interval/fast_interval.h"
#include "interval/point_numbers.h"

namespace gcslab {
namespace {

template <class T>
T number(const Rational& value) {
  return NumberTraits<T>::from_rational(value);
}

Rational binomial(int n, int k) {
  mpz_class result;
  mpz_bin_uiui(result.get_mpz_t(), static_cast<unsigned long>(n), static_cast<unsigned long>(k));
  return result;
}

}  // namespace

template <class T>
SegmentRestriction<T>::SegmentRestriction(const Polynomial& polynomial)
    : degree_(polynomial.total_degree()), degrees_(polynomial.degrees()) {
  terms_.resize(static_cast<std::size_t>(degree_) + 1);
  for (const auto& [exponents, coefficient] : polynomial.terms()) {
    std::size_t total = 0;
    for (const int exponent : exponents) total += static_cast<std::size_t>(exponent);
    terms_[total].push_back({exponents, number<T>(coefficient)});
  }
  for (int i = 0; i <= degree_; ++i) binomials_.push_back(number<T>(binomial(degree_, i)));
}

template <class T>
typename SegmentRestriction<T>::Form SegmentRestriction<T>::product(const Form& a, const Form& b) {
  Form result(a.size() + b.size() - 1, number<T>(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) result[i + k] = result[i + k] + a[i] * b[k];
  }
  return result;
}

template <class T>
typename SegmentRestriction<T>::Form SegmentRestriction<T>::monomial(
    const Term& term, const std::vector<std::vector<Form>>& powers) const {
  Form result = {term.coefficient};
  for (std::size_t v = 0; v < powers.size(); ++v) {
    const auto exponent = static_cast<std::size_t>(term.exponents[v]);
    if (exponent > 0) result = product(result, powers[v][exponent - 1]);
  }
  return result;
}

template <class T>
std::vector<T> SegmentRestriction<T>::bernstein_coefficients(std::span<const T> from,
                                                             std::span<const T> to) const {
  std::vector<std::vector<Form>> powers(from.size());
  for (std::size_t v = 0; v < from.size(); ++v) {
    const Form coordinate = {from[v], to[v]};
    for (int k = 1; k <= degrees_[v]; ++k)
      powers[v].push_back(k == 1 ? coordinate : product(powers[v].back(), coordinate));
  }
  const Form one = {number<T>(1), number<T>(1)};
  Form sum = {number<T>(0)};
  for (std::size_t total = 0; total < terms_.size(); ++total) {
    if (total > 0) sum = product(sum, one);
    for (const Term& term : terms_[total]) {
      const Form added = monomial(term, powers);
      for (std::size_t i = 0; i < added.size(); ++i) sum[i] = sum[i] + added[i];
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = sum[i] / binomials_[i];
  return sum;
}

// A number type that segments are restricted over is one line here.
template class SegmentRestriction<FastInterval>;
template class SegmentRestriction<double>;
template class SegmentRestriction<Rational>;

}  // namespace gcslab
