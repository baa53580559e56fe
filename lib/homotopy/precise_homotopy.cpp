#include "homotopy/precise_homotopy.h"

#include <cmath>

namespace gcslab {
namespace {

using Traits = NumberTraits<MpfrInterval>;

MpfrInterval number(double x) { return Traits::from_interval(Interval(x)); }

}  // namespace

PreciseHomotopy::PreciseHomotopy(const GeometricEquations& equations, Homotopy& homotopy, int bits)
    : source_(&equations),
      homotopy_(&homotopy),
      bits_(bits),
      parameters_(equations.parameters.size()),
      speeds_(equations.parameters.size()) {}

void PreciseHomotopy::prepare() {
  const std::size_t variables = source_->unknowns.size() + source_->parameters.size();
  for (const Expression& equation : source_->equations) {
    auto tape = std::make_unique<Tape>(equation, static_cast<int>(variables));
    auto evaluator = std::make_unique<TapeEvaluator<MpfrInterval>>(*tape);
    equations_.push_back({std::move(tape), std::move(evaluator)});
  }
}

bool PreciseHomotopy::values(std::span<const double> v, std::span<double> result) {
  const std::size_t m = size();
  homotopy_->path().at(v[m], parameters_, speeds_);
  const Traits::Scope scope(bits_);
  if (equations_.empty()) prepare();
  x_.clear();
  for (std::size_t i = 0; i < m; ++i) x_.push_back(number(homotopy_->unit(i)) * number(v[i]));
  for (const double parameter : parameters_) x_.push_back(number(parameter));
  for (std::size_t k = 0; k < m; ++k) {
    TapeEvaluator<MpfrInterval>& evaluator = *equations_[k].evaluator;
    evaluator.evaluate(x_);
    const Interval value = Traits::enclosure(evaluator.value());
    if (is_empty(value) || !is_bounded(value)) return false;
    result[k] = homotopy_->weights()[k] * midpoint(value);
  }
  const double t = v[m];
  for (const auto& [equation, start, leading] : homotopy_->offsets())
    result[equation] -= (1 - t) * (start + leading * t);
  return true;
}

bool PreciseHomotopy::jacobian(std::span<const double> v, std::span<double> result,
                               Matrix<double>& derivatives) {
  return homotopy_->jacobian(v, result, derivatives) && values(v, result);
}

}  // namespace gcslab
