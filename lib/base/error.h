#pragma once

// Errors that a user can mend.
//
// An InputError is one line: where (file:line, option, ...), what is wrong, and what was expected. The
// program prints it on stderr and exits with code 2. Broken invariants are not input errors: see check.h.

#include <stdexcept>
#include <string>
#include <string_view>

namespace gcslab {

/// A place in a text that a user wrote. `line` counts from 1; 0 means "the whole file".
struct SourceLocation {
  std::string file;
  int line = 0;

  /// "file:line", or "file" alone when the line is unknown.
  std::string text() const;
};

/// Input that cannot be used, with its cause and remedy in one line.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message) : std::runtime_error(message) {}
  InputError(const SourceLocation& where, const std::string& message)
      : std::runtime_error(where.text() + ": " + message) {}
};

/// A method that does not apply to a problem; the text says why. Exit code 4.
class NotApplicable : public std::runtime_error {
 public:
  explicit NotApplicable(const std::string& reason) : std::runtime_error(reason) {}
};

}  // namespace gcslab
