#include "experiments/reporting/wireframe_table.h"

#include <algorithm>
#include <fmt/format.h>

#include "experiments/reporting/palette.h"

namespace gcslab {
namespace {

constexpr double kHeadingHeight = 5;
constexpr double kCaptionHeight = 3.6;
constexpr double kLabelWidth = 5;
constexpr double kGap = 2;
constexpr double kMargin = 0.5;
constexpr double kWidestPanel = 80;
constexpr double kTallestAspect = 1.25;

bool is_plane(const Wireframe& figure) { return figure.universe() == Universe::plane; }
bool is_spatial(const Wireframe& figure) { return !is_plane(figure); }

bool is_surface(const WireObject& object) {
  return object.sort == Sort::plane || object.sort == Sort::sphere;
}

/// How the figures of a group are seen, and how large.
class GroupLook {
 public:
  GroupLook(const WireGroup& group, const WireTableStyle& style, double panel_width)
      : style_(style), panel_width_(panel_width) {
    std::vector<Wireframe> spatial;
    for (const auto& line : group.lines) {
      for (const WireCell& cell : line) {
        if (!cell.figure) continue;
        figures_.push_back(*cell.figure);
        if (is_spatial(*cell.figure)) spatial.push_back(*cell.figure);
      }
    }
    look_ = {style.view ? *style.view : best_view(spatial), style.names, style.values, style.dimensions};
    choose_scale();
  }

  const WireLook& look() const { return look_; }
  double scale() const { return scale_; }

  double panel_height(const std::vector<WireCell>& line) const {
    double tallest = 10;
    for (const WireCell& cell : line) {
      if (cell.figure)
        tallest =
            std::max(tallest, scale_ * seen_bounds(*cell.figure, look_).height() + 2 * upright_margin());
    }
    return tallest;
  }

 private:
  /// Room for texts around the figures.
  double side_margin() const {
    double widest = 0;
    for (const Wireframe& figure : figures_) {
      if (style_.names) {
        for (const std::string& name : figure.names) widest = std::max(widest, text_width(name));
        for (const WireObject& object : figure.objects) widest = std::max(widest, text_width(object.name));
      }
      if (style_.values && is_plane(figure))
        for (const WireEdge& edge : figure.edges) widest = std::max(widest, 0.5 * text_width(edge.label));
    }
    return std::min(widest + 1.5, panel_width_ / 4);
  }
  double upright_margin() const {
    if (style_.values && std::ranges::any_of(figures_, is_plane)) return 7;
    return style_.names ? 4 : 1;
  }

  void choose_scale() {
    double width = 0, height = 0;
    for (const Wireframe& figure : figures_) {
      const SeenBounds bounds = seen_bounds(figure, look_);
      width = std::max(width, bounds.width());
      height = std::max(height, bounds.height());
    }
    const double across = panel_width_ - 2 * side_margin();
    const double up = kTallestAspect * panel_width_ - 2 * upright_margin();
    if (width > 0) scale_ = across / width;
    if (height > 0 && (width == 0 || height * scale_ > up)) scale_ = up / height;
  }

  const WireTableStyle& style_;
  double panel_width_;
  std::vector<Wireframe> figures_;
  WireLook look_;
  double scale_ = 1;
};

class Layout {
 public:
  Layout(const WireTable& table, const WireTableStyle& style) : table_(table) {
    std::size_t columns = 1;
    bool has_labels = false;
    for (const WireGroup& group : table.groups) {
      for (const auto& line : group.lines) columns = std::max(columns, line.size());
      has_labels = has_labels || !group.label.empty();
    }
    left_ = kMargin + (has_labels ? kLabelWidth : 0);
    const double gaps = kGap * static_cast<double>(columns - 1);
    panel_width_ =
        std::min(kWidestPanel, (style.width - left_ - kMargin - gaps) / static_cast<double>(columns));
    for (const WireGroup& group : table.groups) looks_.emplace_back(group, style, panel_width_);
    script_.width = left_ + kMargin + panel_width_ * static_cast<double>(columns) + gaps;
    script_.height = height();
  }

  FigureScript draw() {
    double top = script_.height - kMargin;
    if (!table_.title.empty()) {
      script_.text(script_.width / 2, top - kHeadingHeight / 2, table_.title, {"center", kTitleText});
      top -= kHeadingHeight;
    }
    if (!table_.headings.empty()) {
      write_headings(top - kHeadingHeight / 2);
      top -= kHeadingHeight;
    }
    for (std::size_t g = 0; g < table_.groups.size(); ++g) {
      for (const auto& line : table_.groups[g].lines) {
        draw_line(line, table_.groups[g].label, looks_[g], top);
        top -= line_height(line, looks_[g]) + kGap;
      }
    }
    return std::move(script_);
  }

 private:
  static double line_height(const std::vector<WireCell>& line, const GroupLook& look) {
    const bool has_captions = std::ranges::any_of(line, [](const WireCell& c) { return !c.caption.empty(); });
    return look.panel_height(line) + (has_captions ? kCaptionHeight : 0);
  }

  double height() const {
    double sum = 2 * kMargin + (table_.headings.empty() ? 0 : kHeadingHeight) +
                 (table_.title.empty() ? 0 : kHeadingHeight);
    for (std::size_t g = 0; g < table_.groups.size(); ++g) {
      for (const auto& line : table_.groups[g].lines) sum += line_height(line, looks_[g]) + kGap;
    }
    return sum;
  }

  double column_left(std::size_t column) const {
    return left_ + static_cast<double>(column) * (panel_width_ + kGap);
  }

  void write_headings(double y) {
    for (std::size_t column = 0; column < table_.headings.size(); ++column)
      script_.text(column_left(column) + panel_width_ / 2, y, table_.headings[column],
                   {"center", kTitleText});
  }

  void draw_line(const std::vector<WireCell>& line, const std::string& label, const GroupLook& look,
                 double top) {
    const double tall = look.panel_height(line);
    ++lines_;
    if (!label.empty())
      script_.text(2.2, top - tall / 2, label, {"center", kTitleText, palette::kText, true});
    for (std::size_t column = 0; column < line.size(); ++column) {
      const PanelBox panel = {column_left(column), top - tall, panel_width_, tall};
      const WireCell& cell = line[column];
      const std::string name = fmt::format("line {}, column {}{}", lines_, column + 1,
                                           cell.caption.empty() ? "" : ", " + cell.caption);
      script_.command("\n# " + name);
      script_.text(panel.centre(), panel.bottom - kCaptionHeight / 2, cell.caption,
                   {"center", kSmallText, palette::kQuietText});
      if (cell.figure) {
        draw_wireframe(script_, panel, *cell.figure, look.look(), look.scale(), name);
      } else {
        draw_words(cell.words, panel);
      }
      script_.clear_texts();
    }
  }

  void draw_words(const std::string& words, const PanelBox& panel) {
    const std::vector<std::string> lines = wrapped(words, panel.width - 2);
    double y = (panel.bottom + panel.top()) / 2 + 1.6 * (static_cast<double>(lines.size()) - 1);
    for (const std::string& text : lines) {
      script_.text(panel.centre(), y, text, {"center", kSmallText, palette::kQuietText});
      y -= 3.2;
    }
    script_.place(panel);
    script_.command("set border 0; unset xtics; unset ytics\nset xrange [0:1]; set yrange [0:1]\nplot NaN");
  }

  const WireTable& table_;
  FigureScript script_;
  std::vector<GroupLook> looks_;  ///< one a group
  double left_ = 0, panel_width_ = 0;
  std::size_t lines_ = 0;  ///< drawn
};

}  // namespace

FigureScript draw_wire_table(const WireTable& table, const WireTableStyle& style) {
  return Layout(table, style).draw();
}

WireGroup in_lines(std::vector<WireCell> cells, std::size_t most) {
  const std::size_t columns = even_line(cells.size(), std::max<std::size_t>(1, most));
  WireGroup group;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i % columns == 0) group.lines.emplace_back();
    group.lines.back().push_back(std::move(cells[i]));
  }
  return group;
}

FigureScript draw_strip(const std::vector<CaptionedFigure>& figures, std::size_t per_line,
                        const WireTableStyle& style) {
  std::vector<WireCell> cells;
  for (const CaptionedFigure& figure : figures)
    cells.push_back({.figure = figure.figure, .caption = figure.caption});
  WireTableStyle plain = style;
  plain.names = plain.values = false;
  return draw_wire_table({.groups = {in_lines(std::move(cells), per_line)}}, plain);
}

std::string depth_note(const WireTable& table) {
  bool has_spatial = false, has_faces = false, has_surfaces = false;
  for (const WireGroup& group : table.groups) {
    for (const auto& line : group.lines) {
      for (const WireCell& cell : line) {
        if (!cell.figure || !is_spatial(*cell.figure)) continue;
        has_spatial = true;
        has_faces = has_faces || !cell.figure->faces.empty();
        has_surfaces = has_surfaces || std::ranges::any_of(cell.figure->objects, is_surface);
      }
    }
  }
  if (!has_spatial) return "";
  std::string note =
      "In space, nearer edges are darker and thicker, and what passes behind them is interrupted";
  if (has_faces) note += "; faces are shaded";
  if (has_surfaces) note += "; planes and spheres are shaded, and what is behind or within them is paler";
  return note + ".";
}

}  // namespace gcslab
