#include "box_solver/box_clusters.h"

#include <algorithm>
#include <optional>

namespace gcslab {
namespace {

/// Sides of a hull are at most this part of the search box's.
constexpr double kSmall = 1e-5;

/// How many of the last clusters a box may join: searches go from neighbour to neighbour.
constexpr std::size_t kWindow = 16;

/// No gap between them is wider than the wider of the two.
bool are_near(const Box& a, const Box& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double gap = std::max(a[i].lower - b[i].upper, b[i].lower - a[i].upper);
    if (gap > std::max(width(a[i]), width(b[i]))) return false;
  }
  return true;
}

Box hull_of(const Box& a, const Box& b) {
  Box result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(hull(a[i], b[i]));
  return result;
}

class Clustering {
 public:
  explicit Clustering(const Box& search_box) {
    for (const Interval& side : search_box)
      largest_.push_back(kSmall * (is_bounded(side) && width(side) > 0 ? width(side) : 1));
  }

  void add(UndecidedBox entry) {
    while (const auto partner = find_partner(entry)) {
      entry.box = hull_of(entry.box, clusters_[*partner].box);
      clusters_.erase(clusters_.begin() + static_cast<std::ptrdiff_t>(*partner));
    }
    clusters_.push_back(std::move(entry));
  }

  std::vector<UndecidedBox> take() { return std::move(clusters_); }

 private:
  std::optional<std::size_t> find_partner(const UndecidedBox& entry) const {
    const std::size_t first = clusters_.size() > kWindow ? clusters_.size() - kWindow : 0;
    for (std::size_t k = clusters_.size(); k-- > first;) {
      const bool fits = clusters_[k].reason == entry.reason && are_near(clusters_[k].box, entry.box);
      if (fits && is_small(hull_of(clusters_[k].box, entry.box))) return k;
    }
    return std::nullopt;
  }

  bool is_small(const Box& box) const {
    for (std::size_t i = 0; i < box.size(); ++i) {
      if (!(width(box[i]) <= largest_[i])) return false;
    }
    return true;
  }

  std::vector<double> largest_;
  std::vector<UndecidedBox> clusters_;
};

}  // namespace

std::vector<UndecidedBox> clustered(std::vector<UndecidedBox> boxes, const Box& search_box) {
  Clustering clustering(search_box);
  for (UndecidedBox& entry : boxes) clustering.add(std::move(entry));
  return clustering.take();
}

}  // namespace gcslab
