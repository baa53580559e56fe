#include "experiments/reporting/figures_picture.h"

#include <algorithm>
#include <fmt/format.h>

#include "experiments/reporting/gnuplot.h"

namespace gcslab {
namespace {

bool is_plane(const FigurePicture& picture) {
  return !picture.figures.empty() && wireframe_at(picture, 0).universe() == Universe::plane;
}

/// Lengths at the edges need room.
std::size_t most_per_line(const FigurePicture& picture) { return is_plane(picture) ? 3 : 5; }

WireGroup group_of(const FigurePicture& picture) {
  if (picture.figures.empty()) return {.lines = {{{.figure = {}, .words = "no figure was found"}}}};
  std::vector<WireCell> cells;
  for (std::size_t i = 0; i < picture.figures.size(); ++i)
    cells.push_back({.figure = wireframe_at(picture, i), .caption = solutions_text(picture.figures[i])});
  return in_lines(std::move(cells), most_per_line(picture));
}

}  // namespace

std::string solutions_text(const PicturedFigure& figure) {
  return fmt::format("{} solution{}{}{}", figure.solutions, figure.solutions == 1 ? "" : "s",
                     is_flat(figure.places) ? ", flat" : "", figure.is_certified ? "" : ", not certified");
}

Wireframe wireframe_at(const FigurePicture& picture, std::size_t number) {
  return picture.wires.at(picture.figures[number].places);
}

FigureScript draw_figures(const FigurePicture& picture, const std::string& title) {
  const WireTable table{.title = title, .groups = {group_of(picture)}};
  WireTableStyle style;
  const std::size_t fit_a_column = is_plane(picture) ? 1 : 2;
  style.width = picture.figures.size() <= fit_a_column ? kColumnWidth : kPageWidth;
  FigureScript script = draw_wire_table(table, style);
  const std::string note = depth_note(table);
  if (!note.empty()) script.notes.push_back(note);
  return script;
}

void write_figures_picture(const FigurePicture& picture, const std::string& title,
                           const std::filesystem::path& file) {
  const FigureScript script = draw_figures(picture, title);
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  std::string caption = "Figures of " + title + ".";
  for (const std::string& note : script.notes) caption += " " + note;
  write_figure(script, caption, folder, file.stem().string(), {file.extension().string().substr(1)});
}

}  // namespace gcslab
