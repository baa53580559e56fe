#include "geometry/numeric_vector.h"

#include <algorithm>

namespace gcslab {

Numbers next_axis(Numbers a, const std::vector<Numbers>& axes, double least) {
  double largest = 0;
  for (const double x : a) largest = std::max(largest, std::abs(x));
  if (!(largest > 0) || !std::isfinite(largest)) return {};
  for (double& x : a) x /= largest;  // no square overflows
  const double length = std::sqrt(dot(a, a));
  for (int pass = 0; pass < 2; ++pass) {
    for (const Numbers& axis : axes) {
      const double part = dot(a, axis);
      for (std::size_t i = 0; i < a.size(); ++i) a[i] -= part * axis[i];
    }
  }
  const double left = std::sqrt(dot(a, a));
  if (!(left > least * length)) return {};
  for (double& x : a) x /= left;
  return a;
}

}  // namespace gcslab
