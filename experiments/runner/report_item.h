#pragma once

// What a config asks of the report: tables and figures over the rows of an experiment.

#include <map>
#include <string>
#include <vector>

#include "base/error.h"

namespace gcslab {

class YamlNode;
struct Catalogue;
struct ExperimentConfig;

/// A text that knows where a user wrote it.
struct PlacedText {
  std::string text;
  SourceLocation where;
};

/// One table or figure. An axis is "problem", "method" (its label), "seed" or a parameter of the task.
struct ReportItem {
  enum class Form { table, figure };

  Form form = Form::table;
  SourceLocation where;
  std::string file;  ///< name of the files it makes, without folder and extension; unique in the experiment
  std::string caption;               ///< empty: the experiment's title
  std::string kind;                  ///< of figures "cover_panels", ...; of tables "cells" when empty, ...
  std::vector<std::string> rows;     ///< axes; a table of cells always has some
  std::vector<std::string> columns;  ///< axes; none: one column
  /// Values of the task, measures (report_measures), axes with numbers, or quotients "a/b" of two of these.
  std::vector<std::string> values;
  std::string best;  ///< of tables: "min", "max", or empty: no value is marked
  /// axis -> the texts of its values that are shown; an axis without an entry is shown whole.
  std::map<std::string, std::vector<std::string>> filter;
  /// Tables of figures of other programs, shown as further methods.
  std::vector<PlacedText> references{};
  std::map<std::string, PlacedText> options;  ///< all other keys; the form and kind decide what they mean
};

/// What every row can show besides the task's own values: wall_s, cpu_s, prepare_s, peak_rss_mb, status.
const std::vector<std::string>& report_measures();

/// Reads the config's key `report`; all else of `config` is complete. Throws InputError.
std::vector<ReportItem> read_report(const YamlNode& report, const ExperimentConfig& config,
                                    const Catalogue& catalogue);

}  // namespace gcslab
