#include "homotopy/parameter_path.h"

#include "base/check.h"

namespace gcslab {
namespace {

class LinearPath : public ParameterPath {
 public:
  LinearPath(std::vector<double> sketch, std::vector<double> wanted)
      : sketch_(std::move(sketch)), wanted_(std::move(wanted)) {
    GCSLAB_CHECK(sketch_.size() == wanted_.size());
  }

  void at(double t, std::span<double> values, std::span<double> derivatives) const override {
    for (std::size_t p = 0; p < sketch_.size(); ++p) {
      derivatives[p] = wanted_[p] - sketch_[p];
      values[p] = t == 1 ? wanted_[p] : sketch_[p] + t * derivatives[p];
    }
  }

  void over(const FastInterval& t, std::span<FastInterval> values,
            std::span<FastInterval> derivatives) const override {
    for (std::size_t p = 0; p < sketch_.size(); ++p) {
      derivatives[p] = FastInterval(wanted_[p]) - FastInterval(sketch_[p]);
      values[p] = FastInterval(sketch_[p]) + t * derivatives[p];
    }
  }

 protected:
  std::vector<double> sketch_, wanted_;
};

class CompactSupportPath final : public LinearPath {
 public:
  CompactSupportPath(std::vector<double> sketch, std::vector<double> wanted, std::size_t parameter)
      : LinearPath(std::move(sketch), std::move(wanted)), parameter_(parameter) {
    GCSLAB_CHECK(parameter_ < sketch_.size());
  }

  void at(double t, std::span<double> values, std::span<double> derivatives) const override {
    LinearPath::at(t, values, derivatives);
    values[parameter_] += t * (1 - t);
    derivatives[parameter_] += 1 - 2 * t;
  }

  void over(const FastInterval& t, std::span<FastInterval> values,
            std::span<FastInterval> derivatives) const override {
    LinearPath::over(t, values, derivatives);
    values[parameter_] = values[parameter_] + t * (FastInterval(1) - t);
    derivatives[parameter_] = derivatives[parameter_] + FastInterval(1) - FastInterval(2) * t;
  }

 private:
  std::size_t parameter_;
};

}  // namespace

std::unique_ptr<ParameterPath> linear_path(std::vector<double> sketch, std::vector<double> wanted) {
  return std::make_unique<LinearPath>(std::move(sketch), std::move(wanted));
}

std::unique_ptr<ParameterPath> compact_support_path(std::vector<double> sketch, std::vector<double> wanted,
                                                    std::size_t parameter) {
  return std::make_unique<CompactSupportPath>(std::move(sketch), std::move(wanted), parameter);
}

}  // namespace gcslab
