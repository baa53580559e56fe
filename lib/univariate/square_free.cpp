#include "univariate/square_free.h"

#include <array>
#include <cstdint>

#include "base/check.h"

namespace gcslab {
namespace {

/// Coefficients modulo a prime below 2^31, by ascending powers; the last one is not 0.
using Residues = std::vector<std::uint64_t>;

void trim(Residues& a) {
  while (!a.empty() && a.back() == 0) a.pop_back();
}

Residues residues(const IntegerPolynomial& a, std::uint64_t prime) {
  Residues result;
  for (const mpz_class& c : a.coefficients()) result.push_back(mpz_fdiv_ui(c.get_mpz_t(), prime));
  trim(result);
  return result;
}

/// a^(prime - 2), the inverse by Fermat.
std::uint64_t inverse(std::uint64_t a, std::uint64_t prime) {
  std::uint64_t result = 1;
  for (std::uint64_t exponent = prime - 2; exponent > 0; exponent >>= 1) {
    if ((exponent & 1) != 0) result = result * a % prime;
    a = a * a % prime;
  }
  return result;
}

/// a modulo b.
void reduce(Residues& a, const Residues& b, std::uint64_t prime) {
  const std::uint64_t unit = inverse(b.back(), prime);
  while (a.size() >= b.size()) {
    const std::uint64_t factor = prime - a.back() * unit % prime;
    const std::size_t shift = a.size() - b.size();
    for (std::size_t i = 0; i < b.size(); ++i) a[shift + i] = (a[shift + i] + factor * b[i]) % prime;
    trim(a);
  }
}

bool are_coprime_modulo(const IntegerPolynomial& a, const IntegerPolynomial& b, std::uint64_t prime) {
  if (mpz_fdiv_ui(a.leading().get_mpz_t(), prime) == 0) return false;
  Residues x = residues(a, prime);
  Residues y = residues(b, prime);
  while (!y.empty()) {
    reduce(x, y, prime);
    std::swap(x, y);
  }
  return x.size() == 1;
}

/// lc(b)^e a modulo b for some e.
IntegerPolynomial pseudo_remainder(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  std::vector<mpz_class> rest = a.coefficients();
  const std::size_t length = b.coefficients().size();
  while (rest.size() >= length) {
    const mpz_class top = rest.back();
    const std::size_t shift = rest.size() - length;
    for (mpz_class& c : rest) c *= b.leading();
    for (std::size_t i = 0; i < length; ++i) rest[shift + i] -= top * b.coefficients()[i];
    rest = IntegerPolynomial(std::move(rest)).coefficients();
  }
  return IntegerPolynomial(std::move(rest));
}

}  // namespace

IntegerPolynomial greatest_common_divisor(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  if (a.is_zero() || b.is_zero()) return primitive_part(a.is_zero() ? b : a);
  for (const std::uint64_t prime : std::array<std::uint64_t, 2>{2147483647, 2147483629}) {
    if (are_coprime_modulo(a, b, prime)) return IntegerPolynomial({1});
  }
  IntegerPolynomial x = primitive_part(a);
  IntegerPolynomial y = primitive_part(b);
  while (!y.is_zero()) {
    IntegerPolynomial rest = primitive_part(pseudo_remainder(x, y));
    x = std::move(y);
    y = std::move(rest);
  }
  return x;
}

std::vector<SquareFreeFactor> square_free_decomposition(const IntegerPolynomial& p) {
  GCSLAB_CHECK(!p.is_zero());
  std::vector<SquareFreeFactor> factors;
  const IntegerPolynomial derivative = p.derivative();
  const IntegerPolynomial repeated = greatest_common_divisor(p, derivative);
  IntegerPolynomial rest = exact_quotient(p, repeated);
  IntegerPolynomial other = exact_quotient(derivative, repeated);
  for (int multiplicity = 1; rest.degree() > 0; ++multiplicity) {
    const IntegerPolynomial difference = other - rest.derivative();
    const IntegerPolynomial factor = greatest_common_divisor(rest, difference);
    if (factor.degree() > 0) factors.push_back({factor, multiplicity});
    rest = exact_quotient(std::move(rest), factor);
    other = exact_quotient(difference, factor);
  }
  return factors;
}

}  // namespace gcslab
