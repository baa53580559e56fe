#include "certification/inclusion_test.h"

namespace gcslab {

// Each is defined in a source file of its name.
#define GCSLAB_INCLUSION_TESTS(X) \
  X(krawczyk_inclusion)           \
  X(interval_newton_inclusion)    \
  X(kantorovich_inclusion)        \
  X(miranda_inclusion)            \
  X(elber_kim_inclusion)

#define GCSLAB_DECLARE(name) InclusionTestVariant name();
GCSLAB_INCLUSION_TESTS(GCSLAB_DECLARE)
#undef GCSLAB_DECLARE

const Registry<InclusionTestVariant>& inclusion_test_registry() {
#define GCSLAB_ENTRY(name) name(),
  static const Registry<InclusionTestVariant> registry("inclusion test",
                                                       {GCSLAB_INCLUSION_TESTS(GCSLAB_ENTRY)});
#undef GCSLAB_ENTRY
  return registry;
}

}  // namespace gcslab
