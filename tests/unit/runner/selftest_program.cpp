// The commands `run` and `job` over the selftest task.

#include <CLI/CLI.hpp>
#include <iostream>

#include "base/error.h"
#include "experiments/commands/job_command.h"
#include "experiments/commands/run_command.h"
#include "selftest_task.h"

int main(int argc, char** argv) {
  CLI::App app("selftest of the runner");
  int exit_code = 0;
  gcslab::add_run_command(app, gcslab::selftest_catalogue(), exit_code);
  gcslab::add_job_command(app, gcslab::selftest_catalogue(), exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const gcslab::InputError& error) {
    std::cerr << "gcslab: " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "gcslab: failed inside: " << error.what() << '\n';
    return 5;
  }
  return exit_code;
}
