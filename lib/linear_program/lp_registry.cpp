#include "linear_program/lp_registry.h"

// A new solver is one line here: the function that describes it, defined in its own file.
#define GCSLAB_LP_BACKENDS(X) \
  X(simplex_backend)          \
  X(exact_backend)            \
  X(glpk_backend)             \
  X(clp_backend)

namespace gcslab {

#define GCSLAB_DECLARE(variant) LpBackendVariant variant();
GCSLAB_LP_BACKENDS(GCSLAB_DECLARE)
#undef GCSLAB_DECLARE

const Registry<LpBackendVariant>& lp_registry() {
#define GCSLAB_MAKE(variant) variant(),
  static const Registry<LpBackendVariant> registry("lp", {GCSLAB_LP_BACKENDS(GCSLAB_MAKE)});
#undef GCSLAB_MAKE
  return registry;
}

OptionSpec start_option() {
  return choice_option("start", "where an objective starts: at the last basis, or from scratch", "warm",
                       {"warm", "cold"});
}

bool starts_cold(const Options& options) { return options.word("start") == "cold"; }

}  // namespace gcslab
