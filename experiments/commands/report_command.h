#pragma once

// gcslab report CONFIG...: tables and figures of experiments, compared with the committed ones.

namespace CLI {
class App;
}

namespace gcslab {

struct Catalogue;

/// Adds the command. When it was called, `exit_code` is 0, or 1 if counts or outcomes differ from the
/// reference. `catalogue` and `exit_code` outlive `app`. Throws InputError from the parsing of `app`.
void add_report_command(CLI::App& app, const Catalogue& catalogue, int& exit_code);

}  // namespace gcslab
