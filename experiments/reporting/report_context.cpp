#include "experiments/reporting/report_context.h"

#include <nlohmann/json.hpp>

namespace gcslab {

std::vector<Polyline> first_curve(const ProblemCurves& curves) {
  return curves.equations.empty() ? std::vector<Polyline>{} : curves.equations.front();
}

Json first_provenance(const RowTable& rows) {
  for (const Row& row : rows.rows()) {
    if (row.was_run() && row.provenance.is_object()) return row.provenance;
  }
  return nullptr;
}

std::string machine_text(const RowTable& rows) {
  const Json provenance = first_provenance(rows);
  if (!provenance.is_object()) return "";
  std::string text;
  for (const char* key : {"cpu", "compiler"}) {
    if (!provenance.contains(key) || !provenance.at(key).is_string()) continue;
    text += (text.empty() ? "" : "; ") + provenance.at(key).get<std::string>();
  }
  return text;
}

}  // namespace gcslab
