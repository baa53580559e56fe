#pragma once

// A table before it is written in some format: plain UTF-8 texts in their places.
//
// Every job that the filter lets through has its place in some cell. What is not `complete` or `partial`
// shows there by name with a footnote that gives the reason; it never vanishes, and it never counts as best.

#include <string>
#include <vector>

namespace gcslab {

struct ReportContext;
struct ReportItem;

struct TableCell {
  std::string text;
  std::string spread;  ///< "1.02–1.31", printed small in parentheses; may be empty
  bool best = false;
  std::string marks;  ///< letters of the footnotes, "a" or "a,c"
};

struct TableLine {
  std::vector<std::string> heads;  ///< one text a row axis
  std::vector<TableCell> cells;
};

/// Lines under a heading of their own: one block a value, or one block without a heading.
struct TableBlock {
  std::string heading;
  std::vector<TableLine> lines;
};

/// A number behind the table, before any rounding.
struct TableRecord {
  std::vector<std::string> key;  ///< texts on the axes of Table::record_axes
  std::string value, unit, text;
  double median, minimum, maximum;
  std::size_t samples;  ///< 0: no number
  std::string status, reason;
};

struct Footnote {
  std::string mark;
  std::string text;
};

struct Table {
  std::string caption;
  std::vector<std::string> head_names;  ///< one a row axis
  std::vector<std::vector<std::string>>
      column_heads;  ///< of every column: one text a level, at least one level
  std::vector<TableBlock> blocks;
  std::vector<Footnote> footnotes;
  std::vector<std::string> notes;  ///< sentences under the table
  std::vector<std::string> record_axes;
  std::vector<TableRecord> records;
};

/// Runs of equal headings on one level of the column heads, for headings that span columns. Levels above
/// bound the runs.
struct HeadingSpan {
  std::string text;
  std::size_t columns;
};
std::vector<HeadingSpan> heading_spans(const Table& table, std::size_t level);

/// Throws InputError, with the place in the config, when the item cannot be a table.
Table build_table(const ReportItem& item, const ReportContext& context);

/// Checks what can be checked before any job is run.
void check_table(const ReportItem& item);

}  // namespace gcslab
