#pragma once

// Kinds of figures: a kind turns the rows that an item of the report selects into a gnuplot figure.
//
// What a job did not achieve is named in the figure or in its notes; no row vanishes. A new kind is one
// source file and one line in figure_registry.cpp.

#include <functional>
#include <string>
#include <vector>

#include "base/option.h"
#include "base/registry.h"
#include "experiments/reporting/figure_script.h"
#include "experiments/reporting/report_context.h"
#include "experiments/runner/report_item.h"

namespace gcslab {

struct FigureRequest {
  const ReportItem& item;
  const ReportContext& context;
  RowPointers rows;  ///< those that the item's filter lets through
  Options options;
};

struct FigureKind {
  std::string name;
  std::string summary;
  std::vector<OptionSpec> options;
  std::function<FigureScript(const FigureRequest&)> draw;
};

const Registry<FigureKind>& figure_kinds();

/// Throws InputError, with the place in the config, when the item's kind or options are not known.
void check_figure(const ReportItem& item);

/// Throws InputError when the item cannot be drawn from these rows.
FigureScript draw_figure(const ReportItem& item, const ReportContext& context);

/// The option that every kind has: a column of a journal or its page.
OptionSpec width_option(const std::string& default_width);
double width_from(const Options& options);

/// A sentence for every outcome without a result, with the jobs that had it: by name where they are few.
std::vector<std::string> notes_on_missing(const RowPointers& rows);

}  // namespace gcslab
