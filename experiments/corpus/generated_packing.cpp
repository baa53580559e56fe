#include "experiments/corpus/generated_packing.h"

#include "packing/packing_system.h"
#include "packing/random_triangulation.h"

namespace gcslab {
namespace {

std::int64_t integer_within(const YamlNode& generator, const char* key, std::int64_t least,
                            std::int64_t most) {
  const YamlNode node = generator.at(key);
  const std::int64_t value = node.integer();
  if (value < least || value > most)
    node.fail("must lie in [" + std::to_string(least) + ", " + std::to_string(most) + "]");
  return value;
}

Rational radius(const YamlNode& node) {
  Rational value;
  try {
    value = rational_from_text(node.text());
  } catch (const InputError& error) {
    node.fail(error.what());
  }
  // The disc that touches the outer ones has radius 6/23.
  if (value <= 0 || value > Rational(6, 23)) node.fail("must lie in (0, 6/23]");
  return value;
}

}  // namespace

EquationSystem read_circle_packing(const YamlNode& problem, const YamlNode& generator) {
  generator.allow_keys({"name", "inner_discs", "flips", "seed", "least_radius"});
  for (const char* key : {"variables", "box"}) {
    if (problem.find(key)) generator.fail("makes the key '" + std::string(key) + "' too; leave it out");
  }
  RandomTriangulationOptions options;
  options.inner_vertices = static_cast<int>(integer_within(generator, "inner_discs", 1, 300));
  options.flips = static_cast<int>(integer_within(generator, "flips", 0, 100'000));
  options.seed = static_cast<std::uint64_t>(
      integer_within(generator, "seed", 0, std::numeric_limits<std::int64_t>::max()));
  const Rational least = radius(generator.at("least_radius"));
  return packing_system(random_triangulation(options), standard_outer_discs(), least);
}

}  // namespace gcslab
