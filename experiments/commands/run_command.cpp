#include "experiments/commands/run_command.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <set>

#include "base/error.h"
#include "experiments/commands/exit_code.h"
#include "experiments/runner/experiment_config.h"
#include "experiments/runner/run_experiment.h"
#include "experiments/tasks/catalogue.h"

namespace gcslab {
namespace {

struct RunArguments {
  std::vector<std::string> configs;
  std::string runs = RunOptions().runs.string();
  std::string shard = "1/1";
  RunOptions options;
};

int run(RunArguments& arguments, const Catalogue& catalogue) {
  arguments.options.runs = arguments.runs;
  arguments.options.shard = Shard::parse(arguments.shard);
  for (const ExperimentConfig& config : load_experiments(arguments.configs, catalogue)) {
    if (run_experiment(config, arguments.options, std::cout).interrupted) return kBudgetExhausted;
  }
  return kDone;
}

}  // namespace

void add_run_command(CLI::App& app, const Catalogue& catalogue, int& exit_code) {
  auto arguments = std::make_shared<RunArguments>();
  RunOptions& options = arguments->options;
  CLI::App* command = app.add_subcommand("run", "Run the jobs of experiments that have no result yet");
  command->add_option("configs", arguments->configs, "Config files")->required()->type_name("CONFIG");
  command->add_option("--out", arguments->runs, "Folder for results, one folder an experiment in it")
      ->capture_default_str()
      ->type_name("DIR");
  command->add_option("--jobs", options.parallel, "Jobs at a time; more than 1 disturbs timings")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str()
      ->type_name("N");
  command->add_flag("--dry-run", options.dry_run, "Show the plan, run nothing");
  command->add_flag("--fresh", options.fresh, "Run every job again");
  command->add_flag("--explain", options.explain, "Say of each job why it is cached, stale or fresh");
  command->add_option("--shard", arguments->shard, "Only part k of n of the jobs")
      ->capture_default_str()
      ->type_name("k/n");
  command->footer("A run that was interrupted (exit code 3) or killed goes on when the command is repeated.");
  command->callback([arguments, &catalogue, &exit_code] { exit_code = run(*arguments, catalogue); });
}

}  // namespace gcslab
