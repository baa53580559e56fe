#pragma once

// Iterations in plain doubles that go from one point, such as a user's sketch, to one root near by, or to
// none. They prove nothing: a root that they find is worth a certificate (certification/point_certifier.h).

#include <cstdint>
#include <string>
#include <vector>

namespace gcslab {

enum class LocalSearchEnd {
  root,        ///< every equation vanishes within the tolerance
  stationary,  ///< the gradient of the sum of squares vanishes, the equations do not
  stalled,     ///< the sum of squares falls no more, though its gradient does not vanish
  singular,    ///< the Jacobian cannot be solved with
  undefined,   ///< an equation is undefined, or has no derivative, at a point that was met
  diverged,    ///< the iterates left the range of doubles
  budget,      ///< no end within the maximum of iterations
  stopped      ///< somebody asked it to
};

struct LocalSearchOptions {
  std::uint64_t maximum_iterations = 100;
  /// A point is a root when, to first order, every equation vanishes within this part of the point's size.
  double tolerance = 1e-10;
};

struct LocalSearch {
  LocalSearchEnd end = LocalSearchEnd::budget;
  std::vector<double> point;  ///< the last one
  std::uint64_t iterations = 0;
  double residual = 0;  ///< max |f_i| at the point; NaN where undefined
};

/// "ended after 21 iterations at a stationary point of the sum of squares that is no root, with the residual
/// 0.3": what became of a search, for users.
std::string end_text(const LocalSearch& search);

}  // namespace gcslab
