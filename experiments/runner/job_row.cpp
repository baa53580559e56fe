#include "experiments/runner/job_row.h"

#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace gcslab {
namespace {

Json number_json(double number) {
  if (std::isfinite(number)) return number;
  return fmt::format("{}", number);
}

double number_from(const Json& json) {
  return json.is_string() ? std::strtod(json.get<std::string>().c_str(), nullptr) : json.get<double>();
}

Json options_json(const Options& options) {
  Json json = Json::object();
  for (const auto& [name, value] : options.values()) {
    if (const double* real = std::get_if<double>(&value)) {
      json[name] = number_json(*real);
    } else {
      std::visit([&json, &key = name](const auto& plain) { json[key] = plain; }, value);
    }
  }
  return json;
}

std::map<std::string, std::string> texts_of(const Json& options) {
  std::map<std::string, std::string> texts;
  for (const auto& [name, value] : options.items()) {
    texts[name] = value.is_string() ? value.get<std::string>() : value.dump();
  }
  return texts;
}

Json limits_json(const Limits& limits) {
  return {{"wall_s", number_json(limits.wall_s)},
          {"cpu_s", number_json(limits.cpu_s)},
          {"memory_mb", number_json(limits.memory_mb)}};
}

Limits limits_from(const Json& json) {
  return {number_from(json.at("wall_s")), number_from(json.at("cpu_s")), number_from(json.at("memory_mb"))};
}

/// JSON has no infinite numbers; as texts they are not lost.
void replace_infinite_numbers(Json& json) {
  if (json.is_structured()) {
    for (Json& item : json) replace_infinite_numbers(item);
  } else if (json.is_number_float()) {
    json = number_json(json.get<double>());
  }
}

void append(Json& map, const Json& more) {
  for (const auto& [key, value] : more.items()) map[key] = value;
}

/// Runs `read` and turns the JSON library's errors into input errors.
template <class Read>
auto reading(const char* what, Read read) {
  try {
    return read();
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("is not {}: {}", what, error.what()));
  }
}

Job read_question(const Json& json, const TaskRegistry& tasks) {
  Job job;
  json.at("experiment").get_to(job.experiment);
  json.at("task").get_to(job.task);
  json.at("problem").get_to(job.problem);
  json.at("problem_hash").get_to(job.problem_hash);
  json.at("method").get_to(job.method);
  json.at("label").get_to(job.label);
  json.at("seed").get_to(job.seed);
  json.at("repetitions").get_to(job.repetitions);
  job.limits = limits_from(json.at("limits"));
  const Task& task = *tasks.at(job.task).task;
  const MethodInfo method = task.method(job.method);
  job.method_version = method.version;
  job.options = Options(method.options, texts_of(json.at("options")), method.name);
  job.parameters = Options(task.parameters(), texts_of(json.at("parameters")), job.task);
  return job;
}

JobRow read_row(const Json& json) {
  JobRow row;
  json.at("job").get_to(row.job);
  json.at("experiment").get_to(row.experiment);
  json.at("task").get_to(row.task);
  json.at("problem").get_to(row.problem);
  json.at("problem_hash").get_to(row.problem_hash);
  json.at("method").get_to(row.method);
  json.at("label").get_to(row.label);
  row.options = json.at("options");
  json.at("method_version").get_to(row.method_version);
  row.parameters = json.at("parameters");
  json.at("seed").get_to(row.seed);
  json.at("repetitions").get_to(row.repetitions);
  row.limits = limits_from(json.at("limits"));
  row.result = result_from_json(json);
  json.at("peak_rss_mb").get_to(row.peak_rss_mb);
  row.provenance = json.at("provenance");
  return row;
}

Json question_json(const JobRow& row) {
  return {{"job", row.job},
          {"experiment", row.experiment},
          {"task", row.task},
          {"problem", row.problem},
          {"problem_hash", row.problem_hash},
          {"method", row.method},
          {"label", row.label},
          {"options", row.options},
          {"method_version", row.method_version},
          {"parameters", row.parameters},
          {"seed", row.seed},
          {"repetitions", row.repetitions},
          {"limits", limits_json(row.limits)}};
}

}  // namespace

Json question_json(const Job& job) { return question_json(make_row(job, {}, 0, nullptr)); }

Job job_from_text(const std::string& text, const TaskRegistry& tasks) {
  return reading("a job", [&] {
    const Json json = Json::parse(text);
    Job job = read_question(json, tasks);
    if (json.at("job").get<std::string>() == job.id()) return job;
    throw InputError("is a job of another version of " + job.method + "; run the experiment again");
  });
}

JobRow make_row(const Job& job, JobResult result, double peak_rss_mb, Json provenance) {
  return {job.id(),           job.experiment,
          job.task,           job.problem,
          job.problem_hash,   job.method,
          job.label,          options_json(job.options),
          job.method_version, options_json(job.parameters),
          job.seed,           job.repetitions,
          job.limits,         std::move(result),
          peak_rss_mb,        std::move(provenance)};
}

std::string to_text(const JobRow& row) {
  Json json = question_json(row);
  append(json, result_json(row.result));
  json["peak_rss_mb"] = number_json(row.peak_rss_mb);
  json["provenance"] = row.provenance;
  return map_text(json);
}

JobRow row_from_text(const std::string& text) {
  return reading("a row", [&] { return read_row(Json::parse(text)); });
}

Json result_json(const JobResult& result) {
  Json json = {{"status", name_of(result.status)},
               {"reason", result.reason},
               {"values", result.values},
               {"timings", result.timings}};
  if (!result.artifact.is_null()) json["artifact"] = result.artifact;
  replace_infinite_numbers(json);
  return json;
}

JobResult result_from_json(const Json& json) {
  return reading("a result", [&] {
    JobResult result;
    result.status = status_from_name(json.at("status").get<std::string>());
    json.at("reason").get_to(result.reason);
    result.values = json.at("values");
    result.timings = json.at("timings");
    if (json.contains("artifact")) result.artifact = json.at("artifact");
    return result;
  });
}

std::string map_text(const Json& map) {
  std::string text = "{";
  const char* separator = "\n ";
  for (const auto& [key, value] : map.items()) {
    // What other programs printed may be no UTF-8; it must not cost the row.
    constexpr auto kReplace = Json::error_handler_t::replace;
    text +=
        separator + Json(key).dump(-1, ' ', false, kReplace) + ": " + value.dump(-1, ' ', false, kReplace);
    separator = ",\n ";
  }
  return text + "\n}\n";
}

}  // namespace gcslab
