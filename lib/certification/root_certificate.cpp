#include "certification/root_certificate.h"

namespace gcslab {

std::string_view name_of(Claim claim) {
  switch (claim) {
    case Claim::unique:
      return "unique";
    case Claim::exists:
      return "exists";
    case Claim::at_most_one:
      return "at_most_one";
    case Claim::none:
      break;
  }
  return "none";
}

}  // namespace gcslab
