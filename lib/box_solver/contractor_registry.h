#pragma once

// The registered contractors, and compositions of them written as text. A new contractor is one source file
// and one line in contractor_registry.cpp; the contract suite then runs on it unasked.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/registry.h"
#include "box_solver/contractor.h"
#include "interval/arithmetic.h"

namespace gcslab {

/// What contractors may be made with. Each reads what concerns it.
struct ContractorSettings {
  Arithmetic arithmetic = Arithmetic::fast;
  int bits = 53;                        ///< of the arithmetic `mpfr`
  double propagation_ratio = 0.1;       ///< a change of a side below this part of it wakes no function
  std::string lp = "simplex";           ///< the solver of linear programs
  std::string lp_safety = "dual";       ///< what is believed of its answers
  std::string lp_products = "factors";  ///< which products of bound factors the polytope has
  std::size_t maximum_coefficients = std::size_t{1} << 20;  ///< of all Bernstein tensors together
  double fixpoint_ratio = 0.2;  ///< a round is repeated while it shrinks some side by this part
};

struct ContractorVariant {
  std::string name;
  std::string summary;  ///< one sentence: what it does and by whom
  /// Throws NotApplicable, with the reason, when it does not take the system.
  std::function<std::unique_ptr<Contractor>(const SystemFunctions&, const ContractorSettings&)> make;
};

const Registry<ContractorVariant>& contractor_registry();

/// Makes a composition: names joined by '+' are applied in turn, and again to a fixpoint, such as
/// "hull+multipliers+lp_reduction?"; one with '?' only when the others stall, and where it has paid. Throws
/// InputError for an unknown name, NotApplicable as above.
std::unique_ptr<Contractor> make_contractor(const std::string& composition, const SystemFunctions& functions,
                                            const ContractorSettings& settings);

}  // namespace gcslab
