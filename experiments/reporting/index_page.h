#pragma once

// The pages that list all experiments of a folder of reports.

#include <string>
#include <vector>

#include "experiments/reporting/report_record.h"

namespace gcslab {

/// index.html: one page without scripts or anything from elsewhere; figures are <img> of the files beside it.
std::string index_html(const std::vector<ReportRecord>& records);

/// README.md of the committed reports: figures inline, tables as links.
std::string index_markdown(const std::vector<ReportRecord>& records);

}  // namespace gcslab
