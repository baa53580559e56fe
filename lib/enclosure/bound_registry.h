#pragma once

// The registered range bounds. A new bound is one source file and one line in bound_registry.cpp.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/option.h"
#include "base/outcome.h"
#include "base/registry.h"
#include "enclosure/bound_target.h"
#include "enclosure/range_bound.h"

namespace gcslab {

struct BoundVariant {
  std::string name;
  std::string summary;  ///< one sentence: what it computes and by whom
  std::string applies_to;
  int version;
  std::vector<OptionSpec> options;
  /// Makes the bound for a target. Throws NotApplicable, with the reason, when it does not take the target.
  std::function<std::unique_ptr<RangeBound>(const BoundTarget&, const Options&)> make;

  /// Rigorous, unless the option `arithmetic` asks for the unrounded baseline.
  Promise promise(const Options& options) const;
};

const Registry<BoundVariant>& bound_registry();

}  // namespace gcslab
