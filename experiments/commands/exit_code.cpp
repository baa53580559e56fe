#include "experiments/commands/exit_code.h"

namespace gcslab {

ExitCode exit_code_of(Status status) {
  switch (status) {
    case Status::complete:
    case Status::partial:
      return kDone;
    case Status::budget_exhausted:
    case Status::out_of_memory:
      return kBudgetExhausted;
    case Status::not_applicable:
      return kNotApplicable;
    case Status::failed:
    case Status::crashed:
      break;
  }
  return kFailedInside;
}

}  // namespace gcslab
