#pragma once

// A theorem that shows at once that a box has at most one solution: circle packings.
//
// Theorem. Variables 3i, 3i + 1, 3i + 2 are centre and radius of disc i, for i < n. Let there be three fixed,
// mutually tangent discs; let each two of the n + 3 discs but the fixed ones be tangent by an equation or
// kept from overlapping by an inequality; let there be 3n equations, all of that kind and about different
// pairs. Let the box allow positive radii only, and let no fixed centre be an inner point of the smallest
// rectangle with sides along the axes around the fixed centres and the centres that the box allows. Then the
// box holds at most one solution of equations and inequalities.
//
// Proof. In a solution discs do not overlap, so that the segments between the centres of touching ones draw
// their graph without crossings. It has n + 3 vertices and 3n + 3 edges, the most that a plane graph can
// have: all its faces are triangles, and it is 3-connected. The centres that are no corners of the unbounded
// face lie in the interior of its triangle, hence in that of the rectangle; so its corners are the fixed
// centres. The inner faces are the same for every solution (Whitney 1932). Around a centre that is no corner
// their angles add up to 2 pi. Such an angle, in a triangle of sides r + s, s + t, t + r, decreases strictly
// with the radius r at its corner and increases strictly with s and t. Of two solutions with radii r and r',
// take the disc with the largest r / r', and suppose that quotient l is more than 1. Scaling all r', fixed
// ones included, by l keeps angles; going on to r keeps that disc and makes no neighbour larger, so that its
// angles, whose sum stays, stay as they are and every neighbour has quotient l too; so have theirs, and in
// the end a fixed disc, whose quotient is 1. Hence l <= 1, and by symmetry the radii are equal. They and the
// two fixed centres of an edge give the centres, face by face. (Thurston 1978; Collins, Stephenson 2003.)

#include <optional>
#include <string>

#include "verifier/judged_system.h"

namespace gcslab::verifier {

/// The hypothesis that does not hold for this system and box; nothing when all do.
std::optional<std::string> packing_theorem_gap(JudgedSystem& system, const Box& search_box);

}  // namespace gcslab::verifier
