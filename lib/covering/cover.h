#pragma once

// Covers of implicit curves and surfaces by recursive subdivision (Suffern, Fackerell 1991; the scheme of
// Tahari 2011, sections 3.2.1 and 4.4.1).
//
// Promise: when no bound excludes a zero wrongly, every point of the domain where all functions vanish lies
// in a kept cell, or, when the search was stopped, in an undecided box. Cells are closed, so a point on a
// common side of cells lies in each of them.

#include <memory>
#include <stop_token>
#include <vector>

#include "covering/cover_tree.h"
#include "enclosure/range_bound.h"

namespace gcslab {

struct CoverOptions {
  int depth = 8;  ///< halvings of every variable
  Split split = Split::all;
};

struct Cover {
  CoverTree tree;
  /// Boxes that a stopped search did not look at; empty when it ran to its end.
  std::vector<Box> undecided;
};

/// Bounds of the functions that define a set: {p : every equation is 0 and every inequality is <= 0 at p}.
struct SetBounds {
  std::vector<std::unique_ptr<RangeBound>> equations;
  std::vector<std::unique_ptr<RangeBound>> inequalities;
};

/// Covers the points of the set in the domain, which must be bounded. Cells of the last level are tested too.
/// A requested stop ends the search within one cell.
Cover cover(const SetBounds& set, const Box& domain, const CoverOptions& options,
            const std::stop_token& stop = {});

/// The least depth at which no cell is wider than `cell_size`.
int depth_for_cell_size(const Box& domain, double cell_size);

}  // namespace gcslab
