#pragma once

namespace CLI {
class App;
}

namespace gcslab {

/// gcslab verify RESULT.json [--proof FILE]: proves the claims of a result again, by other means.
void add_verify_command(CLI::App& app, int& exit_code);

}  // namespace gcslab
