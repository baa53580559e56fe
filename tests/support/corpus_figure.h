#pragma once

// Constraint systems of the corpus, with their equations and homotopies, for tests.

#include <string>
#include <vector>

#include "certification/system_functions.h"
#include "geometry/constraint_system_reader.h"
#include "geometry/sketch.h"
#include "homotopy/sketch_homotopy.h"

namespace gcslab {

struct CorpusFigure {
  ConstraintSystem system;
  Frame frame;
  GeometricEquations equations;

  std::vector<double> wanted(const std::string& valuation = "") const {
    return values_of(system.valuation(valuation));
  }
  EquationSystem equation_system(const std::string& valuation = "") const {
    return gcslab::equation_system(equations, system, frame, system.valuation(valuation));
  }
  Figure random_sketch(std::uint64_t seed) const {
    ConstraintSystem drawn = system;
    drawn.sketch.reset();
    drawn.random_sketch = seed;
    return *sketch_of(drawn);
  }
  SketchHomotopy homotopy(const Figure& sketch, const SketchHomotopyOptions& options = {},
                          const std::string& valuation = "") const {
    return SketchHomotopy(system, frame, equations, wanted(valuation), sketch, options);
  }
};

/// `name` is its path in data, such as "polyhedra/octahedron".
inline CorpusFigure corpus_figure(const std::string& name) {
  CorpusFigure result{
      read_constraint_system(YamlNode::load_file(std::string(GCSLAB_SOURCE_DIR) + "/data/" + name + ".yaml")),
      {},
      {}};
  result.frame = frame_of(result.system);
  result.equations = geometric_equations(result.system, result.frame);
  return result;
}

}  // namespace gcslab
