#pragma once

// A system of equations recognised as a circle packing.
//
// Promise: the equations are, up to constant factors, those of packing_system.h for `graph` and `outer`, with
// the variables of the disc of vertex v >= 3 at 3(v - 3), 3(v - 3) + 1 and 3(v - 3) + 2. Numbers of inner
// vertices follow the variables; the outer discs are numbered so that they stand counterclockwise.

#include <optional>
#include <string>
#include <vector>

#include "certification/system_functions.h"
#include "packing/packing_system.h"

namespace gcslab {

struct PackingProblem {
  Triangulation graph;
  OuterDiscs outer;
  std::vector<Edge> kept_apart;  ///< pairs that an inequality keeps from overlapping, ascending
};

/// Throws NotApplicable, with the reason, when the system is no packing of a triangulation.
PackingProblem recognise_packing(const SystemFunctions& functions);

/// Why the box may hold more than one solution; nothing when there is at most one.
///
/// Theorem. Let every two discs that share no edge be kept apart, let the radii of the box be positive, and
/// let no outer centre be an inner point of the rectangle around the box's centres and the outer centres.
/// Then the box holds at most one solution of equations and inequalities. Proof: the segments between the
/// centres of touching discs draw the graph in the plane without crossings, since discs do not overlap. The
/// drawing has 3N - 6 segments, so its unbounded face is a triangle, with all other centres in its interior,
/// hence in the interior of the rectangle. No outer centre is there: the triangle is 0, 1, 2. The inner faces
/// are the same for every solution (Whitney 1932), and at each inner vertex their angles add up to 2 pi. The
/// radii follow by the theorem of radii_enclosure.h, and the centres from the radii, face by face.
std::optional<std::string> uniqueness_gap(const PackingProblem& problem, const Box& box);

}  // namespace gcslab
