#pragma once

// The circle packing of a triangulated planar graph as a square system of equations.
//
// Three mutually tangent outer discs are fixed; each of the n inner discs has unknowns x, y, r. One equation
// an edge, but the outer ones, says that two discs touch: |c_i - c_j|^2 = (r_i + r_j)^2, 3n of them. One
// inequality a pair without edge says that they do not overlap: |c_i - c_j|^2 >= (r_i + r_j)^2. The box holds
// the gap between the outer discs: its centres lie in the triangle of the three points of tangency, and its
// radii do not exceed that of the disc that touches all three (Descartes 1643: k = a + b + c + 2 sqrt(ab + bc
// + ca) for the curvatures a, b, c of the outer discs). The disc of vertex v >= 3 has the variables x_v, y_v,
// r_v, written x3, y3, r3, ...

#include <array>

#include "expression/equation_system.h"
#include "packing/triangulation.h"

namespace gcslab {

/// A disc with rational centre and radius.
struct RationalDisc {
  Rational x, y, radius;

  friend bool operator==(const RationalDisc&, const RationalDisc&) = default;
};

/// The outer discs of vertices 0, 1, 2.
using OuterDiscs = std::array<RationalDisc, 3>;

/// Radii 1, 2, 3 and centres (0, 0), (3, 0), (0, 4): the smallest example with rational centres.
const OuterDiscs& standard_outer_discs();

/// Each two have distance r + r', exactly.
bool are_mutually_tangent(const OuterDiscs& outer);

/// `outer` must be mutually tangent, counterclockwise. `least_radius` is the lower end of the radii in the
/// box.
EquationSystem packing_system(const Triangulation& graph, const OuterDiscs& outer,
                              const Rational& least_radius);

}  // namespace gcslab
