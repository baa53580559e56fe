#pragma once

// What the fuzz targets have in common. Each target hands a reader arbitrary bytes: it must answer with a
// system or with an InputError, in bounded time, memory and stack, and what it reads must survive being
// written and read again.
//
//   cmake --preset fuzz && cmake --build --preset fuzz
//   mkdir -p build/fuzz/corpus/minibex
//   build/fuzz/tests/fuzz/minibex_fuzz -max_total_time=600 -max_len=2000 -timeout=60 -rss_limit_mb=4096
//       -dict=tests/fuzz/minibex.dict build/fuzz/corpus/minibex tests/fuzz/seeds/minibex      (one line)
//
// and the same for phc, problem, constraint_system (our YAML, at most 4000 bytes) and expression, without
// -dict. New inputs go to the first folder; tests/fuzz/seeds stays small. A file that crashes a target runs
// again by build/fuzz/tests/fuzz/minibex_fuzz <file>.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/error.h"
#include "expression/equation_system.h"
#include "expression/printer.h"
#include "expression/system_formats.h"

namespace gcslab {

/// Ends the program, so that libFuzzer keeps the input.
[[noreturn]] inline void report_fault(const std::string& what) {
  std::fprintf(stderr, "fault: %s\n", what.c_str());
  std::abort();
}

/// Runs an action on hostile input. InputError and NotApplicable are answers; libFuzzer reports anything
/// else.
template <class Action>
void survive(const Action& action) {
  try {
    action();
  } catch (const InputError&) {
  } catch (const NotApplicable&) {
  }
}

/// Our own texts may exceed the limits that guard against hostile ones.
inline bool is_limit(const InputError& error) {
  const std::string_view text = error.what();
  for (const std::string_view limit : {"nested too deeply", " steps ", " bits", "beyond", "too large"}) {
    if (text.find(limit) != std::string_view::npos) return true;
  }
  return false;
}

/// Writes a system in a format that can be read, reads it, and compares what every format keeps.
inline void check_round_trip(const EquationSystem& system, std::string_view format_name) {
  const SystemFormat& format = system_formats().at(format_name);
  std::string text;
  try {
    text = format.write(system);
  } catch (const NotApplicable&) {
    return;
  }
  try {
    const EquationSystem back = format.read(text, "written");
    if (back.variables.size() != system.variables.size()) report_fault("other variables in " + text);
    if (back.equations.size() != system.equations.size()) report_fault("other equations in " + text);
    if (format_name == "minibex" && back.box != system.box) report_fault("another box in " + text);
  } catch (const InputError& error) {
    if (!is_limit(error)) report_fault(std::string(error.what()) + " in " + text);
  }
}

}  // namespace gcslab
