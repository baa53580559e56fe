#pragma once

// The methods of `solve` for systems, under the names users know: settings of one branch-and-prune engine,
// and the isolation of roots of one polynomial in one variable.

#include <string>
#include <vector>

#include "base/option.h"
#include "base/outcome.h"
#include "base/registry.h"
#include "box_solver/contractor_registry.h"
#include "box_solver/search.h"

namespace gcslab {

/// What a method runs.
enum class SolverEngine {
  branch_and_prune,  ///< search.h
  univariate         ///< univariate_search.h
};

struct SolverMethod {
  std::string name;
  std::string summary;
  int version;             ///< raised when answers or counts change
  std::string contractor;  ///< the default of its option `contractor`
  SolverEngine engine = SolverEngine::branch_and_prune;

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
