#pragma once

// Sums of what is known on the solutions in a box, in the variables z of an expansion about it: what an LP's
// multipliers say, checked monomial by monomial.

#include <utility>
#include <vector>

#include "verifier/expansion.h"
#include "verifier/lifted_terms.h"

namespace gcslab::verifier {

/// multiplier times the product of all 1 + sign z^monomial, or with is_square times the square of the sum of
/// sign z^monomial; signs are -1 or 1, the multiplier is not negative.
struct PositiveProduct {
  std::vector<std::pair<int, Monomial>> factors;
  bool is_square;
  double multiplier;
};

/// Of a term t that is a function of one argument x, lower <= t - slope x <= upper over the side of x: the
/// first with a positive multiplier, the second with a negative one.
struct GraphStrip {
  std::size_t term;
  double slope;
  double multiplier;
};

struct PolytopeSum {
  std::vector<double> multipliers;  ///< of equations, then of inequalities, where they are not positive
  std::vector<PositiveProduct> products;
  std::vector<GraphStrip> strips;
};

/// Encloses z_variable of the solutions in the box of the expansion; empty: there are none. Strips are of
/// `terms`, and the expansion then is of their lifted system.
Range polytope_range(Expansion& about, std::size_t variable, const PolytopeSum& sum, LiftedTerms& terms);

}  // namespace gcslab::verifier
