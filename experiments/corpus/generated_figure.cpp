#include "experiments/corpus/generated_figure.h"

#include <algorithm>
#include <limits>

#include "base/nearest_name.h"
#include "experiments/corpus/figure_family.h"
#include "geometry/constraint_system_reader.h"

namespace gcslab {
namespace {

constexpr std::int64_t kLargestSize = 200;

std::int64_t integer_within(const YamlNode& node, std::int64_t least, std::int64_t most) {
  const std::int64_t value = node.integer();
  if (value < least || value > most)
    node.fail("must lie in [" + std::to_string(least) + ", " + std::to_string(most) + "]");
  return value;
}

Rational read_perturbation(const YamlNode& node) {
  Rational value;
  try {
    value = rational_from_text(node.text());
  } catch (const InputError& error) {
    node.fail(error.what());
  }
  if (value <= 0 || value > Rational(1, 5)) node.fail("must lie in (0, 0.2]");
  return value;
}

void refuse_given(const YamlNode& problem, const YamlNode& generator) {
  for (const std::string& key : constraint_system_keys()) {
    if (key != "sketch" && problem.find(key)) generator.fail("makes the key '" + key + "' too; leave it out");
  }
}

}  // namespace

ConstraintSystem read_generated_figure(const YamlNode& problem, const YamlNode& generator) {
  refuse_given(problem, generator);
  FigureFamilyOptions options;
  options.family = generator.at("name").text();
  if (std::ranges::find(figure_families(), options.family) == figure_families().end())
    generator.at("name").fail(unknown_name_message("generator", options.family, figure_families()));
  const std::string size = size_key(options.family);
  generator.allow_keys({"name", size, "seed", "perturbation"});
  options.size =
      static_cast<int>(integer_within(generator.at(size), least_size(options.family), kLargestSize));
  options.seed = static_cast<std::uint64_t>(
      integer_within(generator.at("seed"), 0, std::numeric_limits<std::int64_t>::max()));
  options.perturbation = read_perturbation(generator.at("perturbation"));
  ConstraintSystem system = family_figure(options).system;
  if (const auto sketch = problem.find("sketch")) read_sketch(*sketch, system);
  return system;
}

}  // namespace gcslab
