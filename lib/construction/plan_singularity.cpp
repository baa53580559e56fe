#include "construction/plan_singularity.h"

#include <algorithm>
#include <cmath>

#include "geometry/numeric_vector.h"

namespace gcslab {
namespace {

/// The normals of the planes of a step, each of length 1 or empty.
std::vector<Numbers> normals_of(const StepFormulas& step, const std::vector<double>& x) {
  TapeRegisters<double> registers(*step.loci.tape);
  for (std::size_t i = 0; i < step.loci.inputs.size(); ++i) registers[i] = x[step.loci.inputs[i]];
  registers.run();
  std::vector<Numbers> result;
  std::size_t next = 0;
  for (std::size_t k = 0; k < step.planes; ++k, ++next) {
    Numbers normal;
    for (std::size_t i = 0; i < step.dimensions; ++i)
      normal.push_back(registers[step.loci.tape->outputs()[next++]]);
    result.push_back(next_axis(std::move(normal), {}, 0));
  }
  return result;
}

/// The volume that vectors of length 1 span: the product of their parts orthogonal to those before.
double spanned(const std::vector<Numbers>& normals) {
  double product = 1;
  std::vector<Numbers> axes;
  for (const Numbers& normal : normals) {
    if (normal.empty()) return 0;
    Numbers rest = normal;
    for (const Numbers& axis : axes) {
      const double along = dot(rest, axis);
      for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= along * axis[i];
    }
    const double length = std::sqrt(dot(rest, rest));
    product *= length;
    if (!(length > 0)) return 0;
    for (double& x : rest) x /= length;
    axes.push_back(std::move(rest));
  }
  return product;
}

}  // namespace

std::optional<PlanSingularity> least_general_step(const PlanProgram& program, const Figure& figure,
                                                  const std::vector<double>& parameters) {
  std::vector<double> x(program.variables(), 0.0);
  std::ranges::copy(coordinates_in_order(figure), x.begin());
  std::ranges::copy(parameters, x.begin() + static_cast<std::ptrdiff_t>(program.parameter(0)));
  std::optional<PlanSingularity> least;
  for (std::size_t k = 0; k < program.steps().size(); ++k) {
    const StepFormulas& step = program.steps()[k];
    if (step.planes < 2) continue;
    const double sine = spanned(normals_of(step, x));
    if (!least || sine < least->sine) least = {k, sine};
  }
  return least;
}

}  // namespace gcslab
