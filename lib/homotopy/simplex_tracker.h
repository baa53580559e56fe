#pragma once

// A path of a curve H(v) = 0 in R^n, n = m + 1, followed through the simplices of a triangulation (Allgower,
// Georg 1990, chapter 12): H is replaced by the map that is affine on each simplex and equal to H at its
// vertices, whose zeros are a polygon. The polygon enters a simplex through a face and leaves it through one
// other, which barycentric coordinates tell; a step replaces one vertex and one column of an inverse matrix.
//
// The triangulation is that of Freudenthal (1942): the vertices of a simplex are in a cyclic order, and the
// one that takes the place of v_i beyond the opposite face is v_(i-1) + v_(i+1) - v_i, so that nothing but
// the current simplex is kept. Vertices are integer multiples of the mesh, so that a closed path is noticed
// when it comes to its first face again, exactly.
//
// There are no derivatives and no steps that fail where branches come near: which of them the polygon takes
// there depends on the mesh.

#include "homotopy/path_tracker.h"

namespace gcslab {

struct SimplexOptions {
  double mesh = 0.01;  ///< length of the edges along the axes
  double infinity = 1e5;
  std::uint64_t maximum_simplices = 10'000'000;
};

/// Follows the path through `start`, whose last coordinate is 0 and where H vanishes up to rounding. Steps of
/// the path are simplices; its crossings of t = 1 are polished. The ends are those of follow_path:
/// to_undefined where H is undefined at a vertex. Throws NotApplicable where the mesh is too coarse for the
/// start.
Path follow_simplices(Curve& curve, const std::vector<double>& start, const SimplexOptions& options,
                      const std::stop_token& stop = {}, const PathObserver& observer = {});

}  // namespace gcslab
