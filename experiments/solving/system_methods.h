#pragma once

// Every method of `solve` on systems in one list: settings of our engine, and programs of others.

#include "base/option.h"
#include "base/outcome.h"
#include "base/registry.h"

namespace gcslab {

struct SystemMethod {
  std::string name;
  std::string summary;
  Promise promise;
  int version;
  std::vector<OptionSpec> options;
  bool is_peer;  ///< a program of others: it writes no proof and cannot be resumed
};

const Registry<SystemMethod>& system_method_registry();

}  // namespace gcslab
