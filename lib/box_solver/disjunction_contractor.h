#pragma once

#include "box_solver/contractor.h"

namespace gcslab {

struct DisjunctionOptions {
  int slices = 4;
  /// Whether variables are taken in order of their smear until `patience` in a row gained less than
  /// `least_gain`. Otherwise all are taken.
  bool is_adaptive = false;
  int patience = 2;
  double least_gain = 0.05;
};

/// Constructive interval disjunction (Trombettoni and Chabert 2007): the side of one variable is cut into
/// slices, each slice of the box is contracted on its own, and the box becomes the hull of what is left; the
/// same for the next variable. Slices that are found empty at an end of the side are shaved off, and what
/// holds in every slice holds in the box.
///
/// The adaptive form (after Neveu, Trombettoni, Araya 2015) stops where it no longer pays. Theirs learns from
/// earlier boxes how many variables to take; here the box alone decides, so that results do not depend on the
/// order of the search.
///
/// An unbounded side is cut in two. `inner` contracts the slices.
std::unique_ptr<Contractor> make_disjunction_contractor(const SystemFunctions& functions,
                                                        std::unique_ptr<Contractor> inner,
                                                        const DisjunctionOptions& options = {});

}  // namespace gcslab
