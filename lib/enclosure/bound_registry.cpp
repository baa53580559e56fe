#include "enclosure/bound_registry.h"

#include "interval/arithmetic.h"

// A new bound is one line here: the function that describes it, defined in its own file.
#define GCSLAB_BOUNDS(X)        \
  X(natural_bound)              \
  X(centred_bound)              \
  X(centred_second_order_bound) \
  X(taubin_bound)               \
  X(taubin_even_bound)          \
  X(affine_chebyshev_bound)     \
  X(affine_min_range_bound)     \
  X(bernstein_bound)            \
  X(exact_bound)

namespace gcslab {

#define GCSLAB_DECLARE(variant) BoundVariant variant();
GCSLAB_BOUNDS(GCSLAB_DECLARE)
#undef GCSLAB_DECLARE

Promise BoundVariant::promise(const Options& values) const {
  const auto arithmetic = values.values().find("arithmetic");
  if (arithmetic == values.values().end()) return Promise::rigorous;
  return promise_of(arithmetic_from_name(std::get<std::string>(arithmetic->second)));
}

const Registry<BoundVariant>& bound_registry() {
#define GCSLAB_MAKE(variant) variant(),
  static const Registry<BoundVariant> registry("method", {GCSLAB_BOUNDS(GCSLAB_MAKE)});
#undef GCSLAB_MAKE
  return registry;
}

}  // namespace gcslab
