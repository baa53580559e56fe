#pragma once

// The picture of one search, for `gcslab solve --figure`.

#include <array>
#include <filesystem>
#include <string>

#include "experiments/solving/search_picture_json.h"

namespace gcslab {

struct Problem;

/// How many boxes of a search are kept for its picture.
inline constexpr std::size_t kDrawnBoxes = 20'000;

/// The two unknowns that a picture shows: those named in "x,z", or the first two when the text is empty.
/// Throws InputError when such a picture cannot be made: the problem has not two or three unknowns, its box
/// is unbounded or flat, or a name is none of its unknowns.
std::array<std::size_t, 2> pictured_variables(const Problem& problem, const std::string& names);

/// Writes the picture, and its data and gnuplot script (.dat, .gp) beside it.
void write_box_picture(const Problem& problem, const SearchPicture& picture,
                       const std::array<std::size_t, 2>& variables, const std::string& method,
                       const std::filesystem::path& file);

}  // namespace gcslab
