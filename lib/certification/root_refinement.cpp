#include "certification/root_refinement.h"

#include <algorithm>
#include <memory>

#include "certification/newton_iteration.h"
#include "interval/point_numbers.h"
#include "interval/reverse_operations.h"

namespace gcslab {
namespace {

using Traits = NumberTraits<MpfrInterval>;

MpfrInterval point(mpfr_srcptr value) { return {MpfrNumber(value), MpfrNumber(value)}; }

MpfrInterval middle(const MpfrInterval& x) {
  MpfrNumber sum;
  mpfr_add(sum.get(), x.lower(), x.upper(), MPFR_RNDN);
  mpfr_div_2ui(sum.get(), sum.get(), 1, MPFR_RNDN);
  return point(sum.get());
}

/// -log2 of the width relative to the magnitude, or to 1 when that is larger; large for a point.
long accurate_bits(const MpfrInterval& x) {
  MpfrNumber size;
  mpfr_sub(size.get(), x.upper(), x.lower(), MPFR_RNDU);
  if (mpfr_zero_p(size.get()) != 0) return 1'000'000'000;
  const long width_exponent = mpfr_get_exp(size.get());
  const long magnitude_exponent = mpfr_zero_p(x.upper()) != 0 ? 0 : mpfr_get_exp(x.upper());
  return std::max(magnitude_exponent, 1L) - width_exponent;
}

class Refinement {
 public:
  Refinement(const SystemFunctions& functions, const CertifiedRoot& root)
      : n_(functions.variables()), evaluator_(functions), slopes_(n_, n_, Traits::from_interval(0)) {
    for (const Interval& side : root.box) box_.push_back(Traits::from_interval(side));
    inverse_ = inverse_at(functions, root);
  }

  /// Steps until no side gains any more.
  void run(long wanted) {
    if (!inverse_) return;
    long accuracy = worst();
    while (accuracy < wanted && step()) {
      const long now = worst();
      if (now <= accuracy) break;
      accuracy = now;
    }
  }

  long worst() const {
    long least = 1'000'000'000;
    for (const MpfrInterval& side : box_) least = std::min(least, accurate_bits(side));
    return least;
  }

  std::vector<MpfrInterval>& box() { return box_; }

 private:
  static std::optional<Matrix<double>> inverse_at(const SystemFunctions& functions,
                                                  const CertifiedRoot& root) {
    const NearestRounding nearest;
    SystemEvaluator<double> evaluator(functions);
    std::vector<double> centre;
    for (const Interval& side : root.box) centre.push_back(midpoint(side));
    Matrix<double> jacobian(centre.size(), centre.size());
    if (!evaluator.jacobian(centre, jacobian)) return std::nullopt;
    return approximate_inverse(jacobian);
  }

  /// X := X intersected with c - C f(c) + (I - C S(X, c)) (X - c).
  bool step() {
    std::vector<MpfrInterval> centre;
    for (const MpfrInterval& side : box_) centre.push_back(middle(side));
    if (!evaluator_.slopes(box_, centre, slopes_)) return false;
    std::vector<MpfrInterval> values(n_);
    evaluator_.values(centre, values);
    std::vector<MpfrInterval> result;
    for (std::size_t i = 0; i < n_; ++i) {
      MpfrInterval sum = centre[i];
      for (std::size_t k = 0; k < n_; ++k) sum = sum - factor(i, k) * values[k];
      for (std::size_t j = 0; j < n_; ++j) sum = sum + residual(i, j) * (box_[j] - centre[j]);
      result.push_back(intersection(sum, box_[i]));
      if (result.back().is_empty()) return false;
    }
    box_ = std::move(result);
    return true;
  }

  MpfrInterval factor(std::size_t i, std::size_t k) const {
    return Traits::from_interval(Interval((*inverse_)(i, k)));
  }

  MpfrInterval residual(std::size_t i, std::size_t j) const {
    MpfrInterval sum = Traits::from_interval(Interval(i == j ? 1 : 0));
    for (std::size_t k = 0; k < n_; ++k) sum = sum - factor(i, k) * slopes_(k, j);
    return sum;
  }

  std::size_t n_;
  SystemEvaluator<MpfrInterval> evaluator_;
  Matrix<MpfrInterval> slopes_;
  std::vector<MpfrInterval> box_;
  std::optional<Matrix<double>> inverse_;
};

}  // namespace

RefinedRoot refine_root(const SystemFunctions& functions, const CertifiedRoot& root, int bits) {
  const int working_bits = bits + 64;
  const Traits::Scope scope(working_bits);
  Refinement refinement(functions, root);
  refinement.run(bits);
  return {std::move(refinement.box()), working_bits, refinement.worst() >= bits};
}

std::string decimal_text(const MpfrInterval& x, int digits) {
  MpfrNumber sum(mpfr_get_prec(x.lower()) + 1);
  mpfr_add(sum.get(), x.lower(), x.upper(), MPFR_RNDN);
  mpfr_div_2ui(sum.get(), sum.get(), 1, MPFR_RNDN);
  char* text = nullptr;
  if (mpfr_asprintf(&text, "%.*Rg", digits, sum.get()) < 0) throw std::bad_alloc();
  const std::unique_ptr<char, void (*)(char*)> owner(text, &mpfr_free_str);
  return text;
}

}  // namespace gcslab
