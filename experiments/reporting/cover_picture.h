#pragma once

// The picture of one cover, for `gcslab cover --figure`, and the curves that pictures draw.

#include <filesystem>
#include <string>

#include "experiments/reporting/report_context.h"

namespace gcslab {

class CoverTree;
struct Problem;

/// Throws InputError when such a picture cannot be made: the problem is no plane curve, or `file` is neither
/// .svg nor .pdf.
void check_cover_picture(const Problem& problem, const std::filesystem::path& file);

/// Writes the picture, and its data and gnuplot script (.dat, .gp) beside it.
void write_cover_picture(const Problem& problem, const CoverTree& tree, const std::string& method,
                         const std::filesystem::path& file);

/// The curves of a problem, traced on its box.
ProblemCurves traced_curves(const Problem& problem);

/// Throws InputError unless the name of a picture's file ends in .svg or .pdf and it can be written.
void check_picture_file(const std::filesystem::path& file);

/// Traces curves of the corpus, each once.
CurveSource corpus_curves();

}  // namespace gcslab
