#pragma once

// What a composition of contractors has met in a search so far: by it the composition judges whether a dear
// part is worth its cost.
//
// Sizes are base-2 logarithms of volumes, so that a cut makes a box smaller by 1; halvings are differences of
// sizes. All numbers are sums over boxes: experiences add up.

#include <array>
#include <cstddef>

namespace gcslab {

struct DearPartExperience {
  double boxes = 0;     ///< on which the part was called
  double calls = 0;     ///< on these, again where it shrank them much
  double cost = 0;      ///< of these calls, in arithmetic operations
  double halvings = 0;  ///< that it saved, those of a whole subtree where it emptied the box
};

struct Experience {
  static constexpr std::size_t kDearParts = 2;

  double boxes = 0;      ///< that the cheap parts did not empty
  double rounds = 0;     ///< of them on these
  double halvings = 0;   ///< that they saved on these
  double leaves = 0;     ///< boxes that the cheap parts emptied
  double leaf_size = 0;  ///< of these before, summed
  std::array<DearPartExperience, kDearParts> dear{};

  Experience& operator+=(const Experience& other) {
    boxes += other.boxes;
    rounds += other.rounds;
    halvings += other.halvings;
    leaves += other.leaves;
    leaf_size += other.leaf_size;
    for (std::size_t i = 0; i < kDearParts; ++i) {
      dear[i].boxes += other.dear[i].boxes;
      dear[i].calls += other.dear[i].calls;
      dear[i].cost += other.dear[i].cost;
      dear[i].halvings += other.dear[i].halvings;
    }
    return *this;
  }
};

}  // namespace gcslab
