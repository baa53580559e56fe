#pragma once

// The methods of `solve` for systems that are settings of one branch-and-prune engine, under the names users
// know.

#include <string>
#include <vector>

#include "base/option.h"
#include "base/outcome.h"
#include "base/registry.h"
#include "box_solver/contractor_registry.h"
#include "box_solver/search.h"

namespace gcslab {

struct SolverMethod {
  std::string name;
  std::string summary;
  int version;  ///< raised when answers or counts change
  // Defaults of its options of these names.
  std::string contractor;
  std::string bisection = "relative_smear_sum";

  /// The options of the engine with this method's defaults.
  std::vector<OptionSpec> options() const;
  /// Rigorous, unless an option asks for a baseline.
  static Promise promise(const Options& options);
};

const Registry<SolverMethod>& solver_method_registry();

/// The contractor that options ask for.
ContractorMaker contractor_maker(const Options& options);
/// The settings of the engine that options ask for.
SearchOptions search_options(const Options& options);

}  // namespace gcslab
