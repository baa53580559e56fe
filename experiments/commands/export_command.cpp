#include "experiments/commands/export_command.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>

#include "base/atomic_file.h"
#include "experiments/commands/exit_code.h"
#include "experiments/corpus/problem_loader.h"
#include "expression/system_formats.h"

namespace gcslab {
namespace {

struct Settings {
  std::string problem;
  std::string format;
  std::string valuation;
  std::string out;
};

std::vector<std::string> written_formats() {
  std::vector<std::string> names;
  for (const SystemFormat& format : system_formats().entries()) {
    if (format.write != nullptr) names.push_back(format.name);
  }
  return names;
}

int run(const Settings& settings) {
  const SystemFormat& format = system_formats().at(settings.format);
  if (format.write == nullptr) {
    throw InputError(fmt::format("--to {}: this format is only read; expected one of {}", settings.format,
                                 fmt::join(written_formats(), ", ")));
  }
  const Problem problem = load_system(settings.problem, settings.valuation);
  const std::string text = format.write(problem.system);
  if (settings.out.empty() || settings.out == "-") {
    fmt::print("{}", text);
  } else {
    check_writable(settings.out);
    write_file_atomically(settings.out, text);
  }
  return kDone;
}

}  // namespace

void add_export_command(CLI::App& app, int& exit_code) {
  auto settings = std::make_shared<Settings>();
  CLI::App* command = app.add_subcommand("export", "Write a system in the format of another program");
  command
      ->add_option("problem", settings->problem,
                   "a problem file, or a name that `gcslab list problems` prints")
      ->required();
  command->add_option("--to", settings->format, fmt::format("one of {}", fmt::join(written_formats(), ", ")))
      ->required();
  command->add_option("--valuation", settings->valuation,
                      "of a constraint system: which values its parameters have; by default the first");
  command->add_option("--out", settings->out, "write here instead of standard output");
  command->callback([settings, &exit_code] { exit_code = run(*settings); });
}

}  // namespace gcslab
