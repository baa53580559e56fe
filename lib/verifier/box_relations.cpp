#include "verifier/box_relations.h"

#include <algorithm>

namespace gcslab::verifier {
namespace {

/// Cuts at the faces of boxes until every piece lies in one.
class Covering {
 public:
  bool covers(const Box& box, const std::vector<Box>& boxes) {
    std::vector<Box> near;
    for (const Box& other : boxes) {
      if (is_subset(box, other)) return true;
      if (!is_disjoint(box, other)) near.push_back(other);
    }
    if (--cuts_left_ < 0) return false;
    for (const Box& other : near) {
      for (std::size_t i = 0; i < box.size(); ++i) {
        for (const double face : {other[i].lower, other[i].upper}) {
          if (box[i].lower < face && face < box[i].upper) return covers_halves(box, i, face, near);
        }
      }
    }
    return false;
  }

 private:
  bool covers_halves(Box box, std::size_t variable, double point, const std::vector<Box>& boxes) {
    const double upper = box[variable].upper;
    box[variable].upper = point;
    if (!covers(box, boxes)) return false;
    box[variable] = {point, upper};
    return covers(box, boxes);
  }

  int cuts_left_ = 100'000;
};

}  // namespace

RangeBox ranges_of(const Box& box) {
  RangeBox result;
  result.reserve(box.size());
  for (const Interval& side : box) result.emplace_back(side);
  return result;
}

bool is_within(const RangeBox& x, const Box& box) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!x[i].is_within(box[i])) return false;
  }
  return true;
}

bool are_apart(const RangeBox& x, const RangeBox& y) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i].is_disjoint_from(y[i])) return true;
  }
  return false;
}

bool is_subset(const Box& a, const Box& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!subset(a[i], b[i])) return false;
  }
  return true;
}

bool is_disjoint(const Box& a, const Box& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (disjoint(a[i], b[i])) return true;
  }
  return false;
}

bool is_before(const Box& a, const Box& b) {
  return std::ranges::lexicographical_compare(a, b, [](const Interval& x, const Interval& y) {
    return x.lower < y.lower || (x.lower == y.lower && x.upper < y.upper);
  });
}

bool is_covered(const Box& box, const std::vector<Box>& boxes) { return Covering().covers(box, boxes); }

}  // namespace gcslab::verifier
