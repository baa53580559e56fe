#include "univariate/first_root.h"

#include "polynomial/bernstein.h"
#include "univariate/sign_variations.h"

namespace gcslab {
namespace {

using Coefficients = BernsteinTensor<FastInterval>;

constexpr double kWidth = 0x1p-20;       ///< of the parameter's interval
constexpr double kLeastWidth = 0x1p-40;  ///< narrower parts are left to exact arithmetic

/// A part [t, t + width] of the segment; both are dyadic, so that doubles hold them exactly.
struct Part {
  double t;
  double width;
  Coefficients coefficients;
};

bool has_sign(const FastInterval& x) { return x.lower() > 0 || x.upper() < 0; }

/// Narrows a part with exactly one root in its interior as long as signs are certain: they differ at the ends
/// of the half that contains it.
Interval narrowed(Part part) {
  Coefficients left, right;
  while (part.width > kWidth) {
    part.coefficients.halve(0, left, right);
    const FastInterval& start = left.coefficients().front();
    const FastInterval& middle = left.coefficients().back();
    if (!has_sign(start) || !has_sign(middle)) break;
    const bool is_left = (start.lower() > 0) != (middle.lower() > 0);
    part.width /= 2;
    if (!is_left) part.t += part.width;
    part.coefficients = is_left ? left : right;
  }
  return {part.t, part.t + part.width};
}

std::vector<Rational> exactly(std::span<const double> point) {
  std::vector<Rational> result;
  for (const double x : point) result.push_back(rational_from_double(x));
  return result;
}

/// sum b_i binomial(d, i) t^i (1 - t)^(d - i) by powers of t.
Polynomial power_form(const std::vector<Rational>& bernstein) {
  const int degree = static_cast<int>(bernstein.size()) - 1;
  Polynomial result(1);
  const Polynomial t = Polynomial::variable(1, 0);
  const Polynomial s = Polynomial::constant(1, 1) - t;
  for (int i = 0; i <= degree; ++i) {
    mpz_class binomial;
    mpz_bin_uiui(binomial.get_mpz_t(), static_cast<unsigned long>(degree), static_cast<unsigned long>(i));
    result += Rational(binomial) * bernstein[static_cast<std::size_t>(i)] * pow(t, i) * pow(s, degree - i);
  }
  return result;
}

FirstRoot first_of(RealRoots found) {
  if (found.roots().empty()) return {false, {}, true};
  found.refine(0, Rational(1, 1UL << 30));
  const NumberTraits<FastInterval>::Scope scope;
  const RealRoot& root = found.roots().front();
  return {true,
          hull(NumberTraits<FastInterval>::from_rational(root.lower).interval(),
               NumberTraits<FastInterval>::from_rational(root.upper).interval()),
          true};
}

SegmentRestriction<FastInterval> in_doubles(const Polynomial& polynomial) {
  const NumberTraits<FastInterval>::Scope scope;
  return SegmentRestriction<FastInterval>(polynomial);
}

}  // namespace

FirstRootFinder::FirstRootFinder(const Polynomial& polynomial)
    : restriction_(in_doubles(polynomial)), exact_restriction_(polynomial) {}

FirstRoot FirstRootFinder::find(std::span<const double> from, std::span<const double> to) const {
  const std::optional<FirstRoot> fast = find_fast(from, to);
  return fast ? *fast : find_exactly(from, to);
}

std::optional<FirstRoot> FirstRootFinder::find_fast(std::span<const double> from,
                                                    std::span<const double> to) const {
  const NumberTraits<FastInterval>::Scope scope;
  std::vector<FastInterval> start, end;
  for (const double x : from) start.emplace_back(x);
  for (const double x : to) end.emplace_back(x);
  std::vector<FastInterval> all = restriction_.bernstein_coefficients(start, end);
  std::vector<Part> open;  // the last one is nearest to the start
  open.push_back({0, 1, Coefficients(Tensor<FastInterval>({restriction_.degree()}, std::move(all)))});
  while (!open.empty()) {
    Part part = std::move(open.back());
    open.pop_back();
    const std::vector<FastInterval>& b = part.coefficients.coefficients();
    const SignVariations variations = sign_variations(b);
    const bool ends_have_signs = has_sign(b.front()) && has_sign(b.back());
    if (ends_have_signs && variations.most == 0) continue;
    if (ends_have_signs && variations.least == 1 && variations.most == 1)
      return FirstRoot{true, narrowed(std::move(part)), false};
    if (part.width <= kLeastWidth) return std::nullopt;
    Part right{part.t + part.width / 2, part.width / 2, {}};
    Part left{part.t, part.width / 2, {}};
    part.coefficients.halve(0, left.coefficients, right.coefficients);
    open.push_back(std::move(right));
    open.push_back(std::move(left));
  }
  return FirstRoot{};
}

FirstRoot FirstRootFinder::find_exactly(std::span<const double> from, std::span<const double> to) const {
  const Polynomial along = power_form(exact_restriction_.bernstein_coefficients(exactly(from), exactly(to)));
  if (along.is_zero()) return {true, {0, 0}, true};
  return first_of(RealRoots(primitive_polynomial(along), {Rational(0), Rational(1)}));
}

}  // namespace gcslab
