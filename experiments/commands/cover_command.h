#pragma once

namespace CLI {
class App;
}

namespace gcslab {

/// gcslab cover PROBLEM [--method M] [--depth K | --cell-size H] ...: covers one curve or surface.
void add_cover_command(CLI::App& app, int& exit_code);

}  // namespace gcslab
