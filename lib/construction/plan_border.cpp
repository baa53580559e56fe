#include "construction/plan_border.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "interval/jet.h"

namespace gcslab {
namespace {

constexpr std::size_t kSlopes = 8;
using GuideJet = Jet<kSlopes>;

double size_of(const PlanValues& values) {
  double size = 0;
  for (const double x : values.parameters) size = std::max(size, std::abs(x));
  for (const double x : values.guides) size = std::max(size, std::abs(x));
  return size;
}

/// The radicands of the choices with their derivatives by guides `first`, `first` + 1, ...; nothing outside
/// of the domain.
std::optional<std::vector<GuideJet>> radicands(PlanRun<GuideJet>& run, const PlanProgram& program,
                                               const PlanValues& values, const Branch& branch,
                                               std::size_t first) {
  const auto copy = [&](const std::vector<double>& from, std::size_t at) {
    for (std::size_t i = 0; i < from.size(); ++i) run.variables()[at + i] = GuideJet{from[i], {}};
  };
  copy(values.parameters, program.parameter(0));
  copy(values.guides, program.guide(0));
  copy(values.offsets, program.offset(0));
  for (std::size_t g = first; g < values.guides.size() && g < first + kSlopes; ++g)
    run.variables()[program.guide(g)].slopes[g - first] = 1;
  std::vector<GuideJet> result(program.plan().choices());
  for (std::size_t k = 0; k < program.steps().size(); ++k) {
    const StepFormulas& step = program.steps()[k];
    if (step.form == StepForm::origin) continue;
    run.prepare(k);
    GuideJet height;
    if (step.form != StepForm::one_place) {
      const GuideJet& radicand = run.radicand(k);
      if (!(radicand.value >= 0) || !std::isfinite(radicand.value)) return std::nullopt;
      if (step.choice) {
        result[*step.choice] = radicand;
        height = sqrt(radicand);
        if (branch[*step.choice]) height = -height;
      }
    }
    run.place(k, height);
  }
  return result;
}

}  // namespace

std::optional<PlanBorder> border_of(const PlanProgram& program, const PlanValues& values,
                                    const Branch& branch) {
  const std::size_t choices = program.plan().choices();
  if (choices == 0) return std::nullopt;
  PlanRun<GuideJet> run(program);
  std::vector<double> value(choices), square(choices, 0.0);
  std::size_t first = 0;
  do {
    const auto found = radicands(run, program, values, branch, first);
    if (!found) return std::nullopt;
    for (std::size_t c = 0; c < choices; ++c) {
      value[c] = (*found)[c].value;
      for (const double slope : (*found)[c].slopes) square[c] += slope * slope;
    }
    first += kSlopes;
  } while (first < values.guides.size());
  const auto least = std::ranges::min_element(value) - value.begin();
  const double size = size_of(values);
  PlanBorder border{value[static_cast<std::size_t>(least)] / (size * size), static_cast<std::size_t>(least),
                    std::numeric_limits<double>::infinity(), static_cast<std::size_t>(least)};
  for (std::size_t c = 0; c < choices; ++c) {
    if (value[c] > 0 && square[c] == 0) continue;
    // Behind a choice that is on the border derivatives are not finite; it is nearer.
    const double distance = value[c] > 0 ? value[c] / std::sqrt(square[c]) : 0;
    if (distance < border.distance) border.distance = distance, border.nearest_choice = c;
  }
  return border;
}

}  // namespace gcslab
