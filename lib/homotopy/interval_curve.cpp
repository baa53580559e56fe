#include "homotopy/interval_curve.h"

namespace gcslab {

IntervalHomotopy::IntervalHomotopy(const GeometricEquations& equations, const Homotopy& homotopy)
    : homotopy_(&homotopy), x_(equations.unknowns.size() + equations.parameters.size()), speed_(x_) {
  const NumberTraits<FastInterval>::Scope scope;
  for (const Expression& equation : equations.equations) {
    auto tape = std::make_unique<Tape>(equation, static_cast<int>(x_.size()));
    auto evaluator = std::make_unique<TapeEvaluator<FastInterval>>(*tape);
    equations_.push_back({std::move(tape), std::move(evaluator)});
  }
  for (std::size_t i = 0; i < size(); ++i) speed_[i] = FastInterval(homotopy.unit(i));
}

void IntervalHomotopy::move_to(std::span<const FastInterval> v) {
  for (std::size_t i = 0; i < size(); ++i) x_[i] = speed_[i] * v[i];
  homotopy_->path().over(v[size()], std::span(x_).subspan(size()), std::span(speed_).subspan(size()));
}

bool IntervalHomotopy::values(std::span<const FastInterval> v, std::span<FastInterval> result) {
  move_to(v);
  for (std::size_t k = 0; k < size(); ++k) {
    TapeEvaluator<FastInterval>& evaluator = *equations_[k].evaluator;
    evaluator.evaluate(x_);
    if (!evaluator.defined_everywhere()) return false;
    result[k] = FastInterval(homotopy_->weights()[k]) * evaluator.value();
  }
  const FastInterval t = v[size()];
  for (const auto& [k, start, leading] : homotopy_->offsets())
    result[k] = result[k] - (FastInterval(1) - t) * (FastInterval(start) + FastInterval(leading) * t);
  return true;
}

bool IntervalHomotopy::jacobian(std::span<const FastInterval> v, Matrix<FastInterval>& result) {
  move_to(v);
  const std::size_t m = size();
  for (std::size_t k = 0; k < m; ++k) {
    TapeEvaluator<FastInterval>& evaluator = *equations_[k].evaluator;
    evaluator.evaluate(x_);
    if (!evaluator.defined_everywhere()) return false;
    const FastInterval weight(homotopy_->weights()[k]);
    const std::span<const FastInterval> gradient = evaluator.reverse_gradient();
    for (std::size_t i = 0; i < m; ++i) result(k, i) = weight * gradient[i] * speed_[i];
    FastInterval by_t(0);
    for (std::size_t p = m; p < x_.size(); ++p) by_t = by_t + gradient[p] * speed_[p];
    result(k, m) = weight * by_t;
  }
  const FastInterval t = v[m];
  for (const auto& [k, start, leading] : homotopy_->offsets()) {
    const FastInterval slope =
        FastInterval(leading) * (FastInterval(1) - FastInterval(2) * t) - FastInterval(start);
    result(k, m) = result(k, m) - slope;
  }
  return true;
}

}  // namespace gcslab
