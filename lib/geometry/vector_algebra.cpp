#include "geometry/vector_algebra.h"

#include "base/check.h"

namespace gcslab {

Vector difference(const Vector& a, const Vector& b) {
  GCSLAB_CHECK(a.size() == b.size());
  Vector result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - b[i]);
  return result;
}

Expression dot(const Vector& a, const Vector& b) {
  GCSLAB_CHECK(a.size() == b.size() && !a.empty());
  Expression sum = a[0] * b[0];
  for (std::size_t i = 1; i < a.size(); ++i) sum = sum + a[i] * b[i];
  return sum;
}

Expression squared_norm(const Vector& a) {
  GCSLAB_CHECK(!a.empty());
  Expression sum = sqr(a[0]);
  for (std::size_t i = 1; i < a.size(); ++i) sum = sum + sqr(a[i]);
  return sum;
}

Expression norm(const Vector& a) { return a[0].graph().apply(Operation::sqrt, squared_norm(a)); }

Expression determinant(const Vector& a, const Vector& b) {
  GCSLAB_CHECK(a.size() == 2 && b.size() == 2);
  return a[0] * b[1] - a[1] * b[0];
}

Expression determinant(const Vector& a, const Vector& b, const Vector& c) { return dot(a, cross(b, c)); }

Vector cross(const Vector& a, const Vector& b) {
  GCSLAB_CHECK(a.size() == 3 && b.size() == 3);
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace gcslab
