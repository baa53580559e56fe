#include "experiments/reporting/box_drawing.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "experiments/reporting/number_format.h"
#include "experiments/reporting/palette.h"

namespace gcslab {
namespace {

/// Boxes narrower than this part of the domain, 0.02 mm in a panel of 80 mm, are no more than a dot.
constexpr double kVisible = 1.0 / 4000;

using Rectangle = std::array<Interval, 2>;

/// The colour of what is left of a box, by its fate; boxes that were cut show their parts.
constexpr std::array<std::pair<BoxFate, std::string_view>, 5> kFills = {
    {{BoxFate::empty, palette::kEmptyBox},
     {BoxFate::root, palette::kRootBox},
     {BoxFate::covered, palette::kRootBox},
     {BoxFate::undecided, palette::kUndecidedBox},
     {BoxFate::pending, palette::kPendingBox}}};

class BoxPanel {
 public:
  BoxPanel(FigureScript& figure, const SearchPicture& picture, const BoxStyle& style, const std::string& name)
      : figure_(figure),
        picture_(picture),
        style_(style),
        name_(name),
        domain_(shown_domain(picture, style)) {}

  void draw(const PanelBox& panel, const ProblemCurves& curves) {
    if (style_.fills && picture_.domain.size() == 2) add_fills();
    add_outlines();
    if (picture_.domain.size() == 2) add_curves(curves);
    add_small_undecided();
    add_roots();
    figure_.place(panel);
    figure_.command(axis_commands(domain_, style_.vertical_tics));
    figure_.command(layers_.empty() ? "plot NaN" : "plot " + layers_);
  }

 private:
  void add_layer(const std::string& what, const std::string& lines, const std::string& with) {
    if (lines.empty()) return;
    const std::size_t block = figure_.add_data(name_ + ", " + what, lines);
    layers_ +=
        fmt::format("{}data index {} using 1:2 with {}", layers_.empty() ? "" : ", \\\n  ", block, with);
  }

  Rectangle shown(const Box& box) const { return {box[style_.variables[0]], box[style_.variables[1]]}; }

  bool is_visible(const Rectangle& r) const {
    return width(r[0]) > kVisible * width(domain_[0]) || width(r[1]) > kVisible * width(domain_[1]);
  }

  static std::string point(double x, double y) { return plot_number(x) + " " + plot_number(y) + "\n"; }

  /// The corners from the lower left one and back to it, counterclockwise.
  static std::string loop(const Rectangle& r) {
    return point(r[0].lower, r[1].lower) + point(r[0].upper, r[1].lower) + point(r[0].upper, r[1].upper) +
           point(r[0].lower, r[1].upper) + point(r[0].lower, r[1].lower);
  }

  /// The part of `outer` outside of `inner` as one polygon: the inner corners are walked clockwise.
  static std::string ring(const Rectangle& outer, const Rectangle& inner) {
    return loop(outer) + point(inner[0].lower, inner[1].lower) + point(inner[0].lower, inner[1].upper) +
           point(inner[0].upper, inner[1].upper) + point(inner[0].upper, inner[1].lower) +
           point(inner[0].lower, inner[1].lower) + point(outer[0].lower, outer[1].lower);
  }

  static void add_part(std::string& lines, const std::string& part) {
    lines += (lines.empty() ? "" : "\n") + part;
  }

  void add_fills() {
    const auto filled = [](std::string_view colour) {
      return fmt::format("filledcurves closed fs solid 1 noborder lc rgb '{}'", colour);
    };
    std::string removed;
    for (const RecordedBox& box : picture_.boxes) {
      if (box.taken() != box.left()) add_part(removed, ring(shown(box.taken()), shown(box.left())));
    }
    add_layer("cut off by reductions", removed, filled(palette::kRemovedPart));
    for (const auto& [fate, colour] : kFills) {
      std::string lines;
      for (const RecordedBox& box : picture_.boxes) {
        if (box.fate == fate && is_visible(shown(box.left()))) add_part(lines, loop(shown(box.left())));
      }
      add_layer(std::string(name_of(fate)) + " boxes", lines, filled(colour));
    }
  }

  void add_outlines() {
    std::string taken, reduced;
    for (const RecordedBox& box : picture_.boxes) {
      if (is_visible(shown(box.taken()))) add_part(taken, loop(shown(box.taken())));
      for (std::size_t i = 1; i < box.stages.size(); ++i) {
        if (is_visible(shown(box.stages[i]))) add_part(reduced, loop(shown(box.stages[i])));
      }
    }
    add_layer("reduced boxes", reduced, fmt::format("lines lw 0.35 lc rgb '{}'", palette::kReducedBorder));
    add_layer("boxes taken", taken, fmt::format("lines lw 0.35 lc rgb '{}'", palette::kFrame));
  }

  void add_curves(const ProblemCurves& curves) {
    for (std::size_t k = 0; k < curves.equations.size(); ++k) {
      add_layer(fmt::format("equation {}", k + 1), curve_lines(curves.equations[k], domain_),
                fmt::format("lines lw 0.7 lc rgb '{}'", k % 2 == 0 ? palette::kBlue : palette::kVermillion));
    }
    for (std::size_t k = 0; k < curves.inequalities.size(); ++k) {
      add_layer(fmt::format("border of inequality {}", k + 1), curve_lines(curves.inequalities[k], domain_),
                fmt::format("lines lw 0.5 dt 2 lc rgb '{}'", palette::kGreen));
    }
  }

  void add_small_undecided() {
    std::string lines;
    for (const RecordedBox& box : picture_.boxes) {
      const Rectangle r = shown(box.left());
      if (box.fate == BoxFate::undecided && !is_visible(r)) lines += point(midpoint(r[0]), midpoint(r[1]));
    }
    add_layer("undecided boxes too small to see", lines,
              fmt::format("points pt 13 ps 0.6 lc rgb '{}'", palette::kOrange));
  }

  void add_roots() {
    std::string lines;
    for (const std::vector<double>& root : picture_.roots)
      lines += point(root[style_.variables[0]], root[style_.variables[1]]);
    add_layer("roots", lines, fmt::format("points pt 7 ps 0.4 lc rgb '{}'", palette::kBlack));
  }

  FigureScript& figure_;
  const SearchPicture& picture_;
  const BoxStyle& style_;
  const std::string& name_;
  Box domain_;
  std::string layers_;
};

std::string counted(std::uint64_t count, const std::string& one, const std::string& many) {
  return format_count(static_cast<double>(count)) + " " + (count == 1 ? one : many);
}

}  // namespace

Box shown_domain(const SearchPicture& picture, const BoxStyle& style) {
  return {picture.domain.at(style.variables[0]), picture.domain.at(style.variables[1])};
}

void draw_boxes(FigureScript& figure, const PanelBox& panel, const SearchPicture& picture,
                const ProblemCurves& curves, const BoxStyle& style, const std::string& name) {
  BoxPanel(figure, picture, style, name).draw(panel, curves);
}

std::string box_colours_text(bool fills, bool curves) {
  std::string text = "Lines: boxes as they were taken (grey) and after each reduction (blue).";
  if (fills) {
    text +=
        " Areas: cut off by reductions (pale blue), found empty (grey), left around a certified root "
        "(green), "
        "undecided (orange), not searched (yellow).";
  }
  if (curves) text += " Curves: the equations (blue, red), borders of inequalities (dashed).";
  return text + " Discs: certified roots; diamonds: undecided boxes too small to see.";
}

std::string box_counts_text(const SearchPicture& picture, double room) {
  std::uint64_t reductions = 0;
  for (const RecordedBox& box : picture.boxes) reductions += static_cast<std::uint64_t>(box.reductions);
  const std::string boxes = counted(picture.told, "box", "boxes");
  const std::string roots = counted(picture.roots.size(), "root", "roots");
  std::string whole = boxes + ", " + counted(reductions, "reduction", "reductions") + ", " + roots;
  if (picture.told == picture.boxes.size() && text_width(whole) <= room) return whole;
  return text_width(boxes + ", " + roots) <= room ? boxes + ", " + roots : boxes;
}

}  // namespace gcslab
