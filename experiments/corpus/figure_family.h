#pragma once

// Families of figures of any size: rigid constraint systems in which a figure was planted that satisfies them
// exactly.
//
// Every family first draws the sketch: points P0, P1, ... with neighbours about 1 apart. The wanted figure is
// the sketch with its coordinates (of a prism: those of its planes) moved independently and uniformly by up
// to the perturbation, and the valuation `wanted` are its lengths, as square roots of rational numbers. All
// moves are multiples of 2^-20, so that the planted figure is rational and its coplanarities hold exactly.
// The frame is named; what it fixes is no unknown.
//
// - `polygon`, in the plane, of n vertices: n sides and n - 3 diagonals of a triangulation of the convex
//   polygon, each diagonal's third vertex drawn uniformly; 2n - 3 unknowns. The vertices are on a circle of
//   circumference n, near those of the regular polygon; moves are along the circle. The two circles about the
//   ends of a triangle's side meet in two points, so there are 2^(n-2) figures up to motions that keep
//   orientation, 2^(n-3) up to isometry, and 2^(n-1) in the frame; linear paths of lengths keep the
//   triangle inequalities, which hold at both ends, so that the path leads straight from the sketch to the
//   planted figure.
// - `triangulated_polyhedron`, of n vertices: the 3n - 6 edges of the convex hull of points of a sphere,
// drawn
//   near the points of a spiral (Saff, Kuijlaars 1997) and rounded to 2^-10; 3n - 6 unknowns. Convex and
//   simplicial, so infinitesimally rigid (Dehn 1916).
// - `prism`, over a polygon of k sides: 3k edges, and coplanarities for its k quadrilaterals and two k-gons,
//   of which the frame's points span one; 5k - 3 unknowns. The figure is the intersection of k + 2
//   half-spaces, tilted because lengths do not hold a right prism. Moves of planes are smaller in proportion
//   to 1/k, as are the angles of neighbouring faces. The pentahedron is k = 3, the hexahedron k = 4.

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/constraint_system.h"
#include "interval/rational.h"

namespace gcslab {

struct FigureFamilyOptions {
  std::string family;
  int size = 4;  ///< n or k, from least_size on
  std::uint64_t seed = 1;
  Rational perturbation{1, 20};
};

struct FamilyFigure {
  ConstraintSystem system;                    ///< with the sketch, the frame and the valuation `wanted`
  std::vector<std::vector<Rational>> wanted;  ///< the planted figure: a solution, in no frame
};

/// The names of the families.
const std::vector<std::string>& figure_families();
/// What the size of a family's members counts: "vertices" or "sides".
std::string size_key(const std::string& family);
/// The size from which a family has members.
int least_size(const std::string& family);

/// The member of a family that is in figure_families().
FamilyFigure family_figure(const FigureFamilyOptions& options);

}  // namespace gcslab
