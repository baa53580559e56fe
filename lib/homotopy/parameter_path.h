#pragma once

// How the parameters of a constraint system go from what a sketch shows, at t = 0, to what is wanted, at t
// = 1.

#include <memory>
#include <span>
#include <vector>

#include "interval/fast_interval.h"

namespace gcslab {

class ParameterPath {
 public:
  virtual ~ParameterPath() = default;
  /// The parameters at t, a real number, and their derivatives by t.
  virtual void at(double t, std::span<double> values, std::span<double> derivatives) const = 0;
  /// The same over an interval, outward rounded: the path is a polynomial with the doubles that made it as
  /// coefficients. Inside a scope of FastInterval.
  virtual void over(const FastInterval& t, std::span<FastInterval> values,
                    std::span<FastInterval> derivatives) const = 0;
};

/// (1 - t) sketch + t wanted.
std::unique_ptr<ParameterPath> linear_path(std::vector<double> sketch, std::vector<double> wanted);

/// The same, but for one parameter, a length: -t^2 + (wanted - sketch + 1) t + sketch is negative for t far
/// from [0, 1], where no figure has that length, so that paths stay in a bounded part of the t axis (Imbach
/// 2013, section 3.3). For equations that tell the sign of the length.
std::unique_ptr<ParameterPath> compact_support_path(std::vector<double> sketch, std::vector<double> wanted,
                                                    std::size_t parameter);

}  // namespace gcslab
