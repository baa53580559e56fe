#include "experiments/solving/plan_report.h"

#include <algorithm>

#include "construction/plan_escapes.h"

namespace gcslab {

std::vector<std::string> lines_of(const std::string& text, char end) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t next = std::min(text.find(end, at), text.size());
    if (next > at) lines.push_back(text.substr(at, next - at));
    at = next + 1;
  }
  return lines;
}

PlanReport report_of(const Plan& plan, const ConstraintSystem& system) {
  return {lines_of(text_of(plan, system), '\n'), plan.guides.size(), plan.choices(), plan.removed.size(),
          plan_diagram(plan, system)};
}

PlanReport report_with_escapes(const Plan& plan, const ConstraintSystem& system) {
  PlanReport report = report_of(plan, system);
  report.escapes.emplace();
  for (const PlanEscape& escape : escapes_of(plan, system)) {
    PlanReport::Escape& told = report.escapes->emplace_back();
    told.object = system.objects[escape.point].name;
    for (const std::size_t guide : escape.guides) told.guides.push_back("k" + std::to_string(guide));
    told.configuration = escape.configuration;
  }
  return report;
}

}  // namespace gcslab
