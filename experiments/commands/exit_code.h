#pragma once

// The exit codes of the program (see README.md); every command uses these words.

#include "base/outcome.h"

namespace gcslab {

enum ExitCode : int {
  kDone = 0,         ///< complete or partial
  kCheckFailed = 1,  ///< validate, report against reference
  kBadInput = 2,     ///< one line on stderr: where, cause, remedy
  kBudgetExhausted = 3,
  kNotApplicable = 4,  ///< reason on stderr
  kFailedInside = 5    ///< what to report is on stderr
};

ExitCode exit_code_of(Status status);

}  // namespace gcslab
