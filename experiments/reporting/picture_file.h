#pragma once

// What gnuplot leaves to mend in its pictures.

#include <filesystem>
#include <string>
#include <string_view>

namespace gcslab {

/// Fonts for readers without DejaVu, thin shapes that stay visible, no tooltips on curves, short paths.
/// Throws InputError when the file does not end as an SVG does: gnuplot itself does not complain of a full
/// disk.
void mend_svg(const std::filesystem::path& path);

/// The time of creation becomes a fixed one of equal length, so that equal figures are equal files and the
/// offsets in the file stay right. Throws InputError when the file is not whole.
void mend_pdf(const std::filesystem::path& path);

/// A path of gnuplot, "M1.00,2.00 L3.00,2.00 ...", with horizontal and vertical steps written short.
std::string shortened_path(std::string_view path);

}  // namespace gcslab
