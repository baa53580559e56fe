#pragma once

// The picture of a constraint system's solutions, for `gcslab solve --figure`.

#include <filesystem>
#include <string>

#include "experiments/reporting/wireframe_table.h"
#include "experiments/solving/figure_picture.h"

namespace gcslab {

/// "8 solutions", "1 solution, flat, not certified"; flat: of space, but in the plane z = 0.
std::string solutions_text(const PicturedFigure& figure);

/// One of the picture's figures with its lines and names.
Wireframe wireframe_at(const FigurePicture& picture, std::size_t number);

/// One panel a figure up to isometry. `title` stands above.
FigureScript draw_figures(const FigurePicture& picture, const std::string& title);

/// Writes the picture, and its data and gnuplot script (.dat, .gp) beside it.
void write_figures_picture(const FigurePicture& picture, const std::string& title,
                           const std::filesystem::path& file);

}  // namespace gcslab
