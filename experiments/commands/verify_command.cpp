#include "experiments/commands/verify_command.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fstream>
#include <memory>

#include "base/atomic_file.h"
#include "experiments/commands/exit_code.h"
#include "experiments/corpus/problem_loader.h"
#include "experiments/solving/result_json.h"
#include "verifier/verifier.h"

namespace gcslab {
namespace {

struct Settings {
  std::string result;
  std::string proof;
  std::string problem;
};

Json read_result(const std::string& path) {
  try {
    return Json::parse(read_file(path));
  } catch (const Json::exception& error) {
    throw InputError(path + ": is no JSON (" + error.what() + ")");
  }
}

/// The problem that the result names, or the one given.
std::string problem_name(const Settings& settings, const Json& result) {
  if (!settings.problem.empty()) return settings.problem;
  if (result.is_object() && result.contains("problem") && result["problem"].is_string())
    return result["problem"].get<std::string>();
  throw InputError(settings.result + ": names no problem; expected the key \"problem\", or --problem");
}

/// That of the method's options, where the result says one.
std::string valuation_of(const Json& result) {
  const Json::json_pointer place("/method/options/valuation");
  const bool is_said = result.is_object() && result.contains(place) && result[place].is_string();
  return is_said ? result[place].get<std::string>() : std::string();
}

void print(const VerificationReport& report, const std::string& name) {
  for (const auto& [claim, count] : report.checked) fmt::print("  proved again: {} ({})\n", claim, count);
  for (const std::string& claim : report.not_checked) fmt::print("  not checked: {}\n", claim);
  for (const auto& [where, reason] : report.refusals)
    fmt::print(stderr, "{}: refused: {}: {}\n", name, where, reason);
  fmt::print("{}: {}{}\n", name, report.accepted() ? "accepted" : "refused",
             report.completeness_proved ? ", and nothing is missing" : "");
}

int run(const Settings& settings) {
  const Json result = read_result(settings.result);
  const Problem problem = load_system(problem_name(settings, result), valuation_of(result));
  Box box = problem.system.box;
  if (result.is_object() && result.contains("search_box"))
    box = box_from_json(result["search_box"], settings.result + ": /search_box");
  std::ifstream stream;
  std::optional<ProofText> proof;
  if (!settings.proof.empty()) {
    stream.open(settings.proof, std::ios::binary);
    if (!stream) throw InputError(settings.proof + ": cannot be read");
    proof = ProofText{&stream, settings.proof};
  }
  const VerificationReport report = verify(problem.system, box, result, proof);
  print(report, settings.result);
  return report.accepted() ? kDone : kCheckFailed;
}

}  // namespace

void add_verify_command(CLI::App& app, int& exit_code) {
  auto settings = std::make_shared<Settings>();
  CLI::App* command = app.add_subcommand("verify", "Prove the claims of a result again, by other means");
  command->add_option("result", settings->result, "a result that `gcslab solve --json` wrote")->required();
  command->add_option("--proof", settings->proof,
                      "the file that `gcslab solve --proof` wrote: proves that nothing is missing");
  command->add_option("--problem", settings->problem, "the problem, if not the one that the result names");
  command->callback([settings, &exit_code] { exit_code = run(*settings); });
}

}  // namespace gcslab
