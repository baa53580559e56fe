#pragma once

// The report of an experiment: tables and figures of its rows, compared with the committed ones.

#include <filesystem>
#include <set>
#include <string>

#include "experiments/reporting/report_context.h"
#include "experiments/reporting/report_record.h"
#include "experiments/runner/report_item.h"

namespace gcslab {

struct ExperimentConfig;

/// All formats of tables and figures. Data and script of a figure (.dat, .gp) go with svg or pdf.
const std::set<std::string>& report_formats();

struct ReportOptions {
  std::filesystem::path out = "build/reports";
  std::filesystem::path runs = "build/runs";
  std::filesystem::path reference;  ///< the committed reports
  std::set<std::string> formats = report_formats();
};

/// The folder `reports` of the source tree that this program was built from, or ./reports when it is gone.
std::filesystem::path committed_reports();

/// Throws InputError when a table or figure of a config cannot be made: unknown kind, unknown option, no such
/// value.
void check_report_item(const ReportItem& item);

/// The rows of an experiment with what is needed to show them. Throws InputError that names `gcslab run` when
/// there is no result at all. `values`: what the task says of its values.
ReportContext load_report_context(const ExperimentConfig& config, const std::vector<ValueInfo>& values,
                                  const std::filesystem::path& runs, CurveSource curve);

/// Writes tables, figures, rows.json and report.json to out/<experiment>, and says how the rows compare.
ReportRecord write_report(const std::vector<ReportItem>& items, const ReportContext& context,
                          const ReportOptions& options);

/// Makes out/index.html of all reports that are there. Names those that cannot be read.
std::vector<std::string> write_index(const std::filesystem::path& out);

/// Copies the report to reference/<experiment>, in place of what stands there, and makes reference/README.md
/// anew. Throws InputError when some job was not run.
void accept_report(const ReportRecord& record, const ReportContext& context, const ReportOptions& options);

}  // namespace gcslab
