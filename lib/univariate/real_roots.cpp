#include "univariate/real_roots.h"

#include <algorithm>

#include "base/check.h"
#include "base/error.h"
#include "univariate/root_interval.h"

namespace gcslab {
namespace {

/// The bounded interval with the same roots in it.
RationalInterval bounded(const RealLinePart& where, const IntegerPolynomial& polynomial) {
  const Rational bound = where.lower && where.upper ? Rational(0) : root_bound(polynomial);
  const Rational lower = where.lower ? *where.lower : -bound;
  const Rational upper = where.upper ? *where.upper : bound;
  return {where.lower ? lower : std::min(lower, upper), where.upper ? upper : std::max(lower, upper)};
}

Rational magnitude(const RealRoot& root) {
  return std::max(Rational(abs(root.lower)), Rational(abs(root.upper)));
}

}  // namespace

RealRoots::RealRoots(const IntegerPolynomial& polynomial, const RealLinePart& where,
                     const std::stop_token& stop) {
  if (polynomial.is_zero()) throw NotApplicable("the polynomial is zero: every number is a root");
  if (where.lower && where.upper && *where.upper < *where.lower) throw NotApplicable("the interval is empty");
  factors_ = square_free_decomposition(polynomial);
  for (const SquareFreeFactor& factor : factors_) signs_.emplace_back(factor.polynomial);
  if (!factors_.empty()) isolate(where, stop);
}

/// Roots of all factors together: their product is square-free too.
void RealRoots::isolate(const RealLinePart& where, const std::stop_token& stop) {
  IntegerPolynomial product({1});
  for (const SquareFreeFactor& factor : factors_) product = product * factor.polynomial;
  const SignEvaluator signs(product);
  RootIsolation isolation = isolate_square_free(product, bounded(where, product), stop);
  counts_ = isolation.counts;
  unsearched_ = std::move(isolation.unsearched);
  for (const RationalInterval& interval : isolation.roots) roots_.push_back(with_factor(interval, signs));
  separate();
}

/// The one factor that vanishes in the interval: the one whose signs differ at its ends. An end may be a root
/// of the product; the interval is narrowed until it is none.
RealRoot RealRoots::with_factor(const RationalInterval& interval, const SignEvaluator& product) const {
  RootInterval place(product, interval.lower, interval.upper);
  while (place.lower() < place.upper() &&
         (product.sign(place.lower()) == 0 || product.sign(place.upper()) == 0))
    place.bisect();
  for (std::size_t k = 0; k < factors_.size(); ++k) {
    if (signs_[k].sign(place.lower()) * signs_[k].sign(place.upper()) ==
        (place.lower() == place.upper() ? 0 : -1))
      return {place.lower(), place.upper(), factors_[k].multiplicity, k};
  }
  GCSLAB_CHECK(false);
}

/// Neighbours may share an end: their closed intervals are made disjoint.
void RealRoots::separate() {
  for (std::size_t i = 1; i < roots_.size(); ++i) {
    while (roots_[i - 1].upper >= roots_[i].lower) {
      const std::size_t wider =
          roots_[i - 1].upper - roots_[i - 1].lower > roots_[i].upper - roots_[i].lower ? i - 1 : i;
      refine(wider, (roots_[wider].upper - roots_[wider].lower) / 2);
    }
  }
}

void RealRoots::refine(std::size_t root, const Rational& width) {
  RealRoot& wanted = roots_.at(root);
  if (wanted.upper - wanted.lower <= width) return;
  RootInterval place(signs_[wanted.factor], wanted.lower, wanted.upper);
  place.refine(width);
  wanted.lower = place.lower();
  wanted.upper = place.upper();
}

void RealRoots::refine_relative(std::size_t root, int bits) {
  RealRoot& wanted = roots_.at(root);
  if (sgn(wanted.lower) * sgn(wanted.upper) < 0) {
    RootInterval place(signs_[wanted.factor], wanted.lower, wanted.upper);
    place.cut(0);
    wanted.lower = place.lower();
    wanted.upper = place.upper();
  }
  const auto relative_width = [&] {
    Rational width = magnitude(wanted);
    mpq_div_2exp(width.get_mpq_t(), width.get_mpq_t(), static_cast<mp_bitcnt_t>(bits));
    return width;
  };
  while (!wanted.is_exact() && wanted.upper - wanted.lower > relative_width()) refine(root, relative_width());
}

void RealRoots::try_exact(std::size_t root, const Rational& number) {
  RealRoot& wanted = roots_.at(root);
  if (wanted.lower < number && number < wanted.upper && signs_[wanted.factor].sign(number) == 0)
    wanted.lower = wanted.upper = number;
}

}  // namespace gcslab
