#pragma once

// Vectors of numbers, for figures that are drawn.

#include <cmath>
#include <vector>

namespace gcslab {

using Numbers = std::vector<double>;

inline double dot(const Numbers& a, const Numbers& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

inline Numbers difference(const Numbers& a, const Numbers& b) {
  Numbers result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - b[i]);
  return result;
}

/// The part of `a` that is orthogonal to the axes, which are orthonormal, with length 1; empty when it is
/// less than `least` of a's length.
Numbers next_axis(Numbers a, const std::vector<Numbers>& axes, double least);

}  // namespace gcslab
