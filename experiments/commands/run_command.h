#pragma once

// gcslab run CONFIG...: runs experiments, or shows what would be run.

namespace CLI {
class App;
}

namespace gcslab {

struct Catalogue;

/// Adds the command. When it was called, `exit_code` is 0 if every job has a row, whatever its outcome, and 3
/// if the run was interrupted before that. `catalogue` and `exit_code` outlive `app`. Throws InputError from
/// the parsing of `app`.
void add_run_command(CLI::App& app, const Catalogue& catalogue, int& exit_code);

}  // namespace gcslab
