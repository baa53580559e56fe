#include "experiments/corpus/random_polynomial.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/random.h"
#include "polynomial/tensor.h"

namespace gcslab {
namespace {

constexpr double kStep = 0x1p-20;

mpz_class factorial(int n) {
  mpz_class result;
  mpz_fac_ui(result.get_mpz_t(), static_cast<unsigned long>(n));
  return result;
}

double kostlan_weight(const Exponents& exponents, int degree) {
  mpz_class multinomial = factorial(degree);
  int rest = degree;
  for (const int exponent : exponents) {
    multinomial /= factorial(exponent);
    rest -= exponent;
  }
  multinomial /= factorial(rest);
  return std::sqrt(multinomial.get_d());
}

}  // namespace

Polynomial random_polynomial(const RandomPolynomialOptions& options) {
  Random random(options.seed, "random_polynomial");
  Polynomial polynomial(options.variables);
  const Exponents degrees(static_cast<std::size_t>(options.variables), options.total_degree);
  Exponents exponents(degrees.size(), 0);
  do {
    if (std::accumulate(exponents.begin(), exponents.end(), 0) > options.total_degree) continue;
    const double u = kStep * static_cast<double>(random.integer(-(1 << 20), 1 << 20));
    const double weight = options.law == "kostlan" ? kostlan_weight(exponents, options.total_degree) : 1.0;
    polynomial.add_term(exponents, rational_from_double(u * weight));
  } while (next_index(exponents, degrees));
  return polynomial;
}

EquationSystem read_random_polynomial(const YamlNode& problem, const YamlNode& generator) {
  generator.allow_keys({"name", "total_degree", "law", "seed"});
  EquationSystem system;
  system.variables = read_variables(problem.at("variables"));
  RandomPolynomialOptions options;
  options.variables = static_cast<int>(system.variables.size());
  const std::int64_t degree = generator.at("total_degree").integer();
  if (degree < 1 || degree > 100) generator.at("total_degree").fail("must lie in [1, 100]");
  options.total_degree = static_cast<int>(degree);
  options.law = generator.at("law").text();
  if (options.law != "kostlan" && options.law != "uniform") {
    generator.at("law").fail("is unknown (known: kostlan, uniform)");
  }
  const std::int64_t seed = generator.at("seed").integer();
  if (seed < 0) generator.at("seed").fail("must not be negative");
  options.seed = static_cast<std::uint64_t>(seed);
  mpz_class terms;
  mpz_bin_uiui(
      terms.get_mpz_t(),
      static_cast<unsigned long>(options.total_degree) + static_cast<unsigned long>(options.variables),
      static_cast<unsigned long>(options.variables));
  constexpr int kMaximumTerms = 100'000;
  if (terms > kMaximumTerms) generator.fail("has " + terms.get_str() + " terms; at most 100000 are made");
  system.equations = {random_polynomial(options).to_expression(*system.graph)};
  system.box = read_box(problem.at("box"), system.variables);
  return system;
}

}  // namespace gcslab
