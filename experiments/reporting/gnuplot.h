#pragma once

// The one place where pictures are made: a figure becomes <file>.dat, <file>.gp, <file>.svg and <file>.pdf.
//
// The script stands for itself: a reader edits it and runs `gnuplot -e 'format="svg"' <file>.gp` beside the
// data. Equal figures give equal bytes: what gnuplot writes of the time is taken out.

#include <filesystem>
#include <set>
#include <string>

#include "experiments/reporting/figure_script.h"

namespace gcslab {

/// Throws InputError when a file cannot be written or gnuplot is not installed (it names the package), and
/// std::runtime_error with gnuplot's own words when it refuses the script. `formats`: "svg", "pdf" or both.
void write_figure(const FigureScript& figure, const std::string& caption, const std::filesystem::path& folder,
                  const std::string& file, const std::set<std::string>& formats);

/// The whole text of the script.
std::string script_text(const FigureScript& figure, const std::string& caption, const std::string& file);

/// Runs a program in a folder and waits for it; stops it after `timeout_s`.
struct ProgramEnd {
  int exit_code = -1;  ///< 127: there is no such program; -1: stopped or ended by a signal
  bool timed_out = false;
  std::string error_text;  ///< what it wrote to stderr
};
ProgramEnd run_program(const std::vector<std::string>& command, const std::filesystem::path& folder,
                       double timeout_s);

}  // namespace gcslab
