#pragma once

// Relations of boxes.

#include <vector>

#include "interval/interval.h"
#include "verifier/range.h"

namespace gcslab::verifier {

/// One range a variable.
using RangeBox = std::vector<Range>;

RangeBox ranges_of(const Box& box);

bool is_within(const RangeBox& x, const Box& box);
/// Some coordinate has no common member.
bool are_apart(const RangeBox& x, const RangeBox& y);
bool is_subset(const Box& a, const Box& b);
bool is_disjoint(const Box& a, const Box& b);
/// An order in which equal boxes stand together.
bool is_before(const Box& a, const Box& b);

/// Whether the union of the boxes contains `box`. May say no when that takes too many cuts to tell.
bool is_covered(const Box& box, const std::vector<Box>& boxes);

}  // namespace gcslab::verifier
