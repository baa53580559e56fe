#include "experiments/reporting/box_picture.h"

#include <algorithm>
#include <fmt/format.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "experiments/corpus/problem.h"
#include "experiments/reporting/box_drawing.h"
#include "experiments/reporting/cover_picture.h"
#include "experiments/reporting/gnuplot.h"
#include "experiments/reporting/number_format.h"
#include "experiments/reporting/palette.h"

namespace gcslab {
namespace {

constexpr double kPanelWidth = 74;
constexpr double kKeyLine = 3;  // from one line of the key to the colours to the next

std::size_t number_of(const std::string& name, const std::vector<std::string>& variables) {
  const auto found = std::ranges::find(variables, name);
  if (found == variables.end()) {
    throw InputError("--figure-variables: " + unknown_name_message("variable", name, variables));
  }
  return static_cast<std::size_t>(found - variables.begin());
}

void check_sides(const Problem& problem, const std::array<std::size_t, 2>& variables) {
  for (const std::size_t i : variables) {
    const Interval& side = problem.system.box[i];
    if (!is_bounded(side) || !(side.lower < side.upper)) {
      throw InputError("--figure: the box of '" + problem.system.variables[i] +
                       "' is unbounded or flat; give a bounded one with --box");
    }
  }
}

}  // namespace

std::array<std::size_t, 2> pictured_variables(const Problem& problem, const std::string& names) {
  const std::vector<std::string>& variables = problem.system.variables;
  if (variables.size() != 2 && variables.size() != 3) {
    throw InputError(
        fmt::format("--figure: searches in two or three unknowns can be drawn, and this problem has {}",
                    variables.size()));
  }
  std::array<std::size_t, 2> numbers = {0, 1};
  if (!names.empty()) {
    const std::size_t comma = names.find(',');
    if (comma == std::string::npos)
      throw InputError("--figure-variables '" + names + "': expected two unknowns, such as " + variables[0] +
                       "," + variables[1]);
    numbers = {number_of(names.substr(0, comma), variables), number_of(names.substr(comma + 1), variables)};
    if (numbers[0] == numbers[1]) throw InputError("--figure-variables: the two unknowns must differ");
  }
  check_sides(problem, numbers);
  return numbers;
}

void write_box_picture(const Problem& problem, const SearchPicture& picture,
                       const std::array<std::size_t, 2>& variables, const std::string& method,
                       const std::filesystem::path& file) {
  BoxStyle style;
  style.variables = variables;
  FigureScript figure;
  figure.width = kColumnWidth;
  const double height = kPanelWidth * panel_aspect(shown_domain(picture, style));
  const bool is_plane = picture.domain.size() == 2;
  const std::string colours = box_colours_text(is_plane, is_plane);
  const std::vector<std::string> key = wrapped(colours, kColumnWidth - 3);
  const double key_height = kKeyLine * static_cast<double>(key.size());
  const PanelBox panel = {8.5, key_height + 11.5, kPanelWidth, height};
  figure.height = panel.top() + 5;
  const std::string title = heading_of("problem", problem.name) + ", " + method;
  const TextStyle quiet = {"center", kSmallText, palette::kQuietText};
  figure.text(panel.centre(), panel.top() + 2.4, title, {"center", kTitleText});
  figure.text(panel.centre(), panel.bottom - 5.3, problem.system.variables[variables[0]], quiet);
  figure.text(1.8, panel.bottom + 0.75 * height, problem.system.variables[variables[1]],
              {"center", kSmallText, palette::kQuietText, true});
  std::string counts = box_counts_text(picture, kPanelWidth);
  if (picture.told > picture.boxes.size())
    counts += fmt::format(" (the first {} drawn)", format_count(static_cast<double>(picture.boxes.size())));
  figure.text(panel.centre(), panel.bottom - 8.6, counts, quiet);
  for (std::size_t i = 0; i < key.size(); ++i)
    figure.text(1.5, key_height - kKeyLine * static_cast<double>(i), key[i],
                {"left", kSmallText, palette::kQuietText});
  draw_boxes(figure, panel, picture, traced_curves(problem), style, title);
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  write_figure(figure, "Boxes of " + title + ". " + colours, folder, file.stem().string(),
               {file.extension().string().substr(1)});
}

}  // namespace gcslab
