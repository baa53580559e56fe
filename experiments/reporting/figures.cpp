// Figure kind figures: what solved constraint systems look like, one panel a figure up to isometry.

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "experiments/reporting/class_alignment.h"
#include "experiments/reporting/figure_registry.h"
#include "experiments/reporting/figures_picture.h"
#include "experiments/reporting/view_option.h"

namespace gcslab {
namespace {

class FiguresKind {
 public:
  explicit FiguresKind(const FigureRequest& request)
      : request_(request), row_axes_(request.item.rows), column_axes_(request.item.columns) {
    if (!row_axes_.empty() || !column_axes_.empty()) return;
    const bool has_methods = keys_on(request.rows, {"method"}).size() > 1;
    column_axes_ = {has_methods ? "method" : "problem"};
    if (has_methods) row_axes_ = {"problem"};
  }

  FigureScript draw() {
    std::vector<std::string> axes = row_axes_;
    axes.insert(axes.end(), column_axes_.begin(), column_axes_.end());
    check_groups(request_.rows, axes, request_.item);
    const std::vector<AxisKey> columns = keys_on(request_.rows, column_axes_);
    const std::vector<AxisKey> lines = keys_on(request_.rows, row_axes_);
    const std::size_t per_line = columns.size() == 1 ? figures_per_line() : 1;
    WireTable table;
    if (per_line > 1) {
      table.title = joined(column_axes_, columns.front());
    } else {
      for (const AxisKey& column : columns) table.headings.push_back(joined(column_axes_, column));
    }
    for (const AxisKey& line : lines) {
      table.groups.push_back(group_of(axes, line, columns));
      if (per_line > 1) table.groups.back() = in_lines(all_cells(table.groups.back()), per_line);
      if (lines.size() > 1) table.groups.back().label = joined(row_axes_, line);
    }
    FigureScript script = draw_wire_table(table, style());
    for (std::string& note : notes_on_missing(request_.rows)) script.notes.push_back(std::move(note));
    if (shows_new_sketches())
      script.notes.emplace_back(
          "A solution, and the figures that the plan constructs on its other branches from the values that "
          "the solution shows.");
    if (!shows_sketches() && !shows_new_sketches()) {
      std::string note = "One panel a figure up to isometry, with the solutions that are it";
      if (columns.size() > 1) note += "; what is the same figure stands in one line";
      script.notes.push_back(note + ".");
    }
    const std::string depth = depth_note(table);
    if (!depth.empty()) script.notes.push_back(depth);
    return script;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(request_.item.where, "'" + request_.item.file + "': " + message);
  }

  static std::string joined(const std::vector<std::string>& axes, const AxisKey& key) {
    std::string text;
    for (std::size_t i = 0; i < key.size(); ++i) text += (i == 0 ? "" : ", ") + heading_of(axes[i], key[i]);
    return text;
  }

  /// The figures of a row; null where it has no result.
  const FigurePicture* picture_of(const Row* row) {
    if (row == nullptr || !row->has_result()) return nullptr;
    if (!row->artifact.is_object())
      fail("the rows hold no figures of " + row->at("problem") +
           "; kind figures is for the task solve on constraint systems, without recorded_boxes");
    try {
      FigurePicture picture = figure_picture_from_json(row->artifact);
      if (shows_sketches()) turn_into_sketch(picture);
      if (shows_new_sketches()) turn_into_new_sketches(picture);
      return &pictures_.emplace(row, std::move(picture)).first->second;
    } catch (const InputError& error) {
      fail(row->at("problem") + ": " + error.what());
    }
  }

  std::size_t figures_per_line() const {
    return static_cast<std::size_t>(request_.options.integer("per_line"));
  }

  static std::vector<WireCell> all_cells(const WireGroup& group) {
    std::vector<WireCell> cells;
    for (const auto& line : group.lines) cells.insert(cells.end(), line.begin(), line.end());
    return cells;
  }

  bool shows_sketches() const { return request_.options.word("show") == "sketch"; }
  bool shows_new_sketches() const { return request_.options.word("show") == "new_sketches"; }

  /// The sketch as the one figure, with parameters by their names alone: it has other values.
  static void turn_into_sketch(FigurePicture& picture) {
    if (picture.sketch.empty()) throw InputError("the method has no sketch");
    picture.figures = {{picture.sketch}};
    drop_values(picture);
  }

  /// The first solution and the sketches that come from it.
  static void turn_into_new_sketches(FigurePicture& picture) {
    if (picture.figures.empty() || picture.new_sketches.empty())
      throw InputError("there are no new sketches; plan_exploration makes them, from a first solution");
    picture.figures.resize(1);
    for (const FigurePicture::NewSketch& sketch : picture.new_sketches)
      picture.figures.push_back({sketch.places});
    drop_values(picture);
  }

  static void drop_values(FigurePicture& picture) {
    const auto without_value = [](std::string& label) { label = label.substr(0, label.find(' ')); };
    for (WireEdge& edge : picture.wires.edges) without_value(edge.label);
    for (WireAngle& angle : picture.wires.angles) without_value(angle.label);
    for (WireMeasure& measure : picture.wires.measures) without_value(measure.label);
  }

  /// The one figure of each column in one line.
  static std::vector<AlignedLine> side_by_side(const std::vector<const FigurePicture*>& pictures) {
    AlignedLine line;
    for (const FigurePicture* picture : pictures)
      line.push_back(picture == nullptr ? std::nullopt : std::optional<std::size_t>(0));
    return {line};
  }

  /// Figure number i of each column in line i.
  static std::vector<AlignedLine> one_by_one(const std::vector<const FigurePicture*>& pictures) {
    std::vector<AlignedLine> lines;
    for (std::size_t i = 0;; ++i) {
      AlignedLine line;
      for (const FigurePicture* picture : pictures) {
        const bool has_it = picture != nullptr && i < picture->figures.size();
        line.push_back(has_it ? std::optional<std::size_t>(i) : std::nullopt);
      }
      if (std::ranges::none_of(line, [](const auto& figure) { return figure.has_value(); })) return lines;
      lines.push_back(std::move(line));
    }
  }

  /// All figures of one row key.
  WireGroup group_of(const std::vector<std::string>& axes, const AxisKey& line_key,
                     const std::vector<AxisKey>& columns) {
    std::vector<const Row*> rows;
    std::vector<const FigurePicture*> pictures;
    for (const AxisKey& column : columns) {
      AxisKey key = line_key;
      key.insert(key.end(), column.begin(), column.end());
      const RowPointers found = rows_at(request_.rows, axes, key);
      rows.push_back(found.empty() ? nullptr : found.front());
      pictures.push_back(picture_of(rows.back()));
    }
    std::vector<AlignedLine> lines = shows_sketches()       ? side_by_side(pictures)
                                     : shows_new_sketches() ? one_by_one(pictures)
                                                            : aligned_classes(pictures);
    if (lines.empty()) lines.emplace_back(columns.size());
    WireGroup group;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      group.lines.emplace_back();
      for (std::size_t column = 0; column < columns.size(); ++column)
        group.lines.back().push_back(cell(lines[i][column], rows[column], pictures[column], i == 0));
    }
    return group;
  }

  WireCell cell(const std::optional<std::size_t>& figure, const Row* row, const FigurePicture* picture,
                bool is_first) const {
    if (figure) return {.figure = wireframe_at(*picture, *figure), .caption = caption_of(*picture, *figure)};
    if (picture != nullptr)
      return {.figure = {}, .words = picture->figures.empty() && is_first ? "no figure" : "–"};
    if (!is_first) return {};
    std::string words = row == nullptr ? "no such job" : outcome_word(*row);
    if (row != nullptr && !row->reason.empty()) words += ": " + row->reason;
    return {.figure = {}, .words = words};
  }

  std::string caption_of(const FigurePicture& picture, std::size_t figure) const {
    if (shows_sketches()) return "";
    if (!shows_new_sketches()) return solutions_text(picture.figures[figure]);
    return figure == 0 ? "the solution" : picture.new_sketches[figure - 1].origin;
  }

  WireTableStyle style() const {
    WireTableStyle style;
    style.width = width_from(request_.options);
    style.names = request_.options.flag("names");
    style.values = request_.options.flag("parameters");
    style.dimensions = request_.options.flag("dimensions");
    style.view = view_from(request_);
    return style;
  }

  const FigureRequest& request_;
  std::vector<std::string> row_axes_, column_axes_;
  std::map<const Row*, FigurePicture> pictures_;
};

}  // namespace

FigureKind figures_kind() {
  return {"figures",
          "the figures of solved constraint systems: one panel a figure up to isometry, one column a column "
          "key",
          {{.name = "names", .meaning = "write the names of points and objects", .default_value = true},
           {.name = "parameters",
            .meaning = "in the plane, write them at edges, angles and objects",
            .default_value = true},
           {.name = "dimensions", .meaning = "write them in space too", .default_value = false},
           choice_option("show",
                         "the figures that are solutions, the sketch of a method that has one, or the first "
                         "solution with the new sketches that a plan makes of it",
                         "solutions", {"solutions", "sketch", "new_sketches"}),
           integer_option("per_line", "with one column, at most", "", 1, 1, 12),
           view_option("best"),
           width_option("page")},
          [](const FigureRequest& request) { return FiguresKind(request).draw(); }};
}

}  // namespace gcslab
