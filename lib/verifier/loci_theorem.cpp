#include "verifier/loci_theorem.h"

#include <algorithm>

namespace gcslab::verifier {
namespace {

using Ranges = std::vector<Range>;

struct Gap {
  std::string reason;
};

/// factor |X|^2 + slope.X + constant, with polynomials of earlier variables and constants.
struct LocusTerms {
  Ranges constants;
  Rational factor;
  std::vector<PolynomialTerms> slope;
  PolynomialTerms constant;
};

/// n.Y + o = 0.
struct RangePlane {
  Ranges normal;
  Range offset;
};

Range dot(const Ranges& a, const Ranges& b) {
  Range sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum = sum + a[i] * b[i];
  return sum;
}

Range squared(const Ranges& a) {
  Range sum;
  for (const Range& x : a) sum = sum + sqr(x);
  return sum;
}

Ranges cross(const Ranges& a, const Ranges& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool is_negative(const Range& x) { return !x.is_empty() && mpfr_sgn(x.upper()) < 0; }

/// A line Q + h u, nearest to the origin at Q; nothing where the planes may not meet in one.
struct RangeLine {
  Ranges nearest, direction;
};

std::optional<RangeLine> meeting_line(const std::vector<RangePlane>& planes) {
  if (planes.empty()) return RangeLine{{Range(0.0)}, {Range(1.0)}};
  RangeLine line;
  if (planes.size() == 1) {
    const Ranges& n = planes[0].normal;
    const Range square = squared(n), length = sqrt(square);
    if (!square.is_positive()) return std::nullopt;
    for (const Range& x : n) line.nearest.push_back(-planes[0].offset * x / square);
    line.direction = {-n[1] / length, n[0] / length};
    return line;
  }
  const Ranges &a = planes[0].normal, &b = planes[1].normal;
  const Ranges w = cross(a, b), bw = cross(b, w), wa = cross(w, a);
  const Range square = squared(w), length = sqrt(square);
  if (!square.is_positive()) return std::nullopt;
  for (std::size_t i = 0; i < w.size(); ++i) {
    line.nearest.push_back(-(planes[0].offset * bw[i] + planes[1].offset * wa[i]) / square);
    line.direction.push_back(w[i] / length);
  }
  return line;
}

/// Where as many planes as there are coordinates meet; nothing where they may not meet in one point.
std::optional<Ranges> meeting_point(const std::vector<RangePlane>& planes) {
  const auto n = [&](std::size_t k) -> const Ranges& { return planes[k].normal; };
  Ranges numerator;
  Range det;
  if (planes.size() == 1) {
    det = n(0)[0];
    numerator = {planes[0].offset};
  } else if (planes.size() == 2) {
    const Range &p = planes[0].offset, &q = planes[1].offset;
    det = n(0)[0] * n(1)[1] - n(0)[1] * n(1)[0];
    numerator = {p * n(1)[1] - q * n(0)[1], q * n(0)[0] - p * n(1)[0]};
  } else {
    const Ranges bc = cross(n(1), n(2)), ca = cross(n(2), n(0)), ab = cross(n(0), n(1));
    det = dot(n(0), bc);
    for (std::size_t i = 0; i < 3; ++i)
      numerator.push_back(planes[0].offset * bc[i] + planes[1].offset * ca[i] + planes[2].offset * ab[i]);
  }
  if (det.contains_zero()) return std::nullopt;
  for (Range& x : numerator) x = -x / det;
  return numerator;
}

class LociReplay {
 public:
  LociReplay(JudgedSystem& system, const Box& search_box, const std::vector<LociBlock>& blocks,
             const std::function<bool(const RangeBox&)>& is_accounted_for)
      : system_(&system),
        blocks_(&blocks),
        is_accounted_for_(&is_accounted_for),
        is_known_(system.variables(), false),
        x_(ranges_of(search_box)) {
    for (const LociBlock& block : blocks) plan(block);
    if (std::ranges::find(is_known_, false) != is_known_.end()) throw Gap{"some variable is in no block"};
  }

  void run() { descend(0); }

 private:
  void plan(const LociBlock& block) {
    constexpr std::size_t kLargest = 3;
    if (block.variables.empty() || block.variables.size() > kLargest ||
        block.equations.size() != block.variables.size())
      throw Gap{"a block has not as many equations as variables, 1 to 3"};
    std::vector<LocusTerms>& loci = loci_.emplace_back();
    for (const std::size_t variable : block.variables) {
      if (is_known_[variable]) throw Gap{"a variable is in two blocks"};
    }
    for (const std::size_t equation : block.equations) loci.push_back(locus(equation, block.variables));
    for (const std::size_t variable : block.variables) {
      if (is_known_[variable]) throw Gap{"a variable is twice in a block"};
      is_known_[variable] = true;
    }
  }

  LocusTerms locus(std::size_t equation, const std::vector<std::size_t>& own) const {
    const auto polynomial = terms_with_constants(system_->equations()[equation].expression, is_known_.size());
    const std::string name = "equation " + std::to_string(equation);
    if (!polynomial) throw Gap{name + " is no polynomial"};
    LocusTerms result{{}, 0, std::vector<PolynomialTerms>(own.size()), {}};
    for (const Expression& constant : polynomial->constants)
      result.constants.push_back(Program(constant, 0).evaluate(std::span<const Range>()));
    std::vector<Rational> squares(own.size(), 0);
    for (const auto& [exponents, coefficient] : polynomial->terms) {
      std::vector<int> earlier = exponents;
      int degree = 0;
      std::size_t last = 0;
      for (std::size_t i = 0; i < own.size(); ++i) {
        const int e = std::exchange(earlier[own[i]], 0);
        degree += e;
        if (e > 0) last = i;
      }
      bool is_number = true;
      for (std::size_t v = 0; v < earlier.size(); ++v) {
        if (earlier[v] == 0) continue;
        is_number = false;
        if (v < is_known_.size() && !is_known_[v]) throw Gap{name + " has a variable of a later block"};
      }
      if (degree == 0) {
        result.constant[earlier] = coefficient;
      } else if (degree == 1) {
        result.slope[last][earlier] = coefficient;
      } else if (degree == 2 && is_number && exponents[own[last]] == 2) {
        squares[last] = coefficient;
      } else {
        throw Gap{name + " is neither a plane nor a sphere in its block"};
      }
    }
    result.factor = squares[0];
    if (std::ranges::any_of(squares, [&](const Rational& s) { return s != result.factor; }))
      throw Gap{name + " is neither a plane nor a sphere in its block"};
    return result;
  }

  Range value(const PolynomialTerms& terms, const Ranges& constants) const {
    Range sum;
    for (const auto& [exponents, coefficient] : terms) {
      Range product(coefficient);
      for (std::size_t v = 0; v < exponents.size(); ++v) {
        if (exponents[v] == 0) continue;
        const Range& x = v < x_.size() ? x_[v] : constants[v - x_.size()];
        product = product * power(x, Rational(exponents[v]));
      }
      sum = sum + product;
    }
    return sum;
  }

  void descend(std::size_t k) {
    if (k == blocks_->size()) {
      finish();
      return;
    }
    std::vector<RangePlane> planes, spheres;
    for (const LocusTerms& terms : loci_[k]) {
      const bool is_sphere = terms.factor != 0;
      const Range factor(is_sphere ? terms.factor : Rational(1));
      RangePlane locus;
      for (const PolynomialTerms& slope : terms.slope)
        locus.normal.push_back(value(slope, terms.constants) / factor);
      locus.offset = value(terms.constant, terms.constants) / factor;
      (is_sphere ? spheres : planes).push_back(std::move(locus));
    }
    if (spheres.empty()) {
      const std::optional<Ranges> point = meeting_point(planes);
      take(k, point ? *point : Ranges(blocks_->at(k).variables.size(), Range::entire()));
      return;
    }
    for (std::size_t s = 1; s < spheres.size(); ++s) {
      RangePlane plane = spheres[s];
      for (std::size_t i = 0; i < plane.normal.size(); ++i)
        plane.normal[i] = plane.normal[i] - spheres[0].normal[i];
      plane.offset = plane.offset - spheres[0].offset;
      planes.push_back(std::move(plane));
    }
    meet_sphere(k, spheres[0], std::move(planes));
  }

  void meet_sphere(std::size_t k, const RangePlane& sphere, std::vector<RangePlane> planes) {
    Ranges centre;
    for (const Range& b : sphere.normal) centre.push_back(-b / Range(2.0));
    const Range square = squared(centre) - sphere.offset;
    for (RangePlane& plane : planes) plane.offset = plane.offset + dot(plane.normal, centre);
    if (is_negative(square)) return;
    const std::optional<RangeLine> line = meeting_line(planes);
    if (!line) {
      if (misses_any(square, planes)) return;
      for (Range& x : centre) x = x + sqrt(square) * Range(Interval(-1, 1));
      take(k, centre);
      return;
    }
    const Range radicand = square - squared(line->nearest), height = sqrt(radicand);
    if (is_negative(radicand)) return;
    const auto at = [&](const Range& h) {
      Ranges point;
      for (std::size_t i = 0; i < centre.size(); ++i)
        point.push_back(centre[i] + line->nearest[i] + h * line->direction[i]);
      return point;
    };
    if (radicand.is_positive()) {
      take(k, at(height));
      take(k, at(-height));
    } else {
      take(k, at(hull(-height, height)));
    }
  }

  /// Whether the sphere misses a plane or a combination of two, so that it misses their line too.
  static bool misses_any(const Range& square, const std::vector<RangePlane>& planes) {
    const auto misses = [&](const RangePlane& plane) {
      return is_negative(square * squared(plane.normal) - sqr(plane.offset));
    };
    for (std::size_t k = 0; k < planes.size(); ++k) {
      if (misses(planes[k])) return true;
      for (std::size_t other = 0; other < planes.size(); ++other) {
        if (other == k) continue;
        const Range factor(
            middle(dot(planes[k].normal, planes[other].normal) / squared(planes[other].normal)));
        RangePlane combined{{}, planes[k].offset - factor * planes[other].offset};
        for (std::size_t i = 0; i < planes[k].normal.size(); ++i)
          combined.normal.push_back(planes[k].normal[i] - factor * planes[other].normal[i]);
        if (misses(combined)) return true;
      }
    }
    return false;
  }

  /// Goes on with these values of a block where they meet the search box.
  void take(std::size_t k, const Ranges& values) {
    const std::vector<std::size_t>& variables = blocks_->at(k).variables;
    Ranges before;
    bool is_outside = false;
    for (std::size_t i = 0; i < variables.size(); ++i) {
      Range& x = x_[variables[i]];
      before.push_back(x);
      x = intersection(x, values[i]);
      is_outside = is_outside || x.is_empty();
    }
    if (!is_outside) descend(k + 1);
    for (std::size_t i = 0; i < variables.size(); ++i) x_[variables[i]] = before[i];
  }

  void finish() {
    constexpr std::size_t kMost = std::size_t{1} << 20;
    if (++figures_ > kMost) throw Gap{"there are too many branches"};
    for (JudgedFunction& equation : system_->equations()) {
      const Range value = equation.program.evaluate(x_);
      if (value.is_empty() || !value.contains_zero()) return;
    }
    if (!(*is_accounted_for_)(x_))
      throw Gap{"the figure of a branch is neither a listed solution nor in an undecided box"};
  }

  JudgedSystem* system_;
  const std::vector<LociBlock>* blocks_;
  const std::function<bool(const RangeBox&)>* is_accounted_for_;
  std::vector<bool> is_known_;  ///< of the blocks so far
  std::vector<std::vector<LocusTerms>> loci_;
  RangeBox x_;  ///< of the blocks so far what the branch gives, of the others the search box
  std::size_t figures_ = 0;
};

}  // namespace

std::optional<std::string> loci_theorem_gap(JudgedSystem& system, const Box& search_box,
                                            const std::vector<LociBlock>& blocks,
                                            const std::function<bool(const RangeBox&)>& is_accounted_for) {
  try {
    LociReplay(system, search_box, blocks, is_accounted_for).run();
  } catch (const Gap& gap) {
    return gap.reason;
  }
  return std::nullopt;
}

}  // namespace gcslab::verifier
