#pragma once

namespace CLI {
class App;
}

namespace gcslab {

/// gcslab solve PROBLEM [--method M] [--set option=value]... : every real solution in a box, with proof.
void add_solve_command(CLI::App& app, int& exit_code);

}  // namespace gcslab
