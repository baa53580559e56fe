#pragma once

// Constraint systems that a plan solves outright: a plan without guides, evaluated on every branch over
// intervals, gives all solutions (the method of loci, LIM: Imbach 2013, sections 1.1 and 6.1).
//
// Promise: every solution of the equations in their box lies in the uniqueness box of a root, which has no
// other solution, in an undecided box, or in a pending one. A branch is discarded only where intervals prove
// that it has no figure or that its figure violates an equation. What no branch decides, as where loci touch,
// stays undecided after the precision has gone up to its maximum.

#include "certification/root_certificate.h"
#include "certification/system_functions.h"
#include "construction/plan_enclosure.h"
#include "geometry/geometric_equations.h"

namespace gcslab {

/// Of `solve_by_plan`.
struct PlanSolverOptions {
  int bits = 128;           ///< at first
  int maximum_bits = 1024;  ///< precision goes up to this where a branch is not decided
  std::string certifier = "krawczyk_slopes+kantorovich";
  std::uint64_t maximum_branches = 1'000'000;  ///< enclosures of figures
};

struct UndecidedFigures {
  Box box;
  std::string reason;
};

/// Unknowns and as many equations, which are planes and spheres for them once earlier blocks are known.
struct LociBlock {
  std::vector<std::size_t> unknowns, equations;
};

struct PlanSolutions {
  Plan plan;
  /// The plan as blocks of the equations, for a proof that nothing is missing; none where the plan starts in
  /// another frame than the equations have, or one of these is no polynomial in unknowns and parameters.
  std::vector<LociBlock> blocks;
  std::vector<CertifiedRoot> roots;  ///< of solutions, each once
  std::vector<UndecidedFigures> undecided;
  bool is_finished = true;  ///< otherwise figures of the whole box may be missing
  std::uint64_t branches = 0, empty_branches = 0;
  int bits = 0;  ///< that were used in the end
};

/// `functions` are the equations with the values of `valuation`, in their box. Throws NotApplicable where the
/// system has no plan without guides, with what is wanting, and as make_plan and PlanProgram.
PlanSolutions solve_by_plan(const ConstraintSystem& system, const Frame& frame,
                            const GeometricEquations& equations, const Valuation& valuation,
                            const SystemFunctions& functions, const PlanSolverOptions& options = {},
                            const std::stop_token& stop = {});

}  // namespace gcslab
