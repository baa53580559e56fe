#pragma once

// What methods tell of a construction plan.

#include "construction/plan.h"
#include "experiments/solving/solve_run.h"

namespace gcslab {

/// The parts of a text that a character ends or separates, empty ones left out.
std::vector<std::string> lines_of(const std::string& text, char end);

PlanReport report_of(const Plan& plan, const ConstraintSystem& system);

/// With the points that can go to infinity on a path.
PlanReport report_with_escapes(const Plan& plan, const ConstraintSystem& system);

}  // namespace gcslab
