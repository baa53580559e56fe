#pragma once

namespace CLI {
class App;
}

namespace gcslab {

/// gcslab describe NAME [--json]: a method, task, problem, suite or config.
void add_describe_command(CLI::App& app, int& exit_code);

}  // namespace gcslab
