#pragma once

// Theorems that prove a root in a box, or that there are not two: one interface, so that they can be compared
// on the same boxes.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/registry.h"
#include "certification/newton_iteration.h"
#include "certification/root_certificate.h"
#include "certification/system_functions.h"
#include "interval/arithmetic.h"

namespace gcslab {

/// A test of square systems in one arithmetic. It belongs to one thread.
class InclusionTest {
 public:
  virtual ~InclusionTest() = default;

  /// Evidence for the claim of the test on `box`, which is bounded; nothing when the theorem does not apply
  /// or its conditions could not be shown. `approximate` is a guess on which no truth rests: a point in the
  /// box or near it, and the approximate inverse of the Jacobian there.
  virtual std::optional<Evidence> prove(const Box& box, const ApproximateRoot& approximate) = 0;
};

struct InclusionTestSettings {
  Arithmetic arithmetic = Arithmetic::fast;
  int bits = 53;  ///< of the arithmetic `mpfr`
};

struct InclusionTestVariant {
  std::string name;     ///< the type of its evidence
  std::string summary;  ///< one sentence: what it shows and by whom
  Claim claim;
  /// Throws NotApplicable, with the reason, for a system that is not square, one that the theorem does not
  /// take, and for a baseline arithmetic.
  std::function<std::unique_ptr<InclusionTest>(const SystemFunctions&, const InclusionTestSettings&)> make;
};

/// The registered tests. A new one is one source file and one line in inclusion_test.cpp; the contract suite
/// then runs on it unasked.
const Registry<InclusionTestVariant>& inclusion_test_registry();

}  // namespace gcslab
