#pragma once

// What has been proved of a root, and by which theorem, in a form that a verifier can prove again.

#include <string>
#include <string_view>
#include <vector>

#include "interval/interval.h"

namespace gcslab {

enum class Claim {
  unique,       ///< the box contains exactly one root
  exists,       ///< at least one
  at_most_one,  ///< no two
  none          ///< nothing is claimed
};

std::string_view name_of(Claim claim);

/// One theorem applied to one box.
struct Evidence {
  std::string type;  ///< "krawczyk", "slope_regularity", "descartes", ...
  Claim claim;
  Box box;
  int bits;  ///< precision of the interval arithmetic; 0: exact where doubles cannot tell
};

/// A root that is known to exist. Promise: `box` contains exactly one root of the equations, which has that
/// multiplicity, and `uniqueness_box`, which contains `box`, contains no other.
struct CertifiedRoot {
  Box box;
  Box uniqueness_box;
  std::vector<Evidence> evidence;
  int multiplicity = 1;  ///< more than 1 only for polynomials in one variable
};

}  // namespace gcslab
