#include "experiments/reporting/index_page.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "experiments/reporting/escape.h"

namespace gcslab {
namespace {

constexpr std::string_view kStyle = R"(
:root { --text: #1c1c1c; --quiet: #666; --line: #ccc; --good: #00694c; --bad: #a83e00; }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 1.25rem 4rem; max-width: 62rem; color: var(--text); background: #fff;
  font: 16px/1.55 Charter, "Bitstream Charter", "Source Serif Pro", Georgia, serif; }
h1, h2, h3, nav, table, .verdict, .outcomes, .facts, .links { font-family: "Helvetica Neue", Helvetica, Arial,
  "DejaVu Sans", sans-serif; }
h1 { font-size: 1.7rem; margin: 0 0 .3rem; }
h2 { font-size: 1.3rem; margin: 3.2rem 0 .2rem; padding-top: .9rem; border-top: 1px solid var(--line); }
h3 { font-size: 1rem; margin: 1.8rem 0 .5rem; }
a { color: #005a8c; }
.source, .notes, .facts { color: var(--quiet); font-size: .875rem; margin: .2rem 0 .8rem; }
nav ol { columns: 2; column-gap: 2.5rem; padding-left: 1.4rem; font-size: .9rem; }
nav li { break-inside: avoid; }
figure { margin: 1.6rem 0; }
figure img { display: block; max-width: 100%; height: auto; }
figcaption { font-size: .9rem; margin-top: .5rem; }
.links { font-size: .8rem; white-space: nowrap; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .84rem; font-variant-numeric: tabular-nums; }
thead { border-top: 1.5px solid var(--text); border-bottom: .75px solid var(--text); }
tbody:last-of-type { border-bottom: 1.5px solid var(--text); }
th, td { padding: .16rem .55rem; text-align: right; font-weight: normal; white-space: nowrap; vertical-align: baseline; }
thead th { font-weight: 600; vertical-align: bottom; }
th.head { text-align: left; }
th.span { text-align: center; }
th.block { text-align: left; font-style: italic; padding-top: .55rem; }
small { color: var(--quiet); }
.verdict { font-size: .9rem; margin: .6rem 0; padding: .45rem .8rem; border-left: 4px solid var(--quiet); background: #f6f6f6; }
.verdict.equal { border-color: var(--good); }
.verdict.different { border-color: var(--bad); }
.verdict ul, .outcomes ul { margin: .3rem 0; padding-left: 1.2rem; }
.outcomes { font-size: .875rem; }
details summary { cursor: pointer; }
dl.facts { display: grid; grid-template-columns: max-content 1fr; gap: 0 .8rem; }
dl.facts dd { margin: 0; overflow-wrap: anywhere; }
@media print { body { max-width: none; font-size: 10pt; } nav { display: none; } h2 { break-before: page; }
  figure, table { break-inside: avoid; } details { display: none; } .wide { overflow: visible; } }
)";

constexpr std::array<std::string_view, 3> kStateWords = {"no reference yet", "agrees with the reference",
                                                         "differs from the reference"};
constexpr std::array<std::string_view, 3> kStateClasses = {"none", "equal", "different"};

std::string state_word(const ReportRecord& record) {
  return std::string(kStateWords[static_cast<std::size_t>(record.verdict.state)]);
}

// ---- HTML ----

/// Long lists are cut: report.json has them whole.
std::string list_html(const std::vector<std::string>& lines) {
  constexpr std::size_t kMost = 200;
  std::string text = "<ul>\n";
  for (std::size_t i = 0; i < std::min(lines.size(), kMost); ++i)
    text += "<li>" + escape_html(lines[i]) + "</li>\n";
  if (lines.size() > kMost)
    text += fmt::format("<li>and {} more, in report.json</li>\n", lines.size() - kMost);
  return text + "</ul>\n";
}

std::string links_html(const ReportRecord& record, const RecordedItem& item) {
  std::string text;
  for (const std::string& format : item.formats) {
    text += fmt::format("{}<a href=\"{}/{}.{}\">{}</a>", text.empty() ? "" : " · ",
                        escape_html(record.experiment), escape_html(item.file), format, format);
  }
  return "<span class=\"links\">" + text + "</span>";
}

bool has_format(const RecordedItem& item, const char* format) {
  return std::ranges::find(item.formats, format) != item.formats.end();
}

std::string figure_html(const ReportRecord& record, const RecordedItem& item) {
  std::string text = "<figure>\n";
  if (has_format(item, "svg")) {
    text += fmt::format("<img src=\"{}/{}.svg\" alt=\"{}\">\n", escape_html(record.experiment),
                        escape_html(item.file), escape_html(item.caption));
  }
  text += "<figcaption><b>" + escape_html(item.caption) + "</b>";
  for (const std::string& note : item.notes) text += " " + escape_html(note);
  return text + " " + links_html(record, item) + "</figcaption>\n</figure>\n";
}

std::string table_html(const ReportRecord& record, const RecordedItem& item) {
  return "<h3>" + escape_html(item.caption) + " " + links_html(record, item) + "</h3>\n" + item.html;
}

std::string verdict_html(const ReportRecord& record) {
  const auto state = static_cast<std::size_t>(record.verdict.state);
  std::string text =
      fmt::format("<div class=\"verdict {}\"><b>Counts: {}.</b>\n", kStateClasses[state], kStateWords[state]);
  if (!record.verdict.lines.empty()) text += list_html(record.verdict.lines);
  return text + "</div>\n";
}

std::string outcomes_html(const ReportRecord& record) {
  std::string text = "<div class=\"outcomes\"><p>" + escape_html(count_text(record)) + "</p>\n";
  if (record.outcomes.empty()) return text + "</div>\n";
  std::vector<std::string> lines;
  for (const RecordedOutcome& o : record.outcomes) {
    lines.push_back(o.job + ": " + o.outcome + (o.reason.empty() ? "" : ", " + o.reason));
  }
  text += fmt::format("<details{}><summary>Outcomes that are not complete</summary>\n",
                      lines.size() <= 12 ? " open" : "");
  return text + list_html(lines) + "</details></div>\n";
}

std::string facts_html(const ReportRecord& record) {
  std::string text = "<dl class=\"facts\">\n";
  for (const auto& [name, value] : provenance_lines(record.provenance)) {
    text += "<dt>" + name + "</dt><dd>" + escape_html(value) + "</dd>\n";
  }
  return text + "</dl>\n";
}

std::string section_html(const ReportRecord& record) {
  std::string text = fmt::format("<section>\n<h2 id=\"{}\">{}</h2>\n", escape_html(record.experiment),
                                 escape_html(record.title));
  text += "<p class=\"source\"><code>" + escape_html(record.experiment) + "</code>";
  if (!record.source.empty()) text += " · " + escape_html(record.source);
  text += fmt::format(" · <a href=\"{}/rows.json\">all rows</a></p>\n", escape_html(record.experiment));
  for (const RecordedItem& item : record.items) {
    text += item.is_figure ? figure_html(record, item) : table_html(record, item);
  }
  return text + verdict_html(record) + outcomes_html(record) + facts_html(record) + "</section>\n";
}

std::string contents_html(const std::vector<ReportRecord>& records) {
  std::string text = "<nav><ol>\n";
  for (const ReportRecord& record : records) {
    text += fmt::format("<li><a href=\"#{}\">{}</a> <small>{}</small></li>\n", escape_html(record.experiment),
                        escape_html(record.title), state_word(record));
  }
  return text + "</ol></nav>\n";
}

std::string summary_text(const std::vector<ReportRecord>& records) {
  std::array<std::size_t, 3> counts{};
  for (const ReportRecord& record : records) ++counts[static_cast<std::size_t>(record.verdict.state)];
  std::string text = fmt::format("{} experiment{}.", records.size(), records.size() == 1 ? "" : "s");
  for (const std::size_t state : {1U, 2U, 0U}) {
    if (counts[state] > 0) text += fmt::format(" {}: {}.", counts[state], kStateWords[state]);
  }
  return text + " Counts are compared exactly, times as ratios.";
}

// ---- Markdown ----

/// Text for an image's alternative or a link, where brackets would end it.
std::string link_text(const std::string& text) { return escape_markdown(text); }

std::string item_markdown(const ReportRecord& record, const RecordedItem& item) {
  const std::string path = record.experiment + "/" + item.file;
  std::string links;
  for (const std::string& format : item.formats) {
    links += fmt::format("{}[{}]({}.{})", links.empty() ? "" : " · ", format, path, format);
  }
  if (!item.is_figure) return fmt::format("- Table: {} ({})\n", escape_markdown(item.caption), links);
  std::string text =
      fmt::format("\n![{}]({}.svg)\n\n{}", link_text(item.caption), path, escape_markdown(item.caption));
  if (!item.caption.ends_with('.')) text += ".";
  for (const std::string& note : item.notes) text += " " + escape_markdown(note);
  return text + " (" + links + ")\n\n";
}

std::string section_markdown(const ReportRecord& record) {
  std::string text = "\n## " + escape_markdown(record.title) + "\n\n";
  text += "`" + record.experiment + "`";
  if (!record.source.empty()) text += " · " + escape_markdown(record.source);
  text += fmt::format(" · {} · [all rows]({}/rows.json)\n\n", escape_markdown(count_text(record)),
                      record.experiment);
  for (const RecordedItem& item : record.items) text += item_markdown(record, item);
  return text;
}

}  // namespace

std::string index_html(const std::vector<ReportRecord>& records) {
  std::string text = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  text +=
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>gcslab "
      "reports</title>\n";
  text +=
      "<style>" + std::string(kStyle) + "</style>\n</head>\n<body>\n<h1>Reports</h1>\n<p class=\"source\">";
  text += summary_text(records) + "</p>\n" + contents_html(records);
  for (const ReportRecord& record : records) text += section_html(record);
  return text + "</body>\n</html>\n";
}

std::string index_markdown(const std::vector<ReportRecord>& records) {
  std::string text =
      "# Reports\n\nReference tables and figures. `gcslab report` compares new results with them: counts "
      "exactly, "
      "times as ratios.\n`gcslab report --accept` writes this folder; do not edit it by hand.\n\n";
  for (const ReportRecord& record : records) {
    text += fmt::format("- {} ({})\n", escape_markdown(record.title), record.experiment);
  }
  for (const ReportRecord& record : records) text += section_markdown(record);
  return text;
}

}  // namespace gcslab
