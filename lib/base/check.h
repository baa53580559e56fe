#pragma once

// Invariants, checked in release builds too: a solver that goes on with a broken invariant could claim what
// is false.

#include <stdexcept>
#include <string>

namespace gcslab {

/// An invariant of the program did not hold: a fault of the program, never of its input. Exit code 5.
class InvariantError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

[[noreturn]] inline void fail_check(const char* condition, const char* file, int line) {
  throw InvariantError(std::string(file) + ":" + std::to_string(line) + ": invariant broken: " + condition);
}

}  // namespace gcslab

#define GCSLAB_CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::gcslab::fail_check(#condition, __FILE__, __LINE__))
