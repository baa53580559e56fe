// gcslab: solvers for geometric constraint systems and polynomial systems, compared with proof.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fmt/format.h>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "base/check.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "experiments/commands/cover_command.h"
#include "experiments/commands/describe_command.h"
#include "experiments/commands/exit_code.h"
#include "experiments/commands/export_command.h"
#include "experiments/commands/job_command.h"
#include "experiments/commands/list_command.h"
#include "experiments/commands/report_command.h"
#include "experiments/commands/run_command.h"
#include "experiments/commands/solve_command.h"
#include "experiments/commands/validate_command.h"
#include "experiments/commands/verify_command.h"
#include "experiments/reporting/report.h"
#include "experiments/tasks/registry.h"
#include "interval/rounding_self_test.h"

namespace gcslab {
namespace {

constexpr const char* kDescription =
    "gcslab solves systems of geometric constraints and polynomial systems with proof, and compares the ways "
    "to do it.";

constexpr const char* kFooter =
    "Exit codes: 0 done; 1 a check failed; 2 bad input; 3 budget exhausted; 4 not applicable; 5 failed "
    "inside.\n"
    "Start with: gcslab list problems, gcslab cover curves/folium --figure folium.svg";

int complain(const std::exception& error, ExitCode code) {
  fmt::print(stderr, "gcslab: {}\n", error.what());
  return code;
}

/// A misspelt command or option, with the nearest known one.
std::optional<std::string> usage_fault(const CLI::App& app, int argc, char** argv) {
  if (argc < 2) return std::nullopt;
  std::vector<std::string> commands;
  const CLI::App* chosen = nullptr;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (!command->get_group().empty()) commands.push_back(command->get_name());
    if (command->get_name() == argv[1]) chosen = command;
  }
  if (chosen == nullptr) {
    if (argv[1][0] == '-') return std::nullopt;
    return unknown_name_message("command", argv[1], commands);
  }
  std::vector<std::string> options;
  for (const CLI::Option* option : chosen->get_options()) {
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  }
  for (int i = 2; i < argc; ++i) {
    const std::string word = std::string(argv[i]).substr(0, std::string(argv[i]).find('='));
    if (word.starts_with("--") && std::ranges::find(options, word) == options.end()) {
      return unknown_name_message("option", word, options);
    }
  }
  return std::nullopt;
}

int parse_and_run(CLI::App& app, int argc, char** argv, const int& exit_code) {
  try {
    app.parse(argc, argv);
    return exit_code;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // help
    fmt::print(stderr, "gcslab: {} (see gcslab --help)\n",
               usage_fault(app, argc, argv).value_or(error.what()));
    return kBadInput;
  } catch (const InputError& error) {
    return complain(error, kBadInput);
  } catch (const NotApplicable& error) {
    return complain(error, kNotApplicable);
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "gcslab: out of memory\n");
    return kBudgetExhausted;
  } catch (const std::exception& error) {
    fmt::print(
        stderr,
        "gcslab: {}\ngcslab: this is a fault of the program; please report this line and the command\n",
        error.what());
    return kFailedInside;
  }
}

int main_program(int argc, char** argv) {
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
    fmt::print(stderr, "gcslab: this build needs a processor with AVX2 and FMA (x86-64-v3)\n");
    return kFailedInside;
  }
  std::signal(SIGXFSZ, SIG_IGN);  // a write beyond RLIMIT_FSIZE is an error, not a death
  int exit_code = kDone;
  CLI::App app(kDescription, "gcslab");
  app.footer(kFooter);
  app.require_subcommand(1);
  app.set_version_flag("--version", GCSLAB_VERSION);
  Catalogue catalogue = standard_catalogue();
  catalogue.check_report_item = check_report_item;
  add_list_command(app, exit_code);
  add_describe_command(app, exit_code);
  add_cover_command(app, exit_code);
  add_solve_command(app, exit_code);
  add_run_command(app, catalogue, exit_code);
  add_report_command(app, catalogue, exit_code);
  add_verify_command(app, exit_code);
  add_export_command(app, exit_code);
  add_validate_command(app, catalogue, exit_code);
  add_job_command(app, catalogue, exit_code);
  app.parse_complete_callback(check_rounding);
  const int code = parse_and_run(app, argc, argv, exit_code);
  // A full disk or a closed pipe shows only when the last byte is written.
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    fmt::print(stderr, "gcslab: standard output cannot be written\n");
    return kBadInput;
  }
  return code;
}

}  // namespace
}  // namespace gcslab

int main(int argc, char** argv) { return gcslab::main_program(argc, argv); }
