#include "experiments/commands/report_command.h"

#include <CLI/CLI.hpp>
#include <csignal>
#include <fmt/format.h>
#include <memory>
#include <set>

#include "base/error.h"
#include "experiments/commands/exit_code.h"
#include "experiments/reporting/cover_picture.h"
#include "experiments/reporting/report.h"
#include "experiments/runner/experiment_config.h"
#include "experiments/tasks/catalogue.h"

namespace gcslab {
namespace {

struct ReportArguments {
  std::vector<std::string> configs;
  std::string out = ReportOptions().out.string();
  std::string runs = ReportOptions().runs.string();
  std::string reference = committed_reports().string();
  std::vector<std::string> formats;
  bool accept = false;
};

ReportOptions options_from(const ReportArguments& arguments) {
  ReportOptions options;
  options.out = arguments.out;
  options.runs = arguments.runs;
  options.reference = arguments.reference;
  if (!arguments.formats.empty()) options.formats = {arguments.formats.begin(), arguments.formats.end()};
  return options;
}

void print_verdict(const ReportRecord& record) {
  constexpr std::size_t kMost = 20;
  const std::vector<std::string>& lines = record.verdict.lines;
  if (record.verdict.state == Verdict::State::no_reference) {
    fmt::print("  no reference yet; --accept makes this report the reference\n");
  }
  for (std::size_t i = 0; i < std::min(lines.size(), kMost); ++i) fmt::print("  {}\n", lines[i]);
  if (lines.size() > kMost) fmt::print("  ... and {} more lines in report.json\n", lines.size() - kMost);
}

void print_missing(const ReportContext& context, const ExperimentConfig& config) {
  const auto& rows = context.rows.rows();
  const auto missing = std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.was_run(); });
  if (missing == 0) return;
  fmt::print("  {} of {} jobs have no result; tables and figures name them. To run them: gcslab run {}\n",
             missing, rows.size(), config.file.string());
}

/// True when counts and outcomes are those of the reference.
bool report_one(const ExperimentConfig& config, const Catalogue& catalogue, const ReportOptions& options,
                const CurveSource& curves, bool accept) {
  const std::vector<ValueInfo> values = catalogue.tasks.at(config.task).task->values();
  const ReportContext context = load_report_context(config, values, options.runs, curves);
  const ReportRecord record = write_report(config.report, context, options);
  const std::size_t count = record.items.size();
  fmt::print("{}: {}; {} in {}\n", config.experiment, count_text(record),
             count == 1 ? "1 table or figure" : fmt::format("{} tables and figures", count),
             (options.out / config.experiment).string());
  print_missing(context, config);
  print_verdict(record);
  if (!accept) return record.verdict.state != Verdict::State::different;
  accept_report(record, context, options);
  fmt::print("  accepted as reference: {}\n", (options.reference / config.experiment).string());
  return true;
}

int report(const ReportArguments& arguments, const Catalogue& catalogue) {
  // A file that reaches the limit of its size is a failed write with a message, here and in gnuplot.
  std::signal(SIGXFSZ, SIG_IGN);
  const ReportOptions options = options_from(arguments);
  const CurveSource curves = corpus_curves();
  bool all_agree = true;
  for (const ExperimentConfig& config : load_experiments(arguments.configs, catalogue)) {
    all_agree = report_one(config, catalogue, options, curves, arguments.accept) && all_agree;
  }
  for (const std::string& problem : write_index(options.out))
    fmt::print(stderr, "gcslab: left out: {}\n", problem);
  fmt::print("index: {}\n", (options.out / "index.html").string());
  if (!all_agree)
    fmt::print("Counts or outcomes differ from the reference in {}.\n", options.reference.string());
  return all_agree ? kDone : kCheckFailed;
}

}  // namespace

void add_report_command(CLI::App& app, const Catalogue& catalogue, int& exit_code) {
  auto arguments = std::make_shared<ReportArguments>();
  CLI::App* command =
      app.add_subcommand("report", "Make tables and figures, and compare them with the reference");
  command->add_option("configs", arguments->configs, "Config files")->required()->type_name("CONFIG");
  command->add_option("--out", arguments->out, "Folder for reports, one folder an experiment in it")
      ->capture_default_str()
      ->type_name("DIR");
  command->add_option("--runs", arguments->runs, "Folder of the results of gcslab run")
      ->capture_default_str()
      ->type_name("DIR");
  command->add_option("--reference", arguments->reference, "Folder of the committed reports")
      ->capture_default_str()
      ->type_name("DIR");
  auto* formats = command->add_option("--format", arguments->formats, "Only these of md, tex, csv, svg, pdf")
                      ->delimiter(',')
                      ->check(CLI::IsMember(report_formats()))
                      ->type_name("LIST");
  command->add_flag("--accept", arguments->accept, "Make the reports the reference")->excludes(formats);
  command->footer(
      "Counts and outcomes are compared exactly (exit code 1 when they differ), times as ratios.");
  command->callback([arguments, &catalogue, &exit_code] { exit_code = report(*arguments, catalogue); });
}

}  // namespace gcslab
