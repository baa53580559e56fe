#pragma once

namespace CLI {
class App;
}

namespace gcslab {

struct Catalogue;

/// gcslab validate FILE...: checks problem files, suites and configs; exit code 1 when one is bad.
void add_validate_command(CLI::App& app, const Catalogue& catalogue, int& exit_code);

}  // namespace gcslab
