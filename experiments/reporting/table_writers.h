#pragma once

// A table in the formats that readers and programs want.

#include <string>

#include "experiments/reporting/table.h"

namespace gcslab {

/// GitHub Markdown: caption, one pipe table a block, footnotes and notes.
std::string markdown_text(const Table& table);

/// A stand-alone fragment of LaTeX for \input, with booktabs and textcomp: a tabular and its notes, no float
/// around it.
std::string latex_text(const Table& table);

/// A <table> with its notes, for the index page.
std::string html_text(const Table& table);

/// One line a cell and value with the raw numbers: axes, value, unit, median, min, max, samples, text,
/// status, reason. Numbers have as many digits as it takes to read them back.
std::string csv_text(const Table& table);

}  // namespace gcslab
