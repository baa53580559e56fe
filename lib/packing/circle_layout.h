#pragma once

// The places of the discs of a packing, one after another, from their radii.
//
// Where the face u, v, w stands counterclockwise and discs u and v have their places, the centre of w is
//   c_u + p (c_v - c_u) + q (c_v - c_u)^,  ^ a quarter turn to the left,
//   p = (r_u + r_w - 2 r_v r_w / (r_u + r_v)) / (r_u + r_v),
//   q = 2 sqrt(r_u r_v r_w (r_u + r_v + r_w)) / (r_u + r_v)^2,
// by the law of cosines and Heron's formula. Faces are taken breadth first from the outer edges, so that a
// place hangs on few others.
//
// Promise: for set-valued T, where the radii are those of a packing with these outer discs, each disc of that
// packing lies in its enclosure. Enclosures widen by a factor from place to place; T needs bits to spare.

#include <vector>

#include "interval/mpfr_interval.h"
#include "packing/packing_system.h"

namespace gcslab {

struct EnclosedDisc {
  MpfrInterval x, y, radius;
};

/// Discs of all vertices from radii of all vertices. A Scope must be alive.
std::vector<EnclosedDisc> lay_out(const Triangulation& graph, const OuterDiscs& outer,
                                  const std::vector<MpfrInterval>& radii);

}  // namespace gcslab
