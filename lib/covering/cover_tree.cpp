#include "covering/cover_tree.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "base/check.h"
#include "base/error.h"

namespace gcslab {
namespace {

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::string_view name_of(Split split) { return split == Split::all ? "all" : "alternate"; }

Split split_from_name(std::string_view name) {
  if (name == "all") return Split::all;
  if (name == "alternate") return Split::alternate;
  throw InputError("unknown split '" + std::string(name) + "' (known: all, alternate)");
}

Interval lower_half(const Interval& side) { return {side.lower, midpoint(side)}; }
Interval upper_half(const Interval& side) { return {midpoint(side), side.upper}; }

CoverTree::CoverTree(Box domain, int depth, Split split)
    : domain_(std::move(domain)), depth_(depth), split_(split) {
  GCSLAB_CHECK(!domain_.empty() && depth >= 0);
}

int CoverTree::last_level() const {
  return split_ == Split::all ? depth_ : depth_ * static_cast<int>(domain_.size());
}

void CoverTree::append(bool may_meet) {
  if (bit_count_ % 64 == 0) words_.push_back(0);
  if (may_meet) words_.back() |= std::uint64_t{1} << (bit_count_ % 64);
  ++bit_count_;
}

/// A preorder walk over the recorded cells.
class CoverTree::Walk {
 public:
  Walk(const CoverTree& tree, std::function<void(const CoverLeaf&)> visit)
      : tree_(tree), visit_(std::move(visit)), box_(tree.domain_) {}

  /// Also counts the visited cells of each level into `per_level`.
  void count_levels(std::vector<std::uint64_t>& per_level) { per_level_ = &per_level; }

  void run() {
    cell(0);
    if (next_ != tree_.bit_count_) throw InputError("a cover tree has cells after its last one");
  }

 private:
  void cell(int level) {
    if (next_ >= tree_.bit_count_) {
      if (tree_.truncated_) return;
      throw InputError("a cover tree ends before its last cell");
    }
    const bool may_meet = tree_.bit(next_++);
    if (per_level_ != nullptr) {
      per_level_->resize(std::max(per_level_->size(), static_cast<std::size_t>(level) + 1));
      ++(*per_level_)[static_cast<std::size_t>(level)];
    }
    if (!may_meet || level == tree_.last_level()) {
      visit_({box_, level, may_meet});
    } else if (tree_.split_ == Split::all) {
      halve(level, 0, box_.size());
    } else {
      const std::size_t variable = static_cast<std::size_t>(level) % box_.size();
      halve(level, variable, variable + 1);
    }
  }

  /// Visits the children that arise from halving the variables first .. last - 1.
  void halve(int level, std::size_t first, std::size_t last) {
    if (first == last) {
      cell(level + 1);
      return;
    }
    const Interval side = box_[first];
    box_[first] = lower_half(side);
    halve(level, first + 1, last);
    box_[first] = upper_half(side);
    halve(level, first + 1, last);
    box_[first] = side;
  }

  const CoverTree& tree_;
  std::function<void(const CoverLeaf&)> visit_;
  std::vector<std::uint64_t>* per_level_ = nullptr;
  Box box_;
  std::uint64_t next_ = 0;
};

void CoverTree::for_each_leaf(const std::function<void(const CoverLeaf&)>& visit) const {
  Walk(*this, visit).run();
}

std::uint64_t CoverTree::kept_cells() const {
  std::uint64_t kept = 0;
  for_each_leaf([&](const CoverLeaf& leaf) { kept += leaf.kept ? 1 : 0; });
  return kept;
}

std::vector<std::uint64_t> CoverTree::visited_per_level() const {
  std::vector<std::uint64_t> visited;
  const auto ignore = [](const CoverLeaf&) {};
  Walk walk(*this, ignore);
  walk.count_levels(visited);
  walk.run();
  return visited;
}

nlohmann::json CoverTree::to_json() const {
  std::string text;
  for (std::uint64_t first = 0; first < bit_count_; first += 6) {
    unsigned digit = 0;
    for (std::uint64_t k = first; k < std::min(first + 6, bit_count_); ++k) {
      digit |= static_cast<unsigned>(bit(k)) << (k - first);
    }
    text += kDigits[digit];
  }
  nlohmann::json sides = nlohmann::json::array();
  for (const Interval& side : domain_) sides.push_back({side.lower, side.upper});
  return {{"domain", sides},     {"depth", depth_},         {"split", name_of(split_)},
          {"cells", bit_count_}, {"truncated", truncated_}, {"tree", text}};
}

CoverTree CoverTree::from_json(const nlohmann::json& json) {
  try {
    Box domain;
    for (const auto& side : json.at("domain"))
      domain.emplace_back(side.at(0).get<double>(), side.at(1).get<double>());
    CoverTree tree(domain, json.at("depth").get<int>(), split_from_name(json.at("split").get<std::string>()));
    const std::uint64_t cells = json.at("cells").get<std::uint64_t>();
    for (const char c : json.at("tree").get<std::string>()) {
      const std::size_t digit = kDigits.find(c);
      if (digit == std::string_view::npos) throw InputError("a cover tree has a character that is no digit");
      for (unsigned k = 0; k < 6 && tree.bit_count_ < cells; ++k) tree.append((digit >> k & 1) != 0);
    }
    if (tree.bit_count_ != cells) throw InputError("a cover tree has fewer cells than it says");
    tree.truncated_ = json.at("truncated").get<bool>();
    return tree;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(std::string("a cover tree cannot be read: ") + error.what());
  }
}

}  // namespace gcslab
