#pragma once

// The tasks of the gcslab program.

#include "experiments/tasks/catalogue.h"

namespace gcslab {

const TaskRegistry& task_registry();

/// The registered tasks with the problems of the standard corpus.
Catalogue standard_catalogue();

}  // namespace gcslab
