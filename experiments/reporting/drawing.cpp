// Figure kind drawing: the panels that a task drew itself, in the styles of this report.

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/nearest_name.h"
#include "experiments/reporting/figure_registry.h"
#include "experiments/reporting/measure.h"
#include "experiments/reporting/number_format.h"
#include "experiments/reporting/palette.h"
#include "experiments/reporting/plot_axis.h"

namespace gcslab {
namespace {

constexpr double kGap = 6;
constexpr double kNumberWidth = 12;  // numbers and label beside the first panel
constexpr double kTitleHeight = 5;
constexpr double kAxisHeight = 8.5;
constexpr double kRightMargin = 3;

/// How a style draws lines, areas and points.
struct ShapeStyle {
  std::string_view colour;
  std::string_view fill;  ///< of polygons; empty: not filled
  double line_width;
  int dash_type;
  int point_type;
  double point_size = 0.4;
};

const std::map<std::string, ShapeStyle>& shape_styles() {
  static const std::map<std::string, ShapeStyle> styles = {
      {"curve", {palette::kBlack, "", 1.2, 1, 7}},
      {"hull", {palette::kBlue, "#CFE3F1", 0.5, 1, 7}},
      {"control", {palette::kVermillion, "", 0.6, 2, 7}},
      {"cell", {palette::kFrame, "#EFEFEF", 0.4, 1, 7}},
      {"axis", {palette::kFrame, "", 0.4, 1, 7}},
      {"accent", {palette::kVermillion, "#F7DCC8", 1.2, 1, 7}},
      {"muted", {"#A0A0A0", "#F4F4F4", 0.5, 1, 7}},
      {"first", {palette::kBlue, "", 1.2, 1, 7}},
      {"second", {palette::kVermillion, "", 1.2, 1, 7}},
      {"line", {palette::kVermillion, "", 0.6, 1, 7}},
      {"dashed", {"#808080", "", 0.5, 2, 7}},
      {"body", {palette::kBlue, "#E8F1F8", 0.1, 1, 7}},
      {"edge", {palette::kBlue, "", 0.9, 1, 7}},
      {"hidden", {palette::kBlue, "", 0.5, 2, 7}},
      {"mesh", {"#707070", "", 0.25, 1, 7}},
      {"bold", {palette::kBlack, "", 2.4, 1, 7, 0.6}},
      {"square", {palette::kBlack, "", 1, 1, 5, 0.6}},
      {"disc", {palette::kVermillion, "", 1, 1, 7, 0.6}}};
  return styles;
}

struct DrawnPanel {
  Json json;
  std::string title;
  std::string where;  ///< the row, for errors and data
};

class Drawing {
 public:
  explicit Drawing(const FigureRequest& request) : request_(request), item_(request.item) {}

  FigureScript draw() {
    figure_.width = width_from(request_.options);
    figure_.notes = notes_on_missing(request_.rows);
    figure_.command("set style textbox opaque noborder margins 0.6,0.6");
    try {
      collect();
      lay_out();
      for (std::size_t i = 0; i < panels_.size(); ++i) draw_panel(i);
    } catch (const nlohmann::json::exception& error) {
      throw InputError(item_.where,
                       "'" + item_.file + "': a panel is not as the kind drawing takes it: " + error.what());
    }
    return std::move(figure_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(item_.where, "'" + item_.file + "': " + message);
  }

  void collect() {
    const std::vector<std::string> varying = varying_axes();
    for (const Row* row : request_.rows) {
      if (!row->has_result()) continue;
      if (!row->artifact.is_object() || !row->artifact.contains("panels")) fail("the rows hold no drawings");
      for (const Json& panel : row->artifact.at("panels")) {
        panels_.push_back({panel, title_of(*row, panel, varying), place_text(*row)});
      }
    }
    if (panels_.empty()) panels_.push_back({Json::object(), "nothing to draw", ""});
  }

  std::vector<std::string> varying_axes() const {
    std::vector<std::string> axes;
    for (const std::string& axis : request_.context.rows.axes()) {
      if (keys_on(request_.rows, {axis}).size() > 1) axes.push_back(axis);
    }
    return axes;
  }

  static std::string title_of(const Row& row, const Json& panel, const std::vector<std::string>& varying) {
    std::string title = panel.value("title", "");
    if (!title.empty()) return title;
    for (const std::string& axis : varying)
      title += (title.empty() ? "" : ", ") + heading_of(axis, row.at(axis));
    return title;
  }

  // ---- layout ----

  static double extent(const Json& panel, const char* axis) {
    return panel.contains(axis) ? panel.at(axis).at(1).get<double>() - panel.at(axis).at(0).get<double>() : 1;
  }

  double aspect_of(const Json& panel) const {
    if (panel.value("aspect", "free") == "equal") return extent(panel, "y") / extent(panel, "x");
    return request_.options.real("free_aspect");
  }

  void lay_out() {
    const auto wanted = static_cast<std::size_t>(request_.options.integer("panels_per_line"));
    const std::size_t most = figure_.width > kColumnWidth ? 4 : 2;
    per_line_ = wanted > 0 ? std::min(panels_.size(), wanted) : even_line(panels_.size(), most);
    const bool framed = std::ranges::any_of(panels_, [](const DrawnPanel& p) { return has_frame(p.json); });
    left_ = framed ? kNumberWidth : kRightMargin;
    axis_height_ = framed ? kAxisHeight : 1;
    gap_ = kGap + (same_heights() ? 0 : 7);
    const auto columns = static_cast<double>(per_line_);
    panel_width_ = (figure_.width - left_ - kRightMargin - gap_ * (columns - 1)) / columns;
    double depth = 0;
    for (std::size_t first = 0; first < panels_.size(); first += per_line_) {
      double tallest = 0;
      for (std::size_t i = first; i < std::min(first + per_line_, panels_.size()); ++i) {
        tallest = std::max(tallest, panel_width_ * aspect_of(panels_[i].json));
      }
      depth += kTitleHeight + tallest + axis_height_;
      bottoms_.push_back(depth - axis_height_);
    }
    figure_.height = depth;
  }

  /// All panels have the same upright range, so that only the first of a line needs numbers.
  bool same_heights() const {
    return std::ranges::all_of(panels_, [this](const DrawnPanel& p) {
      return p.json.contains("y") && panels_.front().json.contains("y") &&
             p.json.at("y") == panels_.front().json.at("y");
    });
  }

  // ---- panels ----

  void draw_panel(std::size_t index) {
    const DrawnPanel& panel = panels_[index];
    const double bottom = figure_.height - bottoms_[index / per_line_];
    const PanelBox box = {left_ + static_cast<double>(index % per_line_) * (panel_width_ + gap_), bottom,
                          panel_width_, panel_width_ * aspect_of(panel.json)};
    const bool is_first = index % per_line_ == 0;
    figure_.command("\n# " + panel.title);
    figure_.text(box.centre(), box.top() + 2.2, panel.title, {"center", kTitleText});
    figure_.text(box.centre(), box.bottom - 6.3, panel.json.value("xlabel", ""), {"center"});
    if (is_first || !same_heights()) {
      const double x = is_first ? 2 : box.left - 9.5;
      figure_.text(x, (box.bottom + box.top()) / 2, panel.json.value("ylabel", ""),
                   {"center", kSmallText, "#202020", true});
    }
    figure_.place(box);
    const bool numbers = is_first || !same_heights();
    figure_.command(axis(panel.json, "x").commands('x', has_frame(panel.json)));
    figure_.command(axis(panel.json, "y").commands('y', has_frame(panel.json) && numbers));
    figure_.command(has_frame(panel.json) ? "set border 3; set tics scale 0.4,0.2"
                                          : "set border 0; set tics scale 0");
    figure_.command(plot_command(panel));
    figure_.clear_texts();
  }

  static PlotAxis axis(const Json& panel, const char* name) {
    if (!panel.contains(name)) return exact_axis(0, 1, 4);
    return exact_axis(panel.at(name).at(0).get<double>(), panel.at(name).at(1).get<double>(), 4);
  }

  static bool has_frame(const Json& panel) { return panel.value("frame", true); }

  std::string plot_command(const DrawnPanel& panel) {
    std::string layers;
    for (const Json& shape : panel.json.value("shapes", Json::array())) layers += layer_of(shape, panel);
    return layers.empty() ? "plot NaN" : "plot " + layers.substr(2);
  }

  const ShapeStyle& style_of(const Json& shape) const {
    const std::string name = shape.value("style", "curve");
    const auto found = shape_styles().find(name);
    if (found != shape_styles().end()) return found->second;
    std::vector<std::string> known;
    for (const auto& [style, look] : shape_styles()) known.push_back(style);
    fail(unknown_name_message("style of a shape", name, known));
  }

  std::string layer_of(const Json& shape, const DrawnPanel& panel) {
    const std::string kind = shape.at("kind").get<std::string>();
    const ShapeStyle& style = style_of(shape);
    if (kind == "label") return label_layer(shape, style, !has_frame(panel.json));
    const std::string lines = point_lines(shape, kind == "polygon");
    if (lines.empty()) return "";
    const std::size_t block = figure_.add_data(panel.where + ", " + panel.title + ", " + kind, lines);
    const std::string line =
        fmt::format("lw {} dt {} lc rgb '{}'", style.line_width, style.dash_type, style.colour);
    const auto layer = [block](const std::string& with) {
      return fmt::format(", \\\n  data index {} using 1:2 with {}", block, with);
    };
    if (kind == "points")
      return layer(
          fmt::format("points pt {} ps {} lc rgb '{}'", style.point_type, style.point_size, style.colour));
    if (kind == "polyline" || kind == "segment") return layer("lines " + line);
    if (kind != "polygon") fail("'" + kind + "' is no kind of shape");
    if (style.fill.empty()) return layer("lines " + line);
    return layer(fmt::format("filledcurves closed fs solid 1 noborder lc rgb '{}'", style.fill)) +
           layer("lines " + line);
  }

  static std::string point_lines(const Json& shape, bool closed) {
    std::string lines;
    for (const Json& point : shape.at("points")) lines += point_line(point);
    if (closed && !shape.at("points").empty()) lines += point_line(shape.at("points").at(0));
    return lines;
  }

  static std::string point_line(const Json& point) {
    return plot_number(point.at(0).get<double>()) + " " + plot_number(point.at(1).get<double>()) + "\n";
  }

  /// The text stands to the upper right of its point, or on it ("anchor": "centre") with the lines behind it
  /// cleared.
  std::string label_layer(const Json& shape, const ShapeStyle& style, bool centred_by_default) {
    const bool centred = shape.value("anchor", centred_by_default ? "centre" : "corner") == "centre";
    std::string data;
    for (const Json& point : shape.at("points")) {
      std::string line = point_line(point);
      line.pop_back();
      data += line + " \"" + quoted(shape.at("text").get<std::string>()) + "\"\n";
    }
    const std::size_t block = figure_.add_data("label", data);
    const char* place = centred ? "center boxed" : "left offset character 0.5,0.5";
    return fmt::format(", \\\n  data index {} using 1:2:3 with labels {} noenhanced tc rgb '{}'", block,
                       place, style.colour);
  }

  static std::string quoted(std::string text) {
    if (number_from_text(text)) return with_minus_sign(text);
    std::ranges::replace(text, '"', '\'');
    std::ranges::replace(text, '\n', ' ');
    return text;
  }

  const FigureRequest& request_;
  const ReportItem& item_;
  FigureScript figure_;
  std::vector<DrawnPanel> panels_;
  std::vector<double> bottoms_;  ///< of each line of panels, from the top
  std::size_t per_line_ = 1;
  double left_ = 0;
  double axis_height_ = 0;
  double gap_ = 0;
  double panel_width_ = 0;
};

}  // namespace

FigureKind drawing_kind() {
  return {"drawing",
          "the panels that a task drew, side by side",
          {{.name = "panels_per_line",
            .meaning = "panels side by side; 0: up to 4, lines of equal length",
            .default_value = std::int64_t{0},
            .minimum = 0,
            .maximum = 12},
           {.name = "free_aspect",
            .meaning = "height over width of panels without equal scales",
            .default_value = 0.75,
            .minimum = 0.1,
            .maximum = 10},
           width_option("page")},
          [](const FigureRequest& request) { return Drawing(request).draw(); }};
}

}  // namespace gcslab
