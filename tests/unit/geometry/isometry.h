#pragma once

// Figures turned, mirrored, shifted, and given the other set of coordinates of an object.

#include <cmath>
#include <vector>

#include "base/random.h"
#include "geometry/constraint_system.h"

namespace gcslab {

/// Products of rotations in coordinate planes, and a reflection or none.
inline std::vector<std::vector<double>> random_orthogonal_matrix(std::size_t size, Random& random) {
  std::vector<std::vector<double>> matrix(size, std::vector<double>(size, 0.0));
  for (std::size_t i = 0; i < size; ++i) matrix[i][i] = 1;
  if (random.below(2) == 1) matrix[0][0] = -1;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double angle = random.uniform(0, 6.3), c = std::cos(angle), s = std::sin(angle);
      for (auto& row : matrix) {
        const double x = row[i], y = row[j];
        row[i] = c * x - s * y;
        row[j] = s * x + c * y;
      }
    }
  }
  return matrix;
}

inline double product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// The same figure elsewhere, directions with signs at random.
inline Figure randomly_moved(const std::vector<Sort>& sorts, Universe universe, const Figure& figure,
                             Random& random) {
  const auto matrix = random_orthogonal_matrix(dimension(universe), random);
  std::vector<double> shift;
  for (std::size_t axis = 0; axis < dimension(universe); ++axis) shift.push_back(random.uniform(-3, 3));
  const auto turned = [&](const std::vector<double>& vector) {
    std::vector<double> result;
    for (const auto& row : matrix) result.push_back(product(row, vector));
    return result;
  };
  Figure result;
  for (std::size_t k = 0; k < figure.size(); ++k) {
    ObjectParts<double> parts = parts_of(sorts[k], universe, figure[k]);
    const double sign = random.below(2) == 1 ? -1 : 1;
    if (!parts.position.empty()) parts.position = turned(parts.position);
    for (std::size_t axis = 0; axis < parts.position.size(); ++axis) parts.position[axis] += shift[axis];
    if (!parts.direction.empty()) parts.direction = turned(parts.direction);
    for (double& x : parts.direction) x *= sign;
    if (parts.offset) parts.offset = sign * *parts.offset + product(parts.direction, shift);
    if (sorts[k] == Sort::line && !parts.position.empty()) {
      const double along = product(parts.position, parts.direction);
      for (std::size_t axis = 0; axis < parts.position.size(); ++axis)
        parts.position[axis] -= along * parts.direction[axis];
    }
    result.push_back(joined(parts));
  }
  return result;
}

}  // namespace gcslab
