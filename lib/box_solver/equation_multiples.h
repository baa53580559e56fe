#pragma once

// Multiples of polynomial equations by monomials: further equations that hold at every root, of use to a
// linear combination.
//
// Quotients: an equation x_i g + c = 0 with a constant c, divided by x_i, is g + c / x_i = 0 where x_i is not
// 0. So a factor x_i that is wide but far from 0 does not multiply what is known of g.
//
// Products: x^a f_k = 0 where every monomial of x^a f_k occurs in some equation. A combination can then
// cancel monomials that no combination of the equations themselves can, as S-polynomials do (Buchberger
// 1965), and no new monomial has to be bounded.

#include <utility>
#include <vector>

#include "box_solver/proof_step.h"
#include "certification/system_functions.h"

namespace gcslab {

/// Polynomials whose expansion about a point has more terms than this are not expanded.
inline constexpr std::size_t kMaximumExpansionTerms = 20'000;

/// Products are by monomials of at most this degree.
inline constexpr int kMaximumFactorDegree = 16;

/// The number of (term, monomial of its expansion about a point) pairs, or one more than the maximum.
std::size_t expansion_terms(const Polynomial& polynomial);

/// Quotients and products of the equations whose expansions are not too large, in their order; those of one
/// equation together have at most as many terms as one polynomial may.
std::vector<EquationMultiple> multiples_of(const SystemFunctions& functions);

/// x^a f, for a product.
Polynomial product_of_multiple(const Polynomial& equation, const EquationMultiple& multiple);
/// g and c, for a quotient g + c / x.
std::pair<Polynomial, Rational> quotient_of_multiple(const Polynomial& equation,
                                                     const EquationMultiple& multiple);

}  // namespace gcslab
