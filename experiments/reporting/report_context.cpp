#include "experiments/reporting/report_context.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "experiments/runner/report_item.h"

namespace gcslab {
namespace {

constexpr const char* kNotTheSameRun = " (not the same run)";

/// The values of `row` on all axes but problem and method, which the rows of a reference take over.
void refuse_several_values(const RowPointers& rows, const ReportItem& item) {
  for (const auto& [axis, text] : rows.front()->axes) {
    const auto differs = [&axis = axis, &text = text](const Row* row) { return row->at(axis) != text; };
    if (axis == "problem" || axis == "method" || std::ranges::none_of(rows, differs)) continue;
    throw InputError(item.references.front().where,
                     "references have no " + axis + ", and '" + item.file +
                         "' shows several values of it; choose one by a filter");
  }
}

Row reference_row(const ReferenceRun& run, const Row& beside) {
  Row row;
  row.is_reference = true;
  row.axes = beside.axes;
  row.axes["problem"] = run.problem;
  row.axes["method"] = run.method + kNotTheSameRun;
  row.constants = beside.constants;
  row.status = name_of(run.status);
  row.reason = run.reason;
  for (const auto& [name, seconds] : run.timings) row.timings[name] = seconds;
  for (const auto& [name, count] : run.counts) row.values[name] = count;
  return row;
}

}  // namespace

SelectedRows::SelectedRows(const ReportContext& context, const ReportItem& item)
    : rows_(select_rows(context.rows, item)) {
  if (item.references.empty()) return;
  refuse_several_values(rows_, item);
  for (const PlacedText& name : item.references) add(context.references.at(name.text));
}

/// Method by method, so that each keeps its column.
void SelectedRows::add(const ReferenceTable& table) {
  const RowPointers own = rows_;
  for (const std::string& method : table.methods) {
    for (const ReferenceRun& run : table.runs) {
      const auto beside =
          std::ranges::find_if(own, [&](const Row* row) { return row->at("problem") == run.problem; });
      if (run.method != method || beside == own.end()) continue;
      rows_.push_back(&references_.emplace_back(reference_row(run, **beside)));
    }
  }
}

std::vector<std::string> notes_on_references(const ReportContext& context, const ReportItem& item) {
  std::vector<std::string> notes;
  for (const PlacedText& name : item.references) {
    const ReferenceTable& table = context.references.at(name.text);
    std::string note = "Not the same run: " + table.title + "; " + table.origin + ".";
    if (!table.notes.empty()) note += " " + table.notes;
    if (std::ranges::find(notes, note) == notes.end()) notes.push_back(std::move(note));
  }
  return notes;
}

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
