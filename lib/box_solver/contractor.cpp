#include "box_solver/contractor.h"

#include <algorithm>
#include <cmath>

namespace gcslab {

double largest_gain(const Box& before, const Box& after) {
  double gain = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double old_width = width(before[i]);
    const double new_width = width(after[i]);
    if (new_width >= old_width) continue;
    gain = std::max(gain, std::isinf(old_width) ? 1 : 1 - new_width / old_width);
  }
  return gain;
}

}  // namespace gcslab
