#pragma once

// Vectors of two or three expressions.

#include <vector>

#include "expression/expression.h"

namespace gcslab {

using Vector = std::vector<Expression>;

Vector difference(const Vector& a, const Vector& b);
Expression dot(const Vector& a, const Vector& b);
Expression squared_norm(const Vector& a);
Expression norm(const Vector& a);
/// Of two vectors of the plane.
Expression determinant(const Vector& a, const Vector& b);
/// Of three vectors of space.
Expression determinant(const Vector& a, const Vector& b, const Vector& c);
/// Of two vectors of space.
Vector cross(const Vector& a, const Vector& b);

}  // namespace gcslab
