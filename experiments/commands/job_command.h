#pragma once

// gcslab job QUESTION.json ANSWER.json: one job in this process. Hidden: `run` starts it for each job; a
// developer can repeat a job with it, since a row file is a question too.

namespace CLI {
class App;
}

namespace gcslab {

struct Catalogue;

/// Adds the command. `exit_code` is 0 when the answer was written, whatever the outcome, and 74 when no job
/// can go on (one line on stderr says why). `catalogue` and `exit_code` outlive `app`.
void add_job_command(CLI::App& app, const Catalogue& catalogue, int& exit_code);

}  // namespace gcslab
