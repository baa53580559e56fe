#include <fmt/format.h>

#include "experiments/reporting/escape.h"
#include "experiments/reporting/table_writers.h"

namespace gcslab {
namespace {

std::string cell_text(const TableCell& cell) {
  std::string text = escape_html(cell.text);
  if (cell.best) text = "<b>" + text + "</b>";
  if (!cell.spread.empty()) text += " <small>(" + escape_html(cell.spread) + ")</small>";
  if (!cell.marks.empty()) text += "<sup>" + cell.marks + "</sup>";
  return "<td>" + text + "</td>";
}

std::string head_line(const Table& table, std::size_t level) {
  const bool is_last = level + 1 == table.column_heads.front().size();
  std::string text = "<tr>";
  for (const std::string& name : table.head_names) {
    text += "<th class=\"head\">" + (is_last ? escape_html(name) : "") + "</th>";
  }
  for (const HeadingSpan& span : heading_spans(table, level)) {
    text += span.columns > 1 ? fmt::format("<th class=\"span\" colspan=\"{}\">", span.columns) : "<th>";
    text += escape_html(span.text) + "</th>";
  }
  return text + "</tr>\n";
}

std::string line_text(const TableLine& line) {
  std::string text = "<tr>";
  for (const std::string& head : line.heads) text += "<th class=\"head\">" + escape_html(head) + "</th>";
  for (const TableCell& cell : line.cells) text += cell_text(cell);
  return text + "</tr>\n";
}

std::string block_text(const Table& table, const TableBlock& block) {
  std::string text = "<tbody>\n";
  if (!block.heading.empty()) {
    text += fmt::format("<tr><th class=\"block\" colspan=\"{}\">{}</th></tr>\n",
                        table.head_names.size() + table.column_heads.size(), escape_html(block.heading));
  }
  for (const TableLine& line : block.lines) text += line_text(line);
  return text + "</tbody>\n";
}

std::string notes_text(const Table& table) {
  std::string text = "<p class=\"notes\">";
  for (const Footnote& note : table.footnotes)
    text += "<sup>" + note.mark + "</sup> " + escape_html(note.text) + ".\n";
  for (const std::string& note : table.notes) text += escape_html(note) + "\n";
  return text + "</p>\n";
}

}  // namespace

std::string html_text(const Table& table) {
  std::string text = "<div class=\"wide\"><table>\n<thead>\n";
  for (std::size_t level = 0; level < table.column_heads.front().size(); ++level)
    text += head_line(table, level);
  text += "</thead>\n";
  for (const TableBlock& block : table.blocks) text += block_text(table, block);
  return text + "</table></div>\n" + notes_text(table);
}

}  // namespace gcslab
