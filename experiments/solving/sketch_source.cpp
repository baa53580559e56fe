#include "experiments/solving/sketch_source.h"

#include "base/error.h"

namespace gcslab {

OptionSpec random_sketch_option() {
  return integer_option("random_sketch", "seed of a random sketch in place of the problem's own; -1: its own",
                        "", -1, -1, 1'000'000'000);
}

SketchSource sketch_source(const SolveSettings& settings) {
  if (settings.geometry == nullptr) throw NotApplicable("only constraint systems have a sketch");
  ConstraintSystem system = settings.geometry->system;
  std::optional<std::uint64_t> seed = settings.sketch_seed;
  if (const std::int64_t given = settings.options.integer("random_sketch"); given >= 0)
    seed = static_cast<std::uint64_t>(given);
  if (seed) {
    system.sketch.reset();
    system.random_sketch = seed;
  }
  std::optional<Figure> sketch = sketch_of(system);
  if (!sketch)
    throw NotApplicable("the problem has no sketch: add the key `sketch`, coordinates or {random: 1}");
  return {*settings.geometry, std::move(*sketch)};
}

Solution found_solution(const std::vector<double>& unknowns, std::optional<CertifiedRoot> root) {
  if (root) return Solution{std::move(*root)};
  Box point;
  for (const double x : unknowns) point.emplace_back(x);
  return {.root = {std::move(point), {}, {}}, .claim = Claim::none};
}

}  // namespace gcslab
