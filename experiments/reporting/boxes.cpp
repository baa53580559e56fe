// Figure kind boxes: one panel a search, with all boxes that it took.

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "experiments/reporting/box_drawing.h"
#include "experiments/reporting/figure_registry.h"
#include "experiments/reporting/panel_grid.h"

namespace gcslab {
namespace {

class BoxPanels final : public PanelGrid {
 public:
  using PanelGrid::PanelGrid;

 private:
  BoxStyle chosen_style() const {
    BoxStyle style;
    style.fills = request_.options.flag("fills");
    style.variables = {static_cast<std::size_t>(request_.options.integer("across")),
                       static_cast<std::size_t>(request_.options.integer("upwards"))};
    return style;
  }

  Box domain_of(const Row& row) override {
    if (!row.artifact.is_object()) {
      fail("the rows hold no boxes of " + row.at("problem") +
           "; kind boxes is for the task solve with `parameters: {recorded_boxes: 10000}`, on systems in two "
           "or three unknowns with a bounded box");
    }
    try {
      pictures_.emplace(&row, search_picture_from_json(row.artifact));
    } catch (const InputError& error) {
      fail(row.at("problem") + ": " + error.what());
    }
    const SearchPicture& picture = pictures_.at(&row);
    const auto [across, upwards] = chosen_style().variables;
    if (across == upwards || std::max(across, upwards) >= picture.domain.size()) {
      fail(fmt::format("{} has {} unknowns; across and upwards must be two different ones, by number from 0",
                       row.at("problem"), picture.domain.size()));
    }
    left_out_ = left_out_ || picture.told > picture.boxes.size();
    is_projected_ = is_projected_ || picture.domain.size() > 2;
    return shown_domain(picture, chosen_style());
  }

  void draw_panel(const Row& row, const PanelBox& panel, bool vertical_tics) override {
    BoxStyle look = chosen_style();
    look.vertical_tics = vertical_tics;
    draw_boxes(figure_, panel, pictures_.at(&row), curves_of(row.at("problem")), look, place_text(row));
  }

  std::string counts_text(const Row& row, double room) const override {
    return box_counts_text(pictures_.at(&row), room);
  }

  const ProblemCurves& curves_of(const std::string& problem) {
    const auto known = curves_.find(problem);
    if (known != curves_.end()) return known->second;
    const bool wanted = request_.context.curve && request_.options.flag("curves");
    return curves_[problem] = wanted ? request_.context.curve(problem) : ProblemCurves{};
  }

  std::vector<std::string> leading_notes() const override {
    return {box_colours_text(request_.options.flag("fills") && !is_projected_,
                             request_.options.flag("curves") && !is_projected_)};
  }

  std::vector<std::string> closing_notes() const override {
    std::vector<std::string> notes;
    if (shows_counts())
      notes.emplace_back("Below each panel: boxes taken, rounds of contraction, certified roots.");
    if (is_projected_) notes.emplace_back("Boxes in three unknowns are seen along one axis.");
    if (left_out_) notes.emplace_back("Of long searches only the first boxes are drawn.");
    return notes;
  }

  std::map<const Row*, SearchPicture> pictures_;
  std::map<std::string, ProblemCurves> curves_;
  bool left_out_ = false;
  bool is_projected_ = false;
};

OptionSpec unknown_option(const char* name, const char* meaning, std::int64_t number) {
  return {.name = name, .meaning = meaning, .default_value = number, .minimum = 0, .maximum = 2};
}

}  // namespace

FigureKind boxes_kind() {
  return {
      "boxes",
      "all boxes of searches in two or three unknowns: one line of panels a row key, one panel a column "
      "key",
      {{.name = "fills", .meaning = "colour each part by how it was settled", .default_value = true},
       {.name = "curves", .meaning = "draw the curves of the equations", .default_value = true},
       {.name = "counts", .meaning = "print the numbers of boxes below each panel", .default_value = true},
       unknown_option("across", "the unknown that is drawn across, by number from 0", 0),
       unknown_option("upwards", "the unknown that is drawn upwards", 1),
       panels_per_line_option(),
       width_option("page")},
      [](const FigureRequest& request) { return BoxPanels(request).draw(); }};
}

}  // namespace gcslab
