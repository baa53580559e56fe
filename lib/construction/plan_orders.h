#pragma once

// Orders in which the points of a constraint system are placed, by counting: a point has as many degrees of
// freedom as there are points before it, at most the dimension, and each constraint between it and earlier
// points takes away what it restricts.

#include <optional>
#include <vector>

#include "construction/locus.h"

namespace gcslab {

/// For each constraint and each object that it names, whether it puts the object on planes and spheres.
class PlacingConstraints {
 public:
  /// `only_distances`: no others are looked at.
  PlacingConstraints(const ConstraintSystem& system, const FigureVariables& variables, bool only_distances);

  std::size_t points() const { return of_point_.size(); }
  /// How many guides a point needs when it comes after these: flags, one a point, and their number.
  int guides_needed(const std::vector<bool>& is_placed, std::size_t placed, std::size_t point) const;
  /// Degrees of freedom that the constraints between a point and those of the flags take from it.
  int restriction(const std::vector<bool>& others, std::size_t point, bool is_in_frame) const;

  struct Use {
    std::size_t constraint;
    std::vector<std::size_t> others;
    int restriction;
    bool is_for_frames;  ///< a sphere
  };
  const std::vector<Use>& of_point(std::size_t point) const { return of_point_[point]; }

 private:
  std::size_t dimension_;
  std::vector<std::vector<Use>> of_point_;
};

/// Forward from every frame, an order each: those with the fewest guides first, of these in the order of the
/// frames.
std::vector<std::vector<std::size_t>> forward_orders(const PlacingConstraints& constraints,
                                                     std::size_t dimension);
/// Backward (Gao's algorithm).
std::vector<std::size_t> gao_order(const PlacingConstraints& constraints, std::size_t dimension);
/// One with the least number of guides, by dynamic programming over sets of points. Throws NotApplicable for
/// more than 22 points.
std::vector<std::size_t> least_order(const PlacingConstraints& constraints, std::size_t dimension);
/// One without guides, from `first` where there is one, else from another frame; nothing where there is none.
/// A point that earlier ones place stays so when more come before it: to place points while some can be
/// placed loses nothing.
std::optional<std::vector<std::size_t>> order_without_guides(const PlacingConstraints& constraints,
                                                             std::size_t dimension,
                                                             const std::vector<std::size_t>& first);
/// The guides that an order needs.
int guides_of(const PlacingConstraints& constraints, const std::vector<std::size_t>& order);

}  // namespace gcslab
