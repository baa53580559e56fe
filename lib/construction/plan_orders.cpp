#include "construction/plan_orders.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

#include "base/error.h"

namespace gcslab {

PlacingConstraints::PlacingConstraints(const ConstraintSystem& system, const FigureVariables& variables,
                                       bool only_distances)
    : dimension_(dimension(system.universe)), of_point_(system.points()) {
  for (std::size_t c = 0; c < system.constraints.size(); ++c) {
    const Constraint& constraint = system.constraints[c];
    if (only_distances && constraint.kind->name != "distance") continue;
    std::vector<std::size_t> objects = constraint.objects;
    std::ranges::sort(objects);
    objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
    for (const std::size_t point : objects) {
      if (point >= points()) continue;
      const std::vector<Locus> loci = loci_of(system, constraint, point, {}, variables);
      if (loci.empty()) continue;
      std::vector<std::size_t> others = objects;
      std::erase(others, point);
      const int restriction = constraint.kind->restriction(system.universe);
      of_point_[point].push_back({c, std::move(others), restriction, loci[0].is_sphere});
    }
  }
}

int PlacingConstraints::restriction(const std::vector<bool>& others, std::size_t point,
                                    bool is_in_frame) const {
  int sum = 0;
  for (const Use& use : of_point_[point]) {
    if (is_in_frame && !use.is_for_frames) continue;
    if (std::ranges::all_of(use.others, [&](std::size_t p) { return others[p]; })) sum += use.restriction;
  }
  return sum;
}

int PlacingConstraints::guides_needed(const std::vector<bool>& is_placed, std::size_t placed,
                                      std::size_t point) const {
  const int freedom = static_cast<int>(std::min(placed, dimension_));
  return std::max(0, freedom - restriction(is_placed, point, placed < dimension_));
}

int guides_of(const PlacingConstraints& constraints, const std::vector<std::size_t>& order) {
  std::vector<bool> is_placed(constraints.points(), false);
  int sum = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    sum += constraints.guides_needed(is_placed, k, order[k]);
    is_placed[order[k]] = true;
  }
  return sum;
}

namespace {

/// The order from a frame on.
std::vector<std::size_t> forward_from(const PlacingConstraints& constraints, std::vector<std::size_t> order) {
  std::vector<bool> is_placed(constraints.points(), false);
  for (const std::size_t p : order) is_placed[p] = true;
  while (order.size() < constraints.points()) {
    std::size_t best = constraints.points();
    int most = -1;
    for (std::size_t p = 0; p < constraints.points(); ++p) {
      if (is_placed[p]) continue;
      const int taken = constraints.restriction(is_placed, p, false);
      if (taken > most) best = p, most = taken;
    }
    order.push_back(best);
    is_placed[best] = true;
  }
  return order;
}

/// All ascending lists of `size` points.
void each_frame(std::size_t points, std::size_t size, std::vector<std::size_t>& frame, auto&& use) {
  if (frame.size() == size) {
    use(frame);
    return;
  }
  for (std::size_t p = frame.empty() ? 0 : frame.back() + 1; p < points; ++p) {
    frame.push_back(p);
    each_frame(points, size, frame, use);
    frame.pop_back();
  }
}

}  // namespace

std::vector<std::vector<std::size_t>> forward_orders(const PlacingConstraints& constraints,
                                                     std::size_t dimension) {
  std::vector<std::pair<int, std::vector<std::size_t>>> counted;
  std::vector<std::size_t> frame;
  const std::size_t size = std::min(dimension, constraints.points());
  each_frame(constraints.points(), size, frame, [&](const std::vector<std::size_t>& start) {
    std::vector<std::size_t> order = forward_from(constraints, start);
    const int guides = guides_of(constraints, order);
    counted.emplace_back(guides, std::move(order));
  });
  std::ranges::stable_sort(counted, {}, &std::pair<int, std::vector<std::size_t>>::first);
  std::vector<std::vector<std::size_t>> result;
  for (auto& [guides, order] : counted) result.push_back(std::move(order));
  return result;
}

std::optional<std::vector<std::size_t>> order_without_guides(const PlacingConstraints& constraints,
                                                             std::size_t dimension,
                                                             const std::vector<std::size_t>& first) {
  std::optional<std::vector<std::size_t>> found;
  const auto try_frame = [&](const std::vector<std::size_t>& frame) {
    if (found || guides_of(constraints, frame) > 0) return;
    std::vector<std::size_t> order = forward_from(constraints, frame);
    if (guides_of(constraints, order) == 0) found = std::move(order);
  };
  try_frame(first);
  std::vector<std::size_t> frame;
  if (!found) each_frame(constraints.points(), dimension, frame, try_frame);
  return found;
}

std::vector<std::size_t> gao_order(const PlacingConstraints& constraints, std::size_t dimension) {
  std::vector<bool> is_left(constraints.points(), true);
  std::vector<std::size_t> reversed;
  for (std::size_t left = constraints.points(); left > 0; --left) {
    std::size_t last = constraints.points();
    int least = std::numeric_limits<int>::max();
    const bool is_in_frame = left <= dimension;
    for (std::size_t p = constraints.points(); p-- > 0;) {
      if (!is_left[p]) continue;
      const int taken = constraints.restriction(is_left, p, is_in_frame);
      if (taken < least) last = p, least = taken;
    }
    reversed.push_back(last);
    is_left[last] = false;
  }
  return {reversed.rbegin(), reversed.rend()};
}

std::vector<std::size_t> least_order(const PlacingConstraints& constraints, std::size_t dimension) {
  constexpr std::size_t kLargest = 22;
  const std::size_t n = constraints.points();
  if (n > kLargest)
    throw NotApplicable("the least number of guides is searched among 2^n sets of points, for n to " +
                        std::to_string(kLargest) + ": take another kind of plan");
  using Set = std::uint32_t;
  struct Masked {
    Set others;
    int restriction;
    bool is_for_frames;
  };
  std::vector<std::vector<Masked>> uses(n);
  for (std::size_t p = 0; p < n; ++p) {
    for (const PlacingConstraints::Use& use : constraints.of_point(p)) {
      Set others = 0;
      for (const std::size_t q : use.others) others |= Set{1} << q;
      uses[p].push_back({others, use.restriction, use.is_for_frames});
    }
  }
  constexpr std::uint8_t kUnknown = 255;
  const Set all = (Set{1} << n) - 1;
  std::vector<std::uint8_t> guides(std::size_t{all} + 1, kUnknown), last(guides.size(), 0);
  guides[0] = 0;
  for (Set set = 0; set < all; ++set) {  // subsets come before what contains them
    const auto placed = static_cast<std::size_t>(__builtin_popcount(set));
    const int freedom = static_cast<int>(std::min(placed, dimension));
    for (std::size_t p = 0; p < n; ++p) {
      const Set with = set | Set{1} << p;
      if (with == set) continue;
      int needed = freedom;
      for (const Masked& use : uses[p]) {
        if ((use.others & ~set) == 0 && (placed >= dimension || use.is_for_frames)) needed -= use.restriction;
      }
      const int sum = guides[set] + std::max(needed, 0);
      if (sum >= guides[with]) continue;
      guides[with] = static_cast<std::uint8_t>(sum);
      last[with] = static_cast<std::uint8_t>(p);
    }
  }
  std::vector<std::size_t> order;
  for (Set set = all; set != 0; set &= ~(Set{1} << last[set])) order.push_back(last[set]);
  std::ranges::reverse(order);
  return order;
}

}  // namespace gcslab
