#include "geometry/congruence.h"

#include <algorithm>
#include <numeric>

#include "interval/fast_interval.h"

namespace gcslab {
namespace {

using Sides = std::vector<FastInterval>;

FastInterval dot(const Sides& a, const Sides& b) {
  FastInterval sum(Interval(0));
  for (std::size_t i = 0; i < a.size(); ++i) sum = sum + a[i] * b[i];
  return sum;
}

Sides difference(const Sides& a, const Sides& b) {
  Sides result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - b[i]);
  return result;
}

/// a - factor b.
Sides less_multiple(const Sides& a, const FastInterval& factor, const Sides& b) {
  Sides result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - factor * b[i]);
  return result;
}

/// A number that isometries keep, but for the signs of up to two directions, by number; 0 is no direction.
struct Invariant {
  Interval value;
  std::size_t first = 0, second = 0;
};

/// What determines a figure up to isometry: the Gram matrix of vectors from its first position, and numbers.
class Invariants {
 public:
  Invariants(const std::vector<Sort>& sorts, Universe universe, const FigureBox& figure)
      : origin_(dimension(universe), FastInterval(Interval(0))) {
    std::vector<ObjectParts<FastInterval>> objects;
    for (std::size_t k = 0; k < sorts.size(); ++k) {
      Sides coordinates;
      for (const Interval& side : figure[k]) coordinates.emplace_back(side);
      objects.push_back(parts_of(sorts[k], universe, coordinates));
      if (sorts[k] != Sort::line && !objects[k].position.empty()) add_position(objects[k].position);
    }
    if (!positions_.empty()) origin_ = positions_.front();
    for (std::size_t k = 0; k < sorts.size(); ++k) add(sorts[k], objects[k]);
    add_products();
  }

  const std::vector<Invariant>& all() const { return invariants_; }
  std::size_t directions() const { return directions_.size(); }

 private:
  void add(Sort sort, const ObjectParts<FastInterval>& parts) {
    if (parts.radius) put(sqr(*parts.radius));
    if (parts.direction.empty()) return;
    directions_.push_back(parts.direction);
    if (parts.offset) put(*parts.offset - dot(parts.direction, origin_), directions_.size());
    if (sort != Sort::line || parts.position.empty()) return;
    const Sides to_line = difference(parts.position, origin_);
    to_lines_.push_back(less_multiple(to_line, dot(parts.direction, to_line), parts.direction));
  }

  void add_position(const Sides& position) {
    for (const Sides& other : positions_) {
      const Sides offset = difference(position, other);
      FastInterval sum(Interval(0));
      for (const FastInterval& side : offset) sum = sum + sqr(side);
      put(sum);
    }
    positions_.push_back(position);
  }

  void add_products() {
    std::vector<Sides> unsigned_ones = to_lines_;
    for (std::size_t p = 1; p < positions_.size(); ++p) {
      unsigned_ones.push_back(difference(positions_[p], origin_));
      for (const Sides& to_line : to_lines_) put(dot(to_line, unsigned_ones.back()));
    }
    for (std::size_t j = 0; j < to_lines_.size(); ++j) {
      for (std::size_t k = 0; k <= j; ++k) put(dot(to_lines_[j], to_lines_[k]));
    }
    for (std::size_t j = 0; j < directions_.size(); ++j) {
      for (const Sides& other : unsigned_ones) put(dot(directions_[j], other), j + 1);
      for (std::size_t k = 0; k < j; ++k) put(dot(directions_[j], directions_[k]), j + 1, k + 1);
    }
  }

  void put(const FastInterval& value, std::size_t first = 0, std::size_t second = 0) {
    invariants_.push_back({value.interval(), first, second});
  }

  Sides origin_;  ///< the first position
  std::vector<Sides> positions_, directions_;
  std::vector<Sides> to_lines_;  ///< from the origin at right angles
  std::vector<Invariant> invariants_;
};

/// Signs that are equal or opposite to others: sets of them, each with a sign relative to its first (a
/// union-find structure with parities). Sign 0 is +.
class Signs {
 public:
  explicit Signs(std::size_t count) : parent_(count), is_opposite_(count, false) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /// Whether that may be so besides all that was said before.
  bool relate(std::size_t a, std::size_t b, bool are_opposite) {
    const auto [root_a, opposite_a] = root(a);
    const auto [root_b, opposite_b] = root(b);
    const bool between_roots = (opposite_a != opposite_b) != are_opposite;
    if (root_a == root_b) return !between_roots;
    parent_[root_a] = root_b;
    is_opposite_[root_a] = between_roots;
    return true;
  }

 private:
  std::pair<std::size_t, bool> root(std::size_t a) const {
    bool is_opposite = false;
    for (; parent_[a] != a; a = parent_[a]) is_opposite = is_opposite != is_opposite_[a];
    return {a, is_opposite};
  }

  std::vector<std::size_t> parent_;
  std::vector<bool> is_opposite_;
};

bool may_be_congruent(const Invariants& a, const Invariants& b) {
  Signs signs(a.directions() + 1);
  for (std::size_t k = 0; k < a.all().size(); ++k) {
    const auto& [value, first, second] = a.all()[k];
    const Interval& other = b.all()[k].value;
    const bool may_be_equal = !disjoint(value, other);
    const bool may_be_opposite = first != second && !disjoint(value, Interval(-other.upper, -other.lower));
    if (!may_be_equal && !may_be_opposite) return false;
    if (may_be_equal != may_be_opposite && first != second && !signs.relate(first, second, may_be_opposite))
      return false;
  }
  return true;
}

}  // namespace

std::vector<std::vector<std::size_t>> congruence_classes(const std::vector<Sort>& sorts, Universe universe,
                                                         const std::vector<FigureBox>& figures) {
  const NumberTraits<FastInterval>::Scope scope;
  std::vector<Invariants> invariants;
  for (const FigureBox& figure : figures) invariants.emplace_back(sorts, universe, figure);
  std::vector<std::vector<std::size_t>> classes;
  for (std::size_t f = 0; f < figures.size(); ++f) {
    const auto is_like = [&](const std::vector<std::size_t>& members) {
      return may_be_congruent(invariants[members.front()], invariants[f]);
    };
    const auto found = std::ranges::find_if(classes, is_like);
    if (found == classes.end()) {
      classes.push_back({f});
    } else {
      found->push_back(f);
    }
  }
  return classes;
}

}  // namespace gcslab
