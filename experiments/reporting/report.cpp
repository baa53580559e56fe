#include "experiments/reporting/report.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/error.h"
#include "experiments/reporting/figure.h"
#include "experiments/reporting/gnuplot.h"
#include "experiments/reporting/index_page.h"
#include "experiments/reporting/reference.h"
#include "experiments/reporting/table.h"
#include "experiments/reporting/table_writers.h"
#include "experiments/runner/experiment_config.h"
#include "experiments/runner/job_plan.h"
#include "experiments/runner/run_experiment.h"

namespace gcslab {
namespace {

namespace fs = std::filesystem;

/// Everything that a report writes; other files in its folders are left alone.
const std::set<std::string>& written_extensions() {
  static const std::set<std::string> extensions = {".md",  ".tex", ".csv", ".svg",
                                                   ".pdf", ".dat", ".gp",  ".json"};
  return extensions;
}

std::string caption_of(const ReportItem& item, const ReportContext& context) {
  return item.caption.empty() ? context.title : item.caption;
}

RecordedItem write_table(const ReportItem& item, const ReportContext& context, const ReportOptions& options) {
  const Table table = build_table(item, context);
  RecordedItem recorded{false, item.file, table.caption, {}, {}, html_text(table)};
  const auto write = [&](const char* format, const std::string& text) {
    if (!options.formats.contains(format)) return;
    write_file_atomically(options.out / context.experiment / (item.file + "." + format), text);
    recorded.formats.emplace_back(format);
  };
  write("md", markdown_text(table));
  write("tex", latex_text(table));
  write("csv", csv_text(table));
  return recorded;
}

RecordedItem write_figure_of(const ReportItem& item, const ReportContext& context,
                             const ReportOptions& options) {
  const FigureScript figure = draw_figure(item, context);
  const std::string caption = caption_of(item, context);
  RecordedItem recorded{true, item.file, caption, {}, figure.notes, ""};
  std::set<std::string> pictures;
  for (const char* format : {"svg", "pdf"}) {
    if (!options.formats.contains(format)) continue;
    pictures.insert(format);
    recorded.formats.emplace_back(format);
  }
  if (pictures.empty()) return recorded;
  write_figure(figure, caption, options.out / context.experiment, item.file, pictures);
  recorded.formats.insert(recorded.formats.end(), {"dat", "gp"});
  return recorded;
}

Verdict compare_with_reference(const std::string& rows, const ReportContext& context,
                               const ReportOptions& options) {
  const fs::path file = options.reference / context.experiment / "rows.json";
  if (!fs::exists(file)) return {Verdict::State::no_reference, {}};
  try {
    return verdict_of(compare_rows(rows, read_file(file)));
  } catch (const InputError& error) {
    throw InputError(file.string() + ": " + error.what());
  }
}

/// Removes what earlier reports wrote to the folder and this one did not, such as a table that has another
/// name now.
void remove_old_files(const fs::path& folder, const ReportRecord& record) {
  std::set<std::string> current = {"rows.json", "report.json"};
  for (const RecordedItem& item : record.items) {
    for (const std::string& format : item.formats) current.insert(item.file + "." + format);
  }
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const bool is_ours =
        entry.is_regular_file() && written_extensions().contains(entry.path().extension().string());
    if (is_ours && !current.contains(entry.path().filename().string())) old.push_back(entry.path());
  }
  for (const fs::path& path : old) fs::remove(path);
}

void refuse_missing_rows(const ReportContext& context) {
  const auto& rows = context.rows.rows();
  const auto missing = std::ranges::count_if(rows, [](const Row& row) { return !row.was_run(); });
  if (missing == 0) return;
  throw InputError(
      fmt::format("{}: {} of {} jobs have no result, so this report cannot become the reference; run the "
                  "experiment first",
                  context.experiment, missing, rows.size()));
}

}  // namespace

const std::set<std::string>& report_formats() {
  static const std::set<std::string> formats = {"md", "tex", "csv", "svg", "pdf"};
  return formats;
}

fs::path committed_reports() {
  const fs::path source = GCSLAB_SOURCE_DIR;
  return fs::is_directory(source) ? source / "reports" : fs::path("reports");
}

void check_report_item(const ReportItem& item) {
  for (const PlacedText& name : item.references) {
    try {
      static_cast<void>(find_reference_table(name.text));
    } catch (const InputError& error) {
      throw InputError(name.where, error.what());
    }
  }
  item.form == ReportItem::Form::table ? check_table(item) : check_figure(item);
}

namespace {

std::map<std::string, ReferenceTable> references_of(const ExperimentConfig& config) {
  std::map<std::string, ReferenceTable> tables;
  for (const ReportItem& item : config.report) {
    for (const PlacedText& name : item.references)
      tables.try_emplace(name.text, find_reference_table(name.text));
  }
  return tables;
}

}  // namespace

ReportContext load_report_context(const ExperimentConfig& config, const std::vector<ValueInfo>& values,
                                  const fs::path& runs, CurveSource curve) {
  const fs::path jobs = run_folder(runs, config) / "jobs";
  std::vector<std::string> parameters;
  for (const ParameterAxis& parameter : config.parameters) parameters.push_back(parameter.name);
  RowTable rows = load_rows(plan_jobs(config), parameters, jobs);
  if (std::ranges::all_of(rows.rows(), [](const Row& row) { return row.status == kNotRun; })) {
    throw InputError(fmt::format("{}: no job of this experiment has a result in {}; first run: gcslab run {}",
                                 config.experiment, jobs.string(), config.file.string()));
  }
  std::vector<std::string> baselines;
  for (const MethodChoice& method : config.methods) {
    if (method.promise == Promise::baseline) baselines.push_back(method.label);
  }
  return {config.experiment, config.title,     config.source,         config.repetitions, baselines, values,
          std::move(rows),   std::move(curve), references_of(config), config.limits};
}

ReportRecord write_report(const std::vector<ReportItem>& items, const ReportContext& context,
                          const ReportOptions& options) {
  const fs::path folder = options.out / context.experiment;
  make_folder(folder);
  ReportRecord record = record_of(context);
  for (const ReportItem& item : items) {
    const bool is_table = item.form == ReportItem::Form::table;
    record.items.push_back(is_table ? write_table(item, context, options)
                                    : write_figure_of(item, context, options));
  }
  const std::string rows = rows_text(context);
  write_file_atomically(folder / "rows.json", rows);
  record.verdict = compare_with_reference(rows, context, options);
  write_file_atomically(folder / "report.json", to_text(record));
  remove_old_files(folder, record);
  return record;
}

std::vector<std::string> write_index(const fs::path& out) {
  std::vector<std::string> unreadable;
  write_file_atomically(out / "index.html", index_html(load_records(out, unreadable)));
  return unreadable;
}

void accept_report(const ReportRecord& record, const ReportContext& context, const ReportOptions& options) {
  refuse_missing_rows(context);
  const fs::path from = options.out / context.experiment;
  const fs::path to = options.reference / context.experiment;
  make_folder(to);
  for (const RecordedItem& item : record.items) {
    for (const std::string& format : item.formats) {
      const std::string name = item.file + "." + format;
      write_file_atomically(to / name, read_file(from / name));
    }
  }
  write_file_atomically(to / "rows.json", read_file(from / "rows.json"));
  ReportRecord accepted = record;
  accepted.verdict = {};
  write_file_atomically(to / "report.json", to_text(accepted));
  remove_old_files(to, record);
  std::vector<std::string> unreadable;
  write_file_atomically(options.reference / "README.md",
                        index_markdown(load_records(options.reference, unreadable)));
}

}  // namespace gcslab
