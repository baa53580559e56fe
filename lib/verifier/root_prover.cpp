#include "verifier/root_prover.h"

#include <algorithm>

#include "verifier/box_relations.h"

namespace gcslab::verifier {
namespace {

bool is_inside(const RangeBox& x, const RangeBox& y) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!x[i].is_inside(y[i])) return false;
  }
  return true;
}

/// Grown by half its width, a few units in the last place and a tiny number (epsilon-inflation, Rump 1983).
Range inflated(const Range& x) {
  Real grow;
  mpfr_sub(grow.get(), x.upper(), x.lower(), MPFR_RNDU);
  mpfr_div_2ui(grow.get(), grow.get(), 1, MPFR_RNDU);
  Real part = magnitude(x);
  mpfr_mul_d(part.get(), part.get(), 0x1p-240, MPFR_RNDU);
  mpfr_add(grow.get(), grow.get(), part.get(), MPFR_RNDU);
  mpfr_add_d(grow.get(), grow.get(), 0x1p-1000, MPFR_RNDU);
  Range result;
  mpfr_sub(result.lower(), x.lower(), grow.get(), MPFR_RNDD);
  mpfr_add(result.upper(), x.upper(), grow.get(), MPFR_RNDU);
  return result;
}

/// The sum of products of numbers with the middles of ranges.
Real middle_product(const std::vector<Real>& row, const RangeBox& values) {
  Real sum;
  for (std::size_t k = 0; k < row.size(); ++k) {
    const Real value = middle(values[k]);
    mpfr_fma(sum.get(), row[k].get(), value.get(), sum.get(), MPFR_RNDN);
  }
  return sum;
}

RangeBox at_point(const std::vector<Real>& point) {
  RangeBox result;
  for (const Real& x : point) result.emplace_back(x);
  return result;
}

/// Whether every move is below 2^-120 of its coordinate, or of 2^-300 near 0.
bool is_settled(const std::vector<Real>& moves, const std::vector<Real>& point) {
  for (std::size_t i = 0; i < moves.size(); ++i) {
    Real limit;
    mpfr_abs(limit.get(), point[i].get(), MPFR_RNDN);
    mpfr_add_d(limit.get(), limit.get(), 0x1p-300, MPFR_RNDN);
    mpfr_mul_d(limit.get(), limit.get(), 0x1p-120, MPFR_RNDN);
    if (mpfr_cmpabs(moves[i].get(), limit.get()) > 0) return false;
  }
  return true;
}

}  // namespace

bool RootProver::evaluate(const RangeBox& centre, RangeBox& values) {
  values.clear();
  for (JudgedFunction& equation : system_->equations()) {
    values.push_back(equation.program.evaluate(centre));
    if (!values.back().is_bounded()) return false;
  }
  return true;
}

/// Moves the point until it settles. What it finds proves nothing yet.
bool RootProver::newton(std::vector<Real>& point, RealMatrix& inverse) {
  constexpr int kMaximumSteps = 12;
  RangeBox values;
  for (int step = 0; step < kMaximumSteps; ++step) {
    const RangeBox centre = at_point(point);
    if (!system_->slopes(centre, centre, slopes_) || !evaluate(centre, values)) return false;
    if (!invert(middles(slopes_), inverse)) return false;
    std::vector<Real> moves;
    for (std::size_t i = 0; i < point.size(); ++i) {
      moves.push_back(middle_product(inverse[i], values));
      mpfr_sub(point[i].get(), point[i].get(), moves[i].get(), MPFR_RNDN);
      if (mpfr_number_p(point[i].get()) == 0) return false;
    }
    if (is_settled(moves, point)) return true;
  }
  return true;
}

void RootProver::compute_residual(const RealMatrix& inverse) {
  const std::size_t n = system_->variables();
  residual_.assign(n, RangeBox(n));
  for (std::size_t i = 0; i < n; ++i) {
    residual_[i][i] = 1.0;
    for (std::size_t k = 0; k < n; ++k) {
      if (mpfr_zero_p(inverse[i][k].get()) != 0) continue;
      const Range factor(inverse[i][k]);
      for (std::size_t j = 0; j < n; ++j) {
        if (!slopes_[k][j].is_zero()) residual_[i][j] = residual_[i][j] - factor * slopes_[k][j];
      }
    }
  }
}

/// K(x); false where the equations may be undefined.
bool RootProver::image(const RangeBox& x, const RangeBox& centre, const RealMatrix& inverse,
                       RangeBox& result) {
  RangeBox values;
  if (!system_->slopes(x, centre, slopes_) || !evaluate(centre, values)) return false;
  compute_residual(inverse);
  result = centre;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t k = 0; k < x.size(); ++k) result[i] = result[i] - Range(inverse[i][k]) * values[k];
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (!residual_[i][j].is_zero()) result[i] = result[i] + residual_[i][j] * (x[j] - centre[j]);
    }
    if (!result[i].is_bounded()) return false;
  }
  return true;
}

/// K(x) for a box x around the centre that it maps into its interior.
std::optional<RangeBox> RootProver::contracted(const RangeBox& centre, const RealMatrix& inverse) {
  constexpr int kAttempts = 10;
  RangeBox x = centre;
  RangeBox k;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    if (!image(x, centre, inverse, k)) return std::nullopt;
    if (is_inside(k, x)) return k;
    // Sides that hold their images stay: where others are far narrower, their images would grow along.
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!k[i].is_inside(x[i])) x[i] = inflated(hull(x[i], k[i]));
    }
  }
  return std::nullopt;
}

/// Cuts a box that contains a root down by every equation: a linear one may leave a single number.
bool RootProver::tighten(RangeBox& box) {
  for (JudgedFunction& equation : system_->equations()) {
    Program& program = equation.program;
    if (!program.propagate(box, 0.0)) return false;
    for (const std::size_t i : program.variables()) box[i] = intersection(box[i], program.narrowed(i));
  }
  return true;
}

std::optional<EnclosedRoot> RootProver::enclose(const Box& claimed) {
  if (!system_->is_square() || !std::ranges::all_of(claimed, is_bounded)) return std::nullopt;
  std::vector<Real> point;
  for (const Interval& side : claimed) point.emplace_back(midpoint(side));
  EnclosedRoot root;
  if (!newton(point, root.inverse)) return std::nullopt;
  std::optional<RangeBox> enclosure = contracted(at_point(point), root.inverse);
  if (!enclosure) return std::nullopt;
  root.enclosure = std::move(*enclosure);
  if (is_within(root.enclosure, claimed)) return root;
  if (!tighten(root.enclosure) || !is_within(root.enclosure, claimed)) return std::nullopt;
  return root;
}

/// Whether |I - C S| w < w for a vector w > 0 that starts as the widths of the box: powers of |I - C S|
/// applied to it come nearer to the best one.
bool RootProver::is_contracting(const Box& box) const {
  constexpr int kAttempts = 8;
  std::vector<Real> weights;
  for (const Interval& side : box) weights.emplace_back(std::max(width(side), 0x1p-1000));
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    std::vector<Real> sums(box.size());
    bool shrinks = true;
    for (std::size_t i = 0; i < box.size(); ++i) {
      for (std::size_t j = 0; j < box.size(); ++j) {
        if (residual_[i][j].is_zero()) continue;
        mpfr_fma(sums[i].get(), magnitude(residual_[i][j]).get(), weights[j].get(), sums[i].get(), MPFR_RNDU);
      }
      shrinks = shrinks && mpfr_less_p(sums[i].get(), weights[i].get()) != 0;
    }
    if (shrinks) return true;
    for (std::size_t i = 0; i < box.size(); ++i) {
      mpfr_mul_d(weights[i].get(), weights[i].get(), 0x1p-10, MPFR_RNDN);
      mpfr_add(weights[i].get(), weights[i].get(), sums[i].get(), MPFR_RNDN);
      if (mpfr_number_p(weights[i].get()) == 0) return false;
    }
  }
  return false;
}

/// C is the inverse at the root, as solvers take it, or else that of the middle of the slopes.
bool RootProver::has_no_other(const Box& box, const EnclosedRoot& root) {
  if (!std::ranges::all_of(box, is_bounded) || !is_within(root.enclosure, box)) return false;
  if (!system_->slopes(ranges_of(box), root.enclosure, slopes_)) return false;
  return is_regular_from_root(box, root) || is_proved_in_parts(box, root);
}

/// Whether every matrix of slopes from the root to points of the part is proved regular.
bool RootProver::is_regular_from_root(const Box& part, const EnclosedRoot& root) {
  if (!system_->slopes(ranges_of(part), root.enclosure, slopes_)) return false;
  compute_residual(root.inverse);
  if (is_contracting(part)) return true;
  RealMatrix inverse;
  if (!invert(middles(slopes_), inverse)) return false;
  compute_residual(inverse);
  return is_contracting(part);
}

bool RootProver::vanishes_nowhere(const RangeBox& part) {
  return std::ranges::any_of(system_->equations(), [&](JudgedFunction& equation) {
    const Range& value = equation.program.evaluate(part);
    return value.is_empty() || !value.contains_zero();
  });
}

/// Cuts the box, each time across its longest side in parts of the whole, until every part is proved.
bool RootProver::is_proved_in_parts(const Box& box, const EnclosedRoot& root) {
  constexpr int kMaximumParts = 500;
  std::vector<Box> open = {box};
  for (int parts = 0; !open.empty(); ++parts) {
    if (parts == kMaximumParts) return false;
    Box part = std::move(open.back());
    open.pop_back();
    if (vanishes_nowhere(ranges_of(part)) || is_regular_from_root(part, root)) continue;
    std::size_t longest = 0;
    double most = 0;
    for (std::size_t i = 0; i < box.size(); ++i) {
      const double length = width(box[i]) > 0 ? width(part[i]) / width(box[i]) : 0;
      if (length > most) longest = i;
      most = std::max(most, length);
    }
    const double middle = midpoint(part[longest]);
    if (!(part[longest].lower < middle && middle < part[longest].upper)) return false;
    Box other = part;
    part[longest].upper = middle;
    other[longest].lower = middle;
    open.push_back(std::move(other));
    open.push_back(std::move(part));
  }
  return true;
}

}  // namespace gcslab::verifier
