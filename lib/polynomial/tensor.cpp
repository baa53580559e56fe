#include "polynomial/tensor.h"

#include "base/check.h"
#include "base/error.h"

namespace gcslab {

std::size_t coefficient_count(const Exponents& degrees) {
  std::size_t count = 1;
  for (const int degree : degrees) {
    GCSLAB_CHECK(degree >= 0);
    count *= static_cast<std::size_t>(degree) + 1;  // both factors below 2^31: no overflow
    if (count > kMaximumCoefficients) {
      throw NotApplicable("a dense tensor of these degrees has more than " +
                          std::to_string(kMaximumCoefficients) + " coefficients");
    }
  }
  return count;
}

AxisShape axis_shape(const Exponents& degrees, int variable) {
  GCSLAB_CHECK(variable >= 0 && static_cast<std::size_t>(variable) < degrees.size());
  const auto axis = static_cast<std::size_t>(variable);
  AxisShape shape{1, static_cast<std::size_t>(degrees[axis]) + 1, 1};
  for (std::size_t i = 0; i < axis; ++i) shape.blocks *= static_cast<std::size_t>(degrees[i]) + 1;
  for (std::size_t i = axis + 1; i < degrees.size(); ++i)
    shape.row *= static_cast<std::size_t>(degrees[i]) + 1;
  return shape;
}

bool next_index(Exponents& index, const Exponents& degrees) {
  for (std::size_t i = degrees.size(); i-- > 0;) {
    if (index[i] < degrees[i]) {
      ++index[i];
      return true;
    }
    index[i] = 0;
  }
  return false;
}

}  // namespace gcslab
