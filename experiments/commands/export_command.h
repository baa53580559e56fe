#pragma once

namespace CLI {
class App;
}

namespace gcslab {

/// gcslab export PROBLEM --to FORMAT [--out FILE]: a system in the format of another program.
void add_export_command(CLI::App& app, int& exit_code);

}  // namespace gcslab
