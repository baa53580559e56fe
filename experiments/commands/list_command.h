#pragma once

namespace CLI {
class App;
}

namespace gcslab {

/// gcslab list problems|methods|suites|configs [--kind K] [--json]
void add_list_command(CLI::App& app, int& exit_code);

}  // namespace gcslab
