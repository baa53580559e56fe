#include "experiments/corpus/system_family.h"

#include "base/random.h"
#include "base/yaml_reader.h"
#include "polynomial/polynomial.h"

namespace gcslab {
namespace {

constexpr long kStepsPerUnit = 1 << 10;

Rational random_dyadic(Random& random, long bound) {
  Rational value(static_cast<long>(random.integer(-bound, bound)), kStepsPerUnit);
  value.canonicalize();
  return value;
}

/// The exponents of x_first x_second.
Exponents product(std::size_t unknowns, std::size_t first, std::size_t second) {
  Exponents exponents(unknowns, 0);
  ++exponents[first];
  ++exponents[second];
  return exponents;
}

Polynomial sparse_quadratic(std::size_t n, std::size_t i, Random& random) {
  Polynomial polynomial = Polynomial::variable(static_cast<int>(n), static_cast<int>(i));
  const std::size_t next = (i + 1) % n, second_next = (i + 2) % n;
  for (const auto& [first, second] :
       {std::pair{i, i}, std::pair{i, next}, std::pair{i, second_next}, std::pair{next, next}}) {
    polynomial.add_term(product(n, first, second), random_dyadic(random, kStepsPerUnit / 2));
  }
  return polynomial;
}

}  // namespace

FamilyMember sparse_quadratic_system(int unknowns, std::uint64_t seed) {
  const auto n = static_cast<std::size_t>(unknowns);
  Random random(seed, "sparse_quadratic_system");
  FamilyMember member;
  for (std::size_t i = 0; i < n; ++i) {
    member.root.push_back(random_dyadic(random, kStepsPerUnit / 4));
    member.system.variables.push_back("x" + std::to_string(i + 1));
    member.system.box.emplace_back(-0.5, 0.5);
  }
  for (std::size_t i = 0; i < n; ++i) {
    Polynomial polynomial = sparse_quadratic(n, i, random);
    polynomial -= Polynomial::constant(unknowns, polynomial.evaluate(member.root));
    member.system.equations.push_back(polynomial.to_expression(*member.system.graph));
  }
  return member;
}

void check_system_family(const std::filesystem::path& path) {
  const YamlNode file = YamlNode::load_file(path);
  file.allow_keys({"kind", "name", "title", "generator", "origin", "licence", "notes"});
  if (file.at("kind").text() != kSystemFamilyKind)
    file.at("kind").fail("is '" + file.at("kind").text() + "'; expected " + kSystemFamilyKind);
  for (const char* key : {"name", "origin", "licence"}) {
    if (file.at(key).text().empty()) file.at(key).fail("is empty");
  }
  if (file.at("generator").text() != "sparse_quadratic")
    file.at("generator").fail("is unknown (known: sparse_quadratic)");
}

FamilyMember load_family_member(const std::filesystem::path& path, int unknowns, std::uint64_t seed) {
  check_system_family(path);
  return sparse_quadratic_system(unknowns, seed);
}

}  // namespace gcslab
