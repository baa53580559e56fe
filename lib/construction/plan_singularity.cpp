#include "construction/plan_singularity.h"

#include <algorithm>
#include <cmath>

#include "geometry/numeric_vector.h"
#include "interval/fast_interval.h"

namespace gcslab {
namespace {

struct Normals {
  std::vector<Numbers> axes;  ///< of the planes of a step, each of length 1 or empty
  /// How far the coordinates are from where the shortest normal is 0, to first order and in sizes of the
  /// figure: about 1 or more where nothing is special.
  double clearance = 1;
};

/// `x` are the variables of the program; the first `coordinates` of them may move by `reach`.
Normals normals_of(const StepFormulas& step, const std::vector<double>& x, std::size_t coordinates,
                   double reach) {
  constexpr double kPart = 1e-4;
  constexpr double kUsual = 16;  // a normal is a function of several coordinates, each moves all of it
  const Tape& tape = *step.loci.tape;
  const NumberTraits<FastInterval>::Scope scope;
  TapeRegisters<double> registers(tape);
  TapeRegisters<FastInterval> moving(tape);
  for (std::size_t i = 0; i < step.loci.inputs.size(); ++i) {
    const std::size_t input = step.loci.inputs[i];
    const double radius = input < coordinates ? kPart * reach : 0;
    registers[i] = x[input];
    moving[i] = FastInterval(x[input] - radius, x[input] + radius);
  }
  registers.run();
  moving.run();
  Normals result;
  std::size_t next = 0;
  for (std::size_t k = 0; k < step.planes; ++k, ++next) {
    Numbers normal;
    double moved = 0;
    for (std::size_t i = 0; i < step.dimensions; ++i) {
      const std::size_t output = tape.outputs()[next++];
      normal.push_back(registers[output]);
      moved += (moving[output].upper() - moving[output].lower()) / 2;
    }
    result.clearance = std::min(result.clearance, kUsual * kPart * std::sqrt(dot(normal, normal)) / moved);
    result.axes.push_back(next_axis(std::move(normal), {}, 0));
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
  const std::size_t coordinates = program.parameter(0);
  double reach = 0;
  for (std::size_t i = 0; i < coordinates; ++i) reach = std::max(reach, std::abs(x[i]));
  std::optional<PlanSingularity> least;
  for (std::size_t k = 0; k < program.steps().size(); ++k) {
    const StepFormulas& step = program.steps()[k];
    if (step.planes == 0) continue;
    const Normals normals = normals_of(step, x, coordinates, reach);
    const double sine = std::min(spanned(normals.axes), normals.clearance);
    if (!least || sine < least->sine) least = {k, sine};
  }
  return least;
}

}  // namespace gcslab
