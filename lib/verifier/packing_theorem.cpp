#include "verifier/packing_theorem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace gcslab::verifier {
namespace {

/// x, y, r of a fixed disc.
using FixedDisc = std::array<Rational, 3>;

/// What a function says of two discs: factor * (|c - c'|^2 - (r + r')^2). The second is number `other`, or
/// fixed.
struct Pair {
  std::size_t disc;
  std::optional<std::size_t> other;
  FixedDisc fixed;
  Rational factor;
};

using Pairs = std::set<std::pair<std::size_t, std::size_t>>;

class Terms {
 public:
  Terms(const PolynomialTerms& terms, std::size_t variables) : terms_(terms), variables_(variables) {}

  std::size_t count() const { return terms_.size(); }
  Rational at(std::initializer_list<std::size_t> variables) const {
    std::vector<int> exponents(variables_, 0);
    for (const std::size_t variable : variables) ++exponents[variable];
    const auto found = terms_.find(exponents);
    return found == terms_.end() ? Rational(0) : found->second;
  }
  /// The discs whose squares occur in it, ascending.
  std::vector<std::size_t> discs() const {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i + 2 < variables_; i += 3) {
      if (at({i, i}) != 0) result.push_back(i / 3);
    }
    return result;
  }

 private:
  const PolynomialTerms& terms_;
  std::size_t variables_;
};

/// factor times x^2 + y^2 - r^2 of a disc, in the quadratic terms of its own.
bool has_squares(const Terms& terms, std::size_t disc, const Rational& factor) {
  const std::size_t x = 3 * disc;
  return terms.at({x, x}) == factor && terms.at({x + 1, x + 1}) == factor &&
         terms.at({x + 2, x + 2}) == -factor;
}

/// Six squares and three products, and nothing else: |c|^2 + |c'|^2 - r^2 - r'^2 - 2 (x x' + y y' + r r').
bool is_pair_of_discs(const Terms& terms, std::size_t a, std::size_t b, const Rational& factor) {
  if (terms.count() != 9 || !has_squares(terms, a, factor) || !has_squares(terms, b, factor)) return false;
  for (std::size_t part = 0; part < 3; ++part) {
    if (terms.at({3 * a + part, 3 * b + part}) != -2 * factor) return false;
  }
  return true;
}

/// |c|^2 - r^2 - 2 (x x' + y y' + r r') + x'^2 + y'^2 - r'^2 with the numbers x', y', r' of `fixed`.
bool is_pair_with_fixed(const Terms& terms, std::size_t disc, const FixedDisc& fixed,
                        const Rational& factor) {
  const Rational rest = factor * (fixed[0] * fixed[0] + fixed[1] * fixed[1] - fixed[2] * fixed[2]);
  std::size_t count = rest == 0 ? 3 : 4;
  for (const Rational& number : fixed) count += number == 0 ? 0U : 1U;
  return terms.count() == count && has_squares(terms, disc, factor) && terms.at({}) == rest;
}

std::optional<Pair> pair_of(const JudgedFunction& function, std::size_t variables) {
  if (!function.polynomial) return std::nullopt;
  const Terms terms(*function.polynomial, variables);
  const std::vector<std::size_t> discs = terms.discs();
  if (discs.empty() || discs.size() > 2) return std::nullopt;
  const std::size_t x = 3 * discs[0];
  Pair pair{discs[0], std::nullopt, {}, terms.at({x, x})};
  if (discs.size() == 2) {
    pair.other = discs[1];
    return is_pair_of_discs(terms, discs[0], discs[1], pair.factor) ? std::optional(pair) : std::nullopt;
  }
  for (std::size_t part = 0; part < 3; ++part) pair.fixed[part] = terms.at({x + part}) / (-2 * pair.factor);
  return is_pair_with_fixed(terms, discs[0], pair.fixed, pair.factor) ? std::optional(pair) : std::nullopt;
}

bool are_tangent(const FixedDisc& a, const FixedDisc& b) {
  const Rational dx = a[0] - b[0], dy = a[1] - b[1], sum = a[2] + b[2];
  return a[2] > 0 && b[2] > 0 && dx * dx + dy * dy == sum * sum;
}

/// The discs of a pair as numbers: those of the box first, then the fixed ones. Nothing for another fixed
/// disc.
std::optional<std::pair<std::size_t, std::size_t>> numbers_of(const Pair& pair, std::size_t discs,
                                                              const std::vector<FixedDisc>& fixed) {
  if (pair.other) return std::minmax(pair.disc, *pair.other);
  const auto found = std::ranges::find(fixed, pair.fixed);
  if (found == fixed.end()) return std::nullopt;
  return std::pair(pair.disc, discs + static_cast<std::size_t>(found - fixed.begin()));
}

/// Something that the box or a fixed disc allows lies below the number, and something above.
bool is_inside(const Rational& number, std::size_t part, const std::vector<FixedDisc>& fixed,
               const Box& box) {
  bool below = false, above = false;
  for (const FixedDisc& disc : fixed) {
    below = below || disc[part] < number;
    above = above || disc[part] > number;
  }
  for (std::size_t i = part; i < box.size(); i += 3) {
    below = below || !std::isfinite(box[i].lower) || Rational(box[i].lower) < number;
    above = above || !std::isfinite(box[i].upper) || Rational(box[i].upper) > number;
  }
  return below && above;
}

class PackingJudge {
 public:
  PackingJudge(JudgedSystem& system, const Box& box) : system_(system), box_(box), discs_(box.size() / 3) {}

  std::optional<std::string> gap() {
    if (box_.size() % 3 != 0 || system_.equations().size() != box_.size())
      return "there are not three variables and three equations a disc";
    if (auto reason = read_equations()) return reason;
    if (fixed_.size() != 3) return "there are not three fixed discs";
    for (std::size_t i = 0; i < 3; ++i) {
      if (!are_tangent(fixed_[i], fixed_[(i + 1) % 3])) return "the fixed discs are not tangent";
    }
    if (auto reason = relate_all()) return reason;
    return gap_of_box();
  }

 private:
  std::optional<std::string> read_equations() {
    for (std::size_t k = 0; k < system_.equations().size(); ++k) {
      const auto pair = pair_of(system_.equations()[k], box_.size());
      if (!pair) return "equation " + std::to_string(k) + " does not say that two discs are tangent";
      tangencies_.push_back(*pair);
      if (!pair->other && std::ranges::find(fixed_, pair->fixed) == fixed_.end())
        fixed_.push_back(pair->fixed);
    }
    return std::nullopt;
  }

  /// Every pair but the fixed ones has its equation, once, or an inequality.
  std::optional<std::string> relate_all() {
    Pairs related;
    for (const Pair& pair : tangencies_) {
      if (!related.insert(*numbers_of(pair, discs_, fixed_)).second)
        return "two equations are about one pair";
    }
    for (const JudgedFunction& inequality : system_.inequalities()) {
      const auto pair = pair_of(inequality, box_.size());
      if (!pair || pair->factor > 0) continue;
      if (const auto numbers = numbers_of(*pair, discs_, fixed_)) related.insert(*numbers);
    }
    const std::size_t wanted = discs_ * (discs_ - 1) / 2 + 3 * discs_;
    if (related.size() != wanted) return "some pair of discs may overlap";
    return std::nullopt;
  }

  std::optional<std::string> gap_of_box() const {
    for (std::size_t i = 2; i < box_.size(); i += 3) {
      if (!(box_[i].lower > 0)) return "the box allows a radius that is not positive";
    }
    for (const FixedDisc& disc : fixed_) {
      if (is_inside(disc[0], 0, fixed_, box_) && is_inside(disc[1], 1, fixed_, box_))
        return "the box allows discs on the other side of the fixed ones";
    }
    return std::nullopt;
  }

  JudgedSystem& system_;
  const Box& box_;
  std::size_t discs_;
  std::vector<Pair> tangencies_;
  std::vector<FixedDisc> fixed_;
};

}  // namespace

std::optional<std::string> packing_theorem_gap(JudgedSystem& system, const Box& search_box) {
  return PackingJudge(system, search_box).gap();
}

}  // namespace gcslab::verifier
