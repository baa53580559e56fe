#include "experiments/solving/plan_report.h"

#include <algorithm>

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
  return {lines_of(text_of(plan, system), '\n'), plan.guides.size(), plan.choices(), plan.removed.size()};
}

}  // namespace gcslab
