#include "experiments/reporting/report_record.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/error.h"
#include "experiments/reporting/report_context.h"

namespace gcslab {
namespace {

constexpr const char* kStates[] = {"no_reference", "equal", "different"};

Json item_json(const RecordedItem& item) {
  return {{"form", item.is_figure ? "figure" : "table"},
          {"file", item.file},
          {"caption", item.caption},
          {"formats", item.formats},
          {"notes", item.notes},
          {"html", item.html}};
}

RecordedItem item_from(const Json& json) {
  RecordedItem item;
  item.is_figure = json.at("form").get<std::string>() == "figure";
  json.at("file").get_to(item.file);
  json.at("caption").get_to(item.caption);
  json.at("formats").get_to(item.formats);
  json.at("notes").get_to(item.notes);
  json.at("html").get_to(item.html);
  return item;
}

Json outcome_json(const RecordedOutcome& outcome) {
  return {{"job", outcome.job}, {"outcome", outcome.outcome}, {"reason", outcome.reason}};
}

Verdict verdict_from(const Json& json) {
  Verdict verdict;
  const auto state = json.at("state").get<std::string>();
  const auto found = std::ranges::find(kStates, state);
  if (found == std::end(kStates)) throw InputError("has the unknown verdict '" + state + "'");
  verdict.state = static_cast<Verdict::State>(found - std::begin(kStates));
  json.at("lines").get_to(verdict.lines);
  return verdict;
}

ReportRecord read_record(const Json& json) {
  ReportRecord record;
  json.at("experiment").get_to(record.experiment);
  json.at("title").get_to(record.title);
  json.at("source").get_to(record.source);
  json.at("jobs").get_to(record.jobs);
  for (const Json& item : json.at("items")) record.items.push_back(item_from(item));
  for (const Json& outcome : json.at("outcomes")) {
    record.outcomes.push_back({outcome.at("job").get<std::string>(), outcome.at("outcome").get<std::string>(),
                               outcome.at("reason").get<std::string>()});
  }
  record.provenance = json.at("provenance");
  if (json.contains("verdict")) record.verdict = verdict_from(json.at("verdict"));
  return record;
}

std::string text_at(const Json& json, const char* key) {
  if (!json.contains(key)) return "";
  const Json& value = json.at(key);
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string library_text(const Json& libraries) {
  std::string text;
  for (const auto& [name, version] : libraries.items()) {
    text += (text.empty() ? "" : ", ") + name + " " +
            (version.is_string() ? version.get<std::string>() : version.dump());
  }
  return text;
}

}  // namespace

ReportRecord record_of(const ReportContext& context) {
  ReportRecord record;
  record.experiment = context.experiment;
  record.title = context.title;
  record.source = context.source;
  record.jobs = context.rows.rows().size();
  record.provenance = first_provenance(context.rows);
  for (const Row& row : context.rows.rows()) {
    if (row.status != "complete") record.outcomes.push_back({place_text(row), outcome_word(row), row.reason});
  }
  return record;
}

std::string to_text(const ReportRecord& record) {
  Json json = {{"experiment", record.experiment},
               {"title", record.title},
               {"source", record.source},
               {"jobs", record.jobs},
               {"items", Json::array()},
               {"outcomes", Json::array()},
               {"provenance", record.provenance},
               {"verdict",
                {{"state", kStates[static_cast<std::size_t>(record.verdict.state)]},
                 {"lines", record.verdict.lines}}}};
  for (const RecordedItem& item : record.items) json["items"].push_back(item_json(item));
  for (const RecordedOutcome& outcome : record.outcomes) json["outcomes"].push_back(outcome_json(outcome));
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

ReportRecord record_from_text(const std::string& text) {
  try {
    return read_record(Json::parse(text));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(std::string("is no record of a report: ") + error.what());
  }
}

std::vector<ReportRecord> load_records(const std::filesystem::path& reports,
                                       std::vector<std::string>& unreadable) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::is_directory(reports)) return {};
  for (const auto& folder : std::filesystem::directory_iterator(reports)) {
    if (std::filesystem::exists(folder.path() / "report.json"))
      files.push_back(folder.path() / "report.json");
  }
  std::ranges::sort(files);
  std::vector<ReportRecord> records;
  for (const std::filesystem::path& file : files) {
    try {
      records.push_back(record_from_text(read_file(file)));
    } catch (const InputError& error) {
      unreadable.push_back(file.string() + " " + error.what());
    }
  }
  return records;
}

std::string count_text(const ReportRecord& record) {
  std::map<std::string, std::size_t> counts;
  for (const RecordedOutcome& outcome : record.outcomes) ++counts[outcome.outcome];
  std::string text = fmt::format("{} job{}: {} complete", record.jobs, record.jobs == 1 ? "" : "s",
                                 record.jobs - record.outcomes.size());
  for (const auto& [outcome, count] : counts) text += fmt::format(", {} {}", count, outcome);
  return text;
}

std::vector<std::pair<std::string, std::string>> provenance_lines(const Json& provenance) {
  std::vector<std::pair<std::string, std::string>> lines;
  if (!provenance.is_object()) return lines;
  const bool dirty = provenance.contains("dirty") && provenance.at("dirty") == true;
  const auto add = [&lines](const char* name, const std::string& text) {
    if (!text.empty()) lines.emplace_back(name, text);
  };
  add("Machine", text_at(provenance, "cpu"));
  add("Commit", text_at(provenance, "commit") + (dirty ? " with local changes" : ""));
  add("Compiler", text_at(provenance, "compiler"));
  add("Flags", text_at(provenance, "flags"));
  if (provenance.contains("libraries")) add("Libraries", library_text(provenance.at("libraries")));
  return lines;
}

}  // namespace gcslab
