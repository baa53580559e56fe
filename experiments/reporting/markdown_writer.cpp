#include "experiments/reporting/escape.h"
#include "experiments/reporting/table_writers.h"

namespace gcslab {
namespace {

std::string joined_head(const std::vector<std::string>& levels) {
  std::string text;
  for (const std::string& level : levels) text += (text.empty() ? "" : "<br>") + escape_markdown(level);
  return text;
}

std::string cell_text(const TableCell& cell) {
  std::string text = escape_markdown(cell.text);
  if (cell.best) text = "**" + text + "**";
  if (!cell.spread.empty()) text += " (" + escape_markdown(cell.spread) + ")";
  if (!cell.marks.empty()) text += "<sup>" + cell.marks + "</sup>";
  return text;
}

std::string head_lines(const Table& table) {
  std::string names = "|";
  std::string rule = "|";
  for (const std::string& name : table.head_names) {
    names += " " + escape_markdown(name) + " |";
    rule += ":---|";
  }
  for (const auto& levels : table.column_heads) {
    names += " " + joined_head(levels) + " |";
    rule += "---:|";
  }
  return names + "\n" + rule + "\n";
}

std::string line_text(const TableLine& line) {
  std::string text = "|";
  for (const std::string& head : line.heads) text += " " + escape_markdown(head) + " |";
  for (const TableCell& cell : line.cells) text += " " + cell_text(cell) + " |";
  return text + "\n";
}

}  // namespace

std::string markdown_text(const Table& table) {
  std::string text = "**" + escape_markdown(table.caption) + "**\n";
  for (const TableBlock& block : table.blocks) {
    text += "\n";
    if (!block.heading.empty()) text += "*" + escape_markdown(block.heading) + "*\n\n";
    text += head_lines(table);
    for (const TableLine& line : block.lines) text += line_text(line);
  }
  if (!table.footnotes.empty()) text += "\n";
  for (const Footnote& note : table.footnotes) {
    text += "- <sup>" + note.mark + "</sup> " + escape_markdown(note.text) + "\n";
  }
  if (!table.notes.empty()) text += "\n";
  for (const std::string& note : table.notes) text += escape_markdown(note) + "\n";
  return text;
}

}  // namespace gcslab
