#include "certification/krawczyk_certifier.h"

#include <algorithm>
#include <cmath>

#include "interval/arithmetic.h"

namespace gcslab {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class T>
T number(double value) {
  return NumberTraits<T>::from_interval(Interval(value));
}

template <class T>
SystemEvaluator<T> made(const SystemFunctions& functions, int bits) {
  const typename NumberTraits<T>::Scope scope(bits);
  return SystemEvaluator<T>(functions);
}

Box hull_of(const Box& a, const Box& b) {
  Box result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(hull(a[i], b[i]));
  return result;
}

bool is_interior(const Box& a, const Box& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!(a[i].lower > b[i].lower && a[i].upper < b[i].upper)) return false;
  }
  return true;
}

bool is_bounded_box(const Box& box) { return std::ranges::all_of(box, is_bounded); }

}  // namespace

template <class T>
KrawczykCertifier<T>::KrawczykCertifier(const SystemFunctions& functions, std::vector<double> scales,
                                        int bits)
    : functions_(&functions), scales_(std::move(scales)), bits_(bits), evaluator_(made<T>(functions, bits)) {
  const typename NumberTraits<T>::Scope scope(bits);
  const std::size_t n = functions.variables();
  slopes_ = Matrix<T>(n, n, number<T>(0));
  residual_ = slopes_;
}

template <class T>
std::vector<T> KrawczykCertifier<T>::numbers(const Box& box) const {
  std::vector<T> result;
  result.reserve(box.size());
  for (const Interval& side : box) result.push_back(NumberTraits<T>::from_interval(side));
  return result;
}

template <class T>
Interval KrawczykCertifier<T>::inflated(std::size_t variable, const Interval& side, double part) const {
  const double size = std::max(magnitude(side), 1e-3 * scales_[variable]);
  const double grow = part * width(side) + 1e-15 * size;
  return {side.lower - grow, side.upper + grow};
}

template <class T>
void KrawczykCertifier<T>::compute_residual(const Matrix<double>& inverse) {
  const std::size_t n = functions_->variables();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) residual_(i, j) = number<T>(i == j ? 1 : 0);
    for (std::size_t k = 0; k < n; ++k) {
      if (inverse(i, k) == 0) continue;
      const T factor = number<T>(inverse(i, k));
      // The slopes by variables that do not occur are 0.
      for (const std::size_t j : functions_->equations()[k].variables)
        residual_(i, j) = residual_(i, j) - factor * slopes_(k, j);
    }
  }
}

template <class T>
std::optional<Box> KrawczykCertifier<T>::image(const Box& x, const ApproximateRoot& approximate) {
  const std::size_t n = functions_->variables();
  const std::vector<T> box = numbers(x);
  std::vector<T> centre;
  for (const double c : approximate.point) centre.push_back(number<T>(c));
  // The image of a point is Newton's step, whatever the slopes.
  const bool is_point = std::ranges::all_of(x, [](const Interval& side) { return side.lower == side.upper; });
  if (!is_point) {
    if (!evaluator_.slopes(box, centre, slopes_)) return std::nullopt;
    compute_residual(approximate.inverse);
  }
  std::vector<T> values(n, number<T>(0));
  evaluator_.values(centre, values);
  Box result;
  for (std::size_t i = 0; i < n; ++i) {
    T sum = centre[i];
    for (std::size_t k = 0; k < n; ++k) sum = sum - number<T>(approximate.inverse(i, k)) * values[k];
    for (std::size_t j = 0; j < n && !is_point; ++j) sum = sum + residual_(i, j) * (box[j] - centre[j]);
    const Interval side = NumberTraits<T>::enclosure(sum);
    if (!is_bounded(side)) return std::nullopt;
    result.push_back(side);
  }
  return result;
}

template <class T>
double KrawczykCertifier<T>::contraction_norm(const Box& candidate, const Box& root,
                                              const Matrix<double>& inverse) {
  const typename NumberTraits<T>::Scope scope(bits_);
  if (!is_bounded_box(candidate) || !evaluator_.slopes(numbers(candidate), numbers(root), slopes_))
    return kInfinity;
  compute_residual(inverse);
  const auto weight = [&](std::size_t j) {
    return number<T>(std::max(width(candidate[j]), std::numeric_limits<double>::min()));
  };
  double norm = 0;
  for (std::size_t i = 0; i < candidate.size(); ++i) {
    T sum = number<T>(0);
    for (std::size_t j = 0; j < candidate.size(); ++j) sum = sum + abs(residual_(i, j)) * weight(j);
    norm = std::max(norm, NumberTraits<T>::enclosure(sum / weight(i)).upper);
  }
  return norm;
}

/// The root in k, the image of x that lies in its interior.
template <class T>
std::optional<CertifiedRoot> KrawczykCertifier<T>::settled(const Box& x, const Box& k,
                                                           const ApproximateRoot& approximate) {
  if (!(contraction_norm(x, k, approximate.inverse) < 1)) return std::nullopt;
  return CertifiedRoot{k, x, {{"krawczyk", Claim::unique, x, bits_}}};
}

template <class T>
std::optional<CertifiedRoot> KrawczykCertifier<T>::certify(const ApproximateRoot& approximate) {
  const typename NumberTraits<T>::Scope scope(bits_);
  constexpr int kAttempts = 6;
  const std::size_t n = functions_->variables();
  // The first box is a point: its image is the point with the error of one Newton step. Each attempt takes
  // the hull with that image, inflated (epsilon-inflation, Rump 1983).
  Box x;
  for (const double c : approximate.point) x.emplace_back(c);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const std::optional<Box> k = image(x, approximate);
    if (!k) return std::nullopt;
    if (is_interior(*k, x)) return settled(x, *k, approximate);
    const Box around = hull_of(x, *k);
    for (std::size_t i = 0; i < n; ++i) {
      x[i] = inflated(i, around[i], 0.5);
    }
  }
  return std::nullopt;
}

template <class T>
std::optional<CertifiedRoot> KrawczykCertifier<T>::certify_box(const Box& box, ApproximateRoot& approximate) {
  const typename NumberTraits<T>::Scope scope(bits_);
  constexpr int kAttempts = 3;
  Box x = box;
  approximate.point.clear();
  for (const Interval& side : box) approximate.point.push_back(midpoint(side));
  std::vector<T> centre;
  for (const double c : approximate.point) centre.push_back(number<T>(c));
  if (!evaluator_.jacobian(centre, slopes_)) return std::nullopt;
  Matrix<double> middle(slopes_.rows(), slopes_.columns());
  for (std::size_t i = 0; i < slopes_.rows(); ++i) {
    for (std::size_t j = 0; j < slopes_.columns(); ++j)
      middle(i, j) = midpoint(NumberTraits<T>::enclosure(slopes_(i, j)));
  }
  std::optional<Matrix<double>> inverse = approximate_inverse(middle);
  if (!inverse) return std::nullopt;
  approximate.inverse = std::move(*inverse);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = inflated(i, x[i], 0.3);
    const std::optional<Box> k = image(x, approximate);
    if (!k) return std::nullopt;
    if (is_interior(*k, x)) return settled(x, *k, approximate);
    x = hull_of(x, *k);
  }
  return std::nullopt;
}

/// The norm grows about in proportion to the box, so that one evaluation tells how large the box may be. Two
/// shapes are tried: the sizes of the variables, and what the box wanted has beside that.
template <class T>
void KrawczykCertifier<T>::enlarge_uniqueness(CertifiedRoot& root, const ApproximateRoot& approximate,
                                              const Box& wanted) {
  constexpr int kAttempts = 8;
  constexpr double kAimed = 0.95;
  const Box first = root.uniqueness_box;
  Box& best = root.uniqueness_box;
  const auto cube = [&](double size) {
    Box box;
    for (std::size_t i = 0; i < scales_.size(); ++i)
      box.emplace_back(root.box[i].lower - size * scales_[i], root.box[i].upper + size * scales_[i]);
    return hull_of(box, first);
  };
  double size = 1;
  double largest = 0;
  for (int i = 0; i < kAttempts; ++i) {
    const Box candidate = cube(size);
    const double norm = contraction_norm(candidate, root.box, approximate.inverse);
    if (norm < 1 && size > largest) {
      largest = size;
      best = candidate;
    }
    if (norm < 1 && norm > 0.8) break;
    size *= std::isfinite(norm) ? std::clamp(kAimed / norm, 1e-6, 16.0) : 0.1;
  }
  const Box both = hull_of(best, wanted);
  if (both != best && contraction_norm(both, root.box, approximate.inverse) < 1) {
    best = both;
  } else if (both != best) {
    const Box target = hull_of(first, wanted);
    if (contraction_norm(target, root.box, approximate.inverse) < 1) best = target;
  }
  if (best != first) root.evidence.push_back({"slope_regularity", Claim::at_most_one, best, bits_});
}

template class KrawczykCertifier<FastInterval>;
template class KrawczykCertifier<BoostInterval>;
template class KrawczykCertifier<MpfrInterval>;

}  // namespace gcslab
