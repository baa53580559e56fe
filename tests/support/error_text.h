#pragma once

// What an action complains of.

#include <string>

#include "base/error.h"

namespace gcslab {

/// The text of the InputError or NotApplicable that the action throws; "no error" when it throws none.
template <class Action>
std::string error_text(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  } catch (const NotApplicable& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace gcslab
