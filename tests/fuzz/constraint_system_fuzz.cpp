#include "base/yaml_reader.h"
#include "fuzz/fuzz_target.h"
#include "geometry/constraint_system_reader.h"
#include "geometry/geometric_equations.h"
#include "geometry/sketch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gcslab;
  const std::string text(reinterpret_cast<const char*>(data), size);
  survive([&] {
    const ConstraintSystem system = read_constraint_system(YamlNode::parse(text, "fuzz"));
    const Frame frame = frame_of(system);
    const GeometricEquations equations = geometric_equations(system, frame);
    for (const Valuation& valuation : system.valuations)
      check_round_trip(equation_system(equations, system, frame, valuation), "minibex");
    if (const auto sketch = sketch_of(system)) {
      static_cast<void>(in_frame(system, frame, *sketch));
      static_cast<void>(parameters_of(system, *sketch));
    }
  });
  return 0;
}
