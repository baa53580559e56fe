#pragma once

// Plain UTF-8 text in the spelling of each output format, so that a name like a_b|c% reads the same
// everywhere.

#include <string>
#include <string_view>

namespace gcslab {

/// One line of Markdown in which nothing is markup; fit for a table's cell.
std::string escape_markdown(std::string_view text);

/// LaTeX for a text paragraph; typographic characters (–, µ, ×10⁻³) become commands.
std::string escape_latex(std::string_view text);

/// HTML for text and for attribute values in double quotes.
std::string escape_html(std::string_view text);

/// A field of a CSV file (RFC 4180), quoted where it must be.
std::string escape_csv(std::string_view text);

/// A gnuplot string in single quotes, on one line.
std::string gnuplot_string(std::string_view text);

}  // namespace gcslab
