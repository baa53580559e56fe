#pragma once

// The radii of a circle packing, enclosed and proved to be the only ones.
//
// Theorem (discrete maximum principle; Thurston 1978, Collins and Stephenson 2003). Fix the outer radii, and
// let every angle sum of radii p be at most 2 pi (a supersolution). Then any radii r with angle sums 2 pi
// satisfy r <= p. Proof: let l be the largest r_v / p_v, at v, and suppose l > 1. Scaling all radii by l
// keeps angles. From l p, outer radii included, to r the neighbours of v do not grow and v keeps its radius,
// so that its angle sum, which increases with its neighbours, does not grow: it is at most 2 pi, with
// equality only when every neighbour w has r_w = l p_w. It is 2 pi; so the neighbours attain l too, and
// theirs, up to the outer ones, where the quotient is 1. A subsolution, with angle sums >= 2 pi, lies below r
// for the same reason. Two solutions are sub- and supersolutions of each other: there is at most one. And
// between a subsolution q <= p and p there is one: raise the radii of q, one vertex after another, until each
// angle sum is 2 pi for the neighbours as they are; what is reached stays a subsolution below p and increases
// to a solution (Perron's method).
//
// So the two inequalities, at two points and in outward-rounded arithmetic, prove existence, uniqueness among
// all positive radii, and the enclosure at once. The points are p, q = r (1 +- e w) for an approximate
// solution r and w = (-J)^-1 (1, ..., 1) > 0, along which every angle sum changes at the same rate.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "interval/mpfr_interval.h"
#include "packing/triangulation.h"

namespace gcslab {

/// Radii of all vertices to `bits` bits, from approximate ones; the outer ones are the given numbers. Nothing
/// when the inequalities do not hold at the points tried. A Scope of that many bits must be alive.
std::optional<std::vector<MpfrInterval>> enclose_radii(const Triangulation& graph,
                                                       const std::array<Rational, 3>& outer_radii,
                                                       std::span<const double> approximate, int bits);

}  // namespace gcslab
