#pragma once

// The registered linear programming solvers. A new one is one source file and one line in lp_registry.cpp.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/option.h"
#include "base/outcome.h"
#include "base/registry.h"
#include "linear_program/lp_backend.h"

namespace gcslab {

struct LpBackendVariant {
  std::string name;
  std::string summary;  ///< one sentence: what it is and by whom
  /// Whether its own verdicts may be believed. A baseline is made safe by safe_bound.h.
  Promise promise;
  std::vector<OptionSpec> options;
  std::function<std::unique_ptr<LpBackend>(const Options&)> make;

  /// The backend with options as a user wrote them.
  std::unique_ptr<LpBackend> make_with(const std::map<std::string, std::string>& given = {}) const {
    return make(Options(options, given, name));
  }
};

const Registry<LpBackendVariant>& lp_registry();

/// The option `start`: from the last basis, or from scratch.
OptionSpec start_option();
bool starts_cold(const Options& options);

}  // namespace gcslab
