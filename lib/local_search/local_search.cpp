#include "local_search/local_search.h"

#include <fmt/format.h>

namespace gcslab {
namespace {

const char* words(LocalSearchEnd end) {
  switch (end) {
    case LocalSearchEnd::root:
      return "at a root";
    case LocalSearchEnd::stationary:
      return "at a stationary point of the sum of squares that is no root";
    case LocalSearchEnd::stalled:
      return "where the sum of squares falls no more, at no root";
    case LocalSearchEnd::singular:
      return "where the Jacobian is singular";
    case LocalSearchEnd::undefined:
      return "where an equation is undefined or has no derivative";
    case LocalSearchEnd::diverged:
      return "beyond the range of doubles";
    case LocalSearchEnd::budget:
      return "without convergence";
    case LocalSearchEnd::stopped:
      return "because it was stopped";
  }
  return "";
}

}  // namespace

std::string end_text(const LocalSearch& search) {
  return fmt::format("ended after {} iteration{} {}, with the residual {:.3g}", search.iterations,
                     search.iterations == 1 ? "" : "s", words(search.end), search.residual);
}

}  // namespace gcslab
