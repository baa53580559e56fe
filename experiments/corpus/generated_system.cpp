#include "experiments/corpus/generated_system.h"

#include "base/nearest_name.h"
#include "experiments/corpus/generated_packing.h"
#include "experiments/corpus/random_polynomial.h"

namespace gcslab {

EquationSystem read_generated_system(const YamlNode& problem, const YamlNode& generator) {
  for (const char* key : {"equations", "inequalities"}) {
    if (problem.find(key)) generator.fail("stands beside '" + std::string(key) + "'; give one of them");
  }
  const std::string name = generator.at("name").text();
  if (name == "random_polynomial") return read_random_polynomial(problem, generator);
  if (name == "circle_packing") return read_circle_packing(problem, generator);
  generator.at("name").fail(unknown_name_message(
      "generator", name, std::vector<std::string>{"circle_packing", "random_polynomial"}));
}

}  // namespace gcslab
