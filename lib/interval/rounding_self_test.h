#pragma once

// A check, at start-up, that directed rounding works in this process: the compiler left directed operations
// where they were written, and the processor rounds them as asked.

namespace gcslab {

/// Throws InvariantError, with what failed and what to do, unless directed rounding works. Takes a few
/// microseconds.
void check_rounding();

}  // namespace gcslab
