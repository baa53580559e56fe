#include "experiments/reporting/figure_script.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <sstream>

#include "experiments/reporting/escape.h"

namespace gcslab {
namespace {

/// Bytes that begin a character in UTF-8.
std::ptrdiff_t character_count(std::string_view text) {
  return std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
}

}  // namespace

std::size_t FigureScript::add_data(std::string_view comment, std::string_view lines) {
  data_ += fmt::format("{}# {}: {}\n", blocks_ == 0 ? "" : "\n\n", blocks_, comment);
  data_ += lines;
  return blocks_++;
}

void FigureScript::command(std::string_view line) {
  commands_ += line;
  commands_ += '\n';
}

std::string FigureScript::position(double x, double y) const {
  return fmt::format("screen {:.5f},{:.5f}", x / width, y / height);
}

void FigureScript::place(const PanelBox& box) {
  command(fmt::format("set lmargin at screen {:.5f}; set rmargin at screen {:.5f}", box.left / width,
                      box.right() / width));
  command(fmt::format("set bmargin at screen {:.5f}; set tmargin at screen {:.5f}", box.bottom / height,
                      box.top() / height));
}

void FigureScript::text(double x, double y, std::string_view words, const TextStyle& style) {
  command(fmt::format("set label {} at {} {} {}font ',{}' tc rgb '{}' noenhanced front",
                      gnuplot_string(words), position(x, y), style.alignment,
                      style.upwards ? "rotate by 90 " : "", style.size, style.colour));
}

void FigureScript::rule(double x0, double y0, double x1, double y1, std::string_view style) {
  command(fmt::format("set arrow from {} to {} nohead {}", position(x0, y0), position(x1, y1), style));
}

double text_width(std::string_view words, double size) {
  constexpr double kMeanAdvance = 0.57;  // of the font size
  return static_cast<double>(character_count(words)) * kMeanAdvance * size * kMillimetresPerPoint;
}

std::size_t even_line(std::size_t count, std::size_t most) {
  const std::size_t lines = std::max<std::size_t>(1, (count + most - 1) / most);
  return (count + lines - 1) / lines;
}

std::vector<std::string> wrapped(std::string_view words, double width, double size) {
  std::vector<std::string> lines;
  std::istringstream stream{std::string(words)};
  std::string word;
  while (stream >> word) {
    if (!lines.empty() && text_width(lines.back() + " " + word, size) <= width) {
      lines.back() += " " + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

std::string plot_number(double number) {
  if (!std::isfinite(number)) return "NaN";
  if (number == 0) return "0";  // no "-0"
  return fmt::format("{:.6g}", number);
}

}  // namespace gcslab
