#include "experiments/commands/job_command.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "base/error.h"
#include "experiments/runner/job_process.h"

namespace gcslab {
namespace {

struct JobArguments {
  std::string question;
  std::string answer;
};

int run(const JobArguments& arguments, const Catalogue& catalogue) {
  try {
    run_job_file(arguments.question, arguments.answer, catalogue);
    return 0;
  } catch (const InputError& error) {
    std::cerr << error.what() << '\n';
    return kCannotGoOn;
  }
}

}  // namespace

void add_job_command(CLI::App& app, const Catalogue& catalogue, int& exit_code) {
  auto arguments = std::make_shared<JobArguments>();
  CLI::App* command = app.add_subcommand("job", "Run one job in this process");
  command->group("");  // not shown in the help
  command->add_option("question", arguments->question, "Job or row file")->required();
  command->add_option("answer", arguments->answer, "Where the result goes")->required();
  command->callback([arguments, &catalogue, &exit_code] { exit_code = run(*arguments, catalogue); });
}

}  // namespace gcslab
