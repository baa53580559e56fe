#include "experiments/reporting/legend.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "experiments/reporting/escape.h"
#include "experiments/reporting/palette.h"

namespace gcslab {
namespace {

constexpr double kSample = 6.5;  // length of a line sample
constexpr double kIndent = 1.5;  // from the sample to its name
constexpr double kSpace = 3.5;   // between entries
constexpr double kMargin = 2;    // at the edges of the figure
constexpr double kLineHeight = 3.6;

/// Entries in lines and columns of equal width, so that they read as a table.
struct Grid {
  std::size_t columns;
  std::size_t lines;
  double column_width;
};

Grid grid_for(const std::vector<std::string>& names, double width) {
  double widest = 0;
  for (const std::string& name : names) widest = std::max(widest, text_width(name));
  const double column = kSample + kIndent + widest + kSpace;
  const auto most =
      std::max<std::size_t>(1, static_cast<std::size_t>((width - 2 * kMargin + kSpace) / column));
  const std::size_t lines = (names.size() + most - 1) / most;
  return {(names.size() + lines - 1) / lines, lines, column};
}

}  // namespace

std::string LineLook::line_style(double width) const {
  return fmt::format("lc rgb '{}' dt {} lw {}", colour, dash_type, width);
}

LineLook line_look(std::size_t index) {
  static constexpr std::array kPoints = {7, 5, 9, 13, 11, 6, 4};
  const std::size_t round = index / palette::kLines.size();
  return {std::string(palette::kLines[index % palette::kLines.size()]),
          kPoints[(index + round) % kPoints.size()], static_cast<int>(1 + round % 4)};
}

double legend_height(const std::vector<std::string>& names, double width) {
  return names.size() < 2 ? 0 : kLineHeight * static_cast<double>(grid_for(names, width).lines);
}

void draw_legend(FigureScript& figure, const std::vector<std::string>& names, double left, double top) {
  if (names.size() < 2) return;
  const Grid grid = grid_for(names, figure.width);
  const double room = figure.width - kMargin - grid.column_width * static_cast<double>(grid.columns) + kSpace;
  left = std::max(kMargin, std::min(left, room));
  for (std::size_t i = 0; i < names.size(); ++i) {
    const LineLook look = line_look(i);
    const double x = left + grid.column_width * static_cast<double>(i % grid.columns);
    const std::size_t line = i / grid.columns;
    const double y = top - kLineHeight * (static_cast<double>(line) + 0.5);
    figure.rule(x, y, x + kSample, y, look.line_style());
    figure.command(fmt::format("set label '' at screen {:.5f},{:.5f} point pt {} ps 0.45 lc rgb '{}'",
                               (x + kSample / 2) / figure.width, y / figure.height, look.point_type,
                               look.colour));
    figure.text(x + kSample + kIndent, y, names[i]);
  }
}

}  // namespace gcslab
