#pragma once

// What inclusion tests share: how they are made, as templates over the number type, and where they are
// centred.

#include <algorithm>
#include <utility>
#include <vector>

#include "base/error.h"
#include "certification/inclusion_test.h"

namespace gcslab {

/// Test<T>(functions, bits) for the number type that the settings name.
template <template <class> class Test>
std::unique_ptr<InclusionTest> make_inclusion_test(const SystemFunctions& functions,
                                                   const InclusionTestSettings& settings) {
  if (!functions.is_square()) throw NotApplicable("certificates need as many equations as variables");
  if (promise_of(settings.arithmetic) == Promise::baseline)
    throw NotApplicable("certificates do not rest on the baseline arithmetic unrounded");
  return with_arithmetic(settings.arithmetic,
                         [&]<class T>(std::type_identity<T>) -> std::unique_ptr<InclusionTest> {
                           const typename NumberTraits<T>::Scope scope(settings.bits);
                           return std::make_unique<Test<T>>(functions, settings.bits);
                         });
}

/// The approximate root, moved into the box where it lies outside.
inline std::vector<double> centre_in(const Box& box, const ApproximateRoot& approximate) {
  std::vector<double> result;
  for (std::size_t i = 0; i < box.size(); ++i)
    result.push_back(std::clamp(approximate.point[i], box[i].lower, box[i].upper));
  return result;
}

inline bool is_strictly_inside(const Interval& x, const Interval& side) {
  return !is_empty(x) && x.lower > side.lower && x.upper < side.upper;
}

}  // namespace gcslab
