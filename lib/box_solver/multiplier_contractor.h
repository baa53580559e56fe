#pragma once

#include "box_solver/contractor.h"

namespace gcslab {

struct MultiplierOptions {
  int passes = 2;  ///< how often each combined row is solved for its variable
  int bits = 53;
};

/// Least-squares multipliers: every equation, and every quotient of one by a variable that has them
/// (expansion.h), is expanded about the midpoint of the box; for each variable the combination of these rows
/// whose coefficients are nearest, in the least squares sense, to that variable alone is solved for it.
/// Before that, the combination nearest to a constant may show that the box is empty.
///
/// With F the matrix of the (scaled) expansion without its constants and F_lin its linear columns, the
/// multipliers are the rows of C = F_lin^T (F F^T + D)^-1, with D the diagonal matrix of what is not known
/// of the rows, the sums of the squared radii of their numbers (least_squares.h): without D, row i of C F is
/// the projection of the unit vector e_i on the row space of F; D keeps rows away of which little is known.
/// They need no inverse and take redundant equations; a relative of the optimal linear programming
/// preconditioners of Kearfott (1990, "Preconditioners for the interval Gauss-Seidel method"). Any
/// multipliers are valid, so that rigour rests on the outward rounded evaluation of C f alone. Boxes must be
/// bounded; others are left as they are.
template <class T>
std::unique_ptr<Contractor> make_multiplier_contractor(const SystemFunctions& functions,
                                                       const MultiplierOptions& options = {});

}  // namespace gcslab
