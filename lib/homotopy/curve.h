#pragma once

// A curve in R^(m+1) as the zeros of a map to R^m. The last coordinate is t.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/matrix.h"

namespace gcslab {

/// For each row the columns, ascending, at which a matrix may be other than 0.
using SparsityPattern = std::vector<std::vector<std::uint32_t>>;

class Curve {
 public:
  virtual ~Curve() = default;
  /// m: the number of equations.
  virtual std::size_t size() const = 0;
  /// H(v), of length m. False where some equation is undefined.
  virtual bool values(std::span<const double> v, std::span<double> result) = 0;
  /// H(v), and its m by m + 1 Jacobian. False where some equation is undefined.
  virtual bool jacobian(std::span<const double> v, std::span<double> result, Matrix<double>& derivatives) = 0;
  /// Of every Jacobian, where sparse factors are wanted of it; nullptr where dense ones are. It lives as long
  /// as the curve. Entries elsewhere are 0, or left as they are, which is 0 in a matrix that is new.
  virtual const SparsityPattern* pattern() const { return nullptr; }
};

/// The same curve, its Jacobian by forward differences of the values, as Imbach 2013 has it: m + 1 more
/// evaluations, and about half of the digits. The curve must outlive it.
std::unique_ptr<Curve> with_forward_differences(Curve& curve);

}  // namespace gcslab
