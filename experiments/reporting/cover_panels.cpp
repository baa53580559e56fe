// Figure kind cover_panels: one panel a problem and method, with the cells that the method kept.

#include <map>
#include <nlohmann/json.hpp>

#include "experiments/reporting/cover_drawing.h"
#include "experiments/reporting/figure_registry.h"
#include "experiments/reporting/number_format.h"
#include "experiments/reporting/panel_grid.h"

namespace gcslab {
namespace {

class CoverPanels final : public PanelGrid {
 public:
  using PanelGrid::PanelGrid;

 private:
  Box domain_of(const Row& row) override {
    if (!row.artifact.is_object()) fail("the rows hold no covers; cover_panels is for the task cover");
    const CoverTree& tree =
        trees_.emplace(&row, CoverTree::from_json(nlohmann::json(row.artifact))).first->second;
    if (tree.domain().size() != 2)
      fail(row.at("problem") + " has not two variables; leave it out by a filter");
    return tree.domain();
  }

  void draw_panel(const Row& row, const PanelBox& panel, bool vertical_tics) override {
    CoverStyle style;
    style.visited = request_.options.flag("visited");
    style.curve = request_.options.flag("curve");
    style.vertical_tics = vertical_tics;
    draw_cover(figure_, panel, trees_.at(&row),
               style.curve ? curve_of(row.at("problem")) : std::vector<Polyline>{}, style, place_text(row));
  }

  std::string counts_text(const Row& row, double room) const override {
    const CoverTree& tree = trees_.at(&row);
    const auto count = [&row](const char* name, std::uint64_t otherwise) {
      return format_count(row.values.contains(name) && row.values.at(name).is_number()
                              ? row.values.at(name).get<double>()
                              : static_cast<double>(otherwise));
    };
    const std::string kept = count("kept_cells", tree.kept_cells());
    const std::string visited = count("visited_cells", tree.visited_cells());
    const std::string words = "kept " + kept + " of " + visited + " visited";
    return text_width(words) <= room ? words : kept + " of " + visited;
  }

  const std::vector<Polyline>& curve_of(const std::string& problem) {
    const auto known = curves_.find(problem);
    if (known != curves_.end()) return known->second;
    const ProblemCurves curves = request_.context.curve ? request_.context.curve(problem) : ProblemCurves{};
    return curves_[problem] = first_curve(curves);
  }

  std::vector<std::string> leading_notes() const override {
    std::string key = "Orange: cells kept";
    if (request_.options.flag("visited")) key += "; grey: borders of the cells that were visited and dropped";
    if (request_.options.flag("curve")) key += "; black: the curve";
    return {key + "."};
  }

  std::vector<std::string> closing_notes() const override {
    if (!shows_counts()) return {};
    return {"Below each panel: cells kept of cells visited."};
  }

  std::map<const Row*, CoverTree> trees_;
  std::map<std::string, std::vector<Polyline>> curves_;
};

}  // namespace

FigureKind cover_panels_kind() {
  return {
      "cover_panels",
      "the cells that covers kept: one line of panels a row key, one panel a column key",
      {{.name = "visited",
        .meaning = "outline the cells that were visited and dropped",
        .default_value = true},
       {.name = "curve", .meaning = "draw the true curve over the cells", .default_value = true},
       {.name = "counts", .meaning = "print the numbers of cells below each panel", .default_value = true},
       panels_per_line_option(),
       width_option("page")},
      [](const FigureRequest& request) { return CoverPanels(request).draw(); }};
}

}  // namespace gcslab
