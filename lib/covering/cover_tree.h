#pragma once

// The record of a cover: which cells of the subdivision were visited, and which were kept.
//
// A cell of level k is split into 2^n children (`all`: every variable is halved) or 2 (`alternate`: variable
// number k mod n is halved). One bit a visited cell, in preorder: 1 = the cell may meet the set (it is split,
// or kept when it stands on the last level), 0 = the cell is proved not to meet it. Corners of cells are
// dyadic in the domain: a side [lo, hi] is cut at its midpoint, rounded to double, so neighbouring cells
// share their corners exactly.

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "interval/interval.h"

namespace gcslab {

/// How a cell is cut.
enum class Split { all, alternate };

std::string_view name_of(Split split);
Split split_from_name(std::string_view name);

/// The two halves of an interval; their common end is its midpoint.
Interval lower_half(const Interval& side);
Interval upper_half(const Interval& side);

struct CoverLeaf {
  const Box& box;
  int level;  ///< number of splits above the cell
  bool kept;
};

class CoverTree {
 public:
  /// `depth` counts halvings of every variable.
  CoverTree(Box domain, int depth, Split split);

  const Box& domain() const { return domain_; }
  int depth() const { return depth_; }
  Split split() const { return split_; }
  /// Level of the kept cells: depth, or depth * n for alternate splits.
  int last_level() const;

  /// Appends the verdict on the next cell in preorder.
  void append(bool may_meet);
  /// Says that the search stopped here: the cells that follow in preorder are unknown.
  void truncate() { truncated_ = true; }
  bool is_truncated() const { return truncated_; }

  std::uint64_t visited_cells() const { return bit_count_; }
  std::uint64_t kept_cells() const;
  /// Number of visited cells of each level, from the root to the deepest one visited.
  std::vector<std::uint64_t> visited_per_level() const;

  /// Calls `visit` for every known cell that was not split, in preorder.
  void for_each_leaf(const std::function<void(const CoverLeaf&)>& visit) const;

  /// {"domain", "depth", "split", "cells", "truncated", "tree"}: number of visited cells and their bits in
  /// base64.
  nlohmann::json to_json() const;
  /// The inverse. Throws InputError when the text is no complete tree.
  static CoverTree from_json(const nlohmann::json& json);

 private:
  class Walk;

  bool bit(std::uint64_t index) const { return (words_[index / 64] >> (index % 64) & 1) != 0; }

  Box domain_;
  int depth_;
  Split split_;
  std::vector<std::uint64_t> words_;
  std::uint64_t bit_count_ = 0;
  bool truncated_ = false;
};

}  // namespace gcslab
