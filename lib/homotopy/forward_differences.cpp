#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "homotopy/curve.h"

namespace gcslab {
namespace {

class ForwardDifferences final : public Curve {
 public:
  explicit ForwardDifferences(Curve& curve) : curve_(&curve), shifted_values_(curve.size()) {}

  std::size_t size() const override { return curve_->size(); }

  const SparsityPattern* pattern() const override { return curve_->pattern(); }

  bool values(std::span<const double> v, std::span<double> result) override {
    return curve_->values(v, result);
  }

  bool jacobian(std::span<const double> v, std::span<double> result, Matrix<double>& derivatives) override {
    static const double kPart = std::sqrt(std::numeric_limits<double>::epsilon());
    if (!curve_->values(v, result)) return false;
    shifted_.assign(v.begin(), v.end());
    for (std::size_t j = 0; j < v.size(); ++j) {
      shifted_[j] = v[j] + kPart * std::max(1.0, std::abs(v[j]));
      const double step = shifted_[j] - v[j];
      if (!curve_->values(shifted_, shifted_values_)) return false;
      for (std::size_t k = 0; k < size(); ++k) derivatives(k, j) = (shifted_values_[k] - result[k]) / step;
      shifted_[j] = v[j];
    }
    return true;
  }

 private:
  Curve* curve_;
  std::vector<double> shifted_, shifted_values_;
};

}  // namespace

std::unique_ptr<Curve> with_forward_differences(Curve& curve) {
  return std::make_unique<ForwardDifferences>(curve);
}

}  // namespace gcslab
