// Figure kind plan_graph: construction plans as graphs, one panel a job.

#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "base/error.h"
#include "experiments/reporting/figure_registry.h"
#include "experiments/reporting/layered_layout.h"
#include "experiments/reporting/palette.h"
#include "experiments/reporting/path_rows.h"
#include "experiments/solving/plan_diagram.h"

namespace gcslab {
namespace {

constexpr double kMargin = 1;
constexpr double kTitleHeight = 6;
constexpr double kPanelGap = 8;
constexpr double kTextHeight = 3.2;  // of a line of small text
constexpr double kArrowLength = 1.5, kArrowWidth = 1.2;
constexpr std::string_view kRemovedColour = "#808080";

enum class NodeKind { point, sphere, guide, locus, removed };

struct PlanNode {
  NodeKind kind;
  std::string text;
  bool is_choice = false;
};

struct PlanEdge {
  NodeKind kind;
  bool has_arrow;
};

/// Points on even layers, the loci of each on the layer above it, what is removed below all.
struct PlanGraph {
  std::vector<PlanNode> nodes;
  std::vector<LayeredNode> boxes;
  std::vector<PlanEdge> looks;
  std::vector<LayeredEdge> edges;

  std::size_t add_node(PlanNode node, std::size_t layer) {
    const bool is_boxed = node.kind != NodeKind::sphere;
    boxes.push_back({layer, text_width(node.text) + (is_boxed ? 3 : 1), kTextHeight + (is_boxed ? 2 : 0.6)});
    nodes.push_back(std::move(node));
    return nodes.size() - 1;
  }
  void add_edge(std::size_t from, std::size_t to, PlanEdge look) {
    edges.push_back({from, to});
    looks.push_back(look);
  }
};

NodeKind kind_of(const PlanDiagram::Locus& locus) {
  if (locus.is_guide) return NodeKind::guide;
  return locus.kind == "sphere" ? NodeKind::sphere : NodeKind::locus;
}

/// The radius of a sphere; of other loci also what they are.
std::string locus_text(const PlanDiagram::Locus& locus) {
  if (locus.kind == "sphere") return locus.value;
  return locus.kind + (locus.value.empty() ? "" : " " + locus.value);
}

std::string removed_text(const PlanDiagram::Locus& constraint) {
  std::string text = constraint.kind;
  for (const std::string& name : constraint.of) text += " " + name;
  return text + (constraint.value.empty() ? "" : " = " + constraint.value);
}

PlanGraph graph_of(const PlanDiagram& plan) {
  PlanGraph graph;
  std::map<std::string, std::size_t> node_of;
  std::size_t lowest = 0;
  for (std::size_t k = 0; k < plan.steps.size(); ++k) {
    const PlanDiagram::Step& step = plan.steps[k];
    std::size_t layer = 0;
    for (const PlanDiagram::Locus& locus : step.loci) {
      for (const std::string& name : locus.of)
        layer = std::max(layer, graph.boxes[node_of.at(name)].layer + 2);
    }
    lowest = std::max(lowest, layer);
    const std::size_t point =
        graph.add_node({NodeKind::point, fmt::format("{} ({})", step.object, k + 1), step.places > 1}, layer);
    node_of[step.object] = point;
    for (const PlanDiagram::Locus& locus : step.loci) {
      const NodeKind kind = kind_of(locus);
      const std::size_t node = graph.add_node({kind, locus_text(locus)}, layer - 1);
      for (const std::string& name : locus.of) graph.add_edge(node_of.at(name), node, {kind, false});
      graph.add_edge(node, point, {kind, true});
    }
  }
  for (const PlanDiagram::Locus& constraint : plan.removed) {
    const std::size_t node = graph.add_node({NodeKind::removed, removed_text(constraint)}, lowest + 2);
    for (const std::string& name : constraint.of)
      graph.add_edge(node_of.at(name), node, {NodeKind::removed, false});
  }
  return graph;
}

struct Panel {
  std::string title;
  PlanGraph graph;
  LayeredLayout layout;

  double width() const { return std::max(layout.width, text_width(title, kTitleText)); }
};

/// Layers are numbered without those that are empty.
LayeredLayout layout_of(PlanGraph& graph) {
  std::map<std::size_t, std::size_t> number;
  for (const LayeredNode& box : graph.boxes) number[box.layer] = 0;
  std::size_t count = 0;
  for (auto& [layer, k] : number) k = count++;
  for (LayeredNode& box : graph.boxes) box.layer = number.at(box.layer);
  return layered_layout(graph.boxes, graph.edges);
}

class PlanGraphFigure {
 public:
  explicit PlanGraphFigure(const FigureRequest& request) : request_(request) {}

  FigureScript draw() {
    for (const Row* row : request_.rows) {
      if (row->has_result()) panels_.push_back(panel_of(*row));
    }
    if (panels_.empty()) fail("no job has a plan to draw");
    lay_out();
    for (std::size_t k = 0; k < panels_.size(); ++k) add(panels_[k], corners_[k]);
    finish();
    return std::move(script_);
  }

 private:
  struct Corner {
    double x, y;  ///< lower left
  };

  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(request_.item.where, "'" + request_.item.file + "': " + message);
  }

  Panel panel_of(const Row& row) const {
    if (!row.artifact.is_object() || !row.artifact.contains("plan"))
      fail("the rows hold no plan of " + place_text(row) + "; it needs a method that constructs by one");
    try {
      PlanGraph graph = graph_of(plan_diagram_from_json(row.artifact.at("plan")));
      LayeredLayout layout = layout_of(graph);
      return {name_of_row(row, request_.rows), std::move(graph), std::move(layout)};
    } catch (const InputError& error) {
      fail(place_text(row) + ": " + error.what());
    }
  }

  /// Panels side by side while they fit, those of a line with their tops at one height; a plan that is wider
  /// than the page makes the figure wider.
  void lay_out() {
    script_.width = width_from(request_.options);
    for (const Panel& panel : panels_) script_.width = std::max(script_.width, panel.width() + 2 * kMargin);
    corners_.resize(panels_.size());
    const bool has_titles = panels_.size() > 1;
    double depth = 0;
    for (std::size_t first = 0; first < panels_.size();) {
      double used = -kPanelGap, tallest = 0;
      std::size_t last = first;
      for (; last < panels_.size(); ++last) {
        const double width = used + kPanelGap + panels_[last].width();
        if (last > first && width + 2 * kMargin > script_.width) break;
        used = width;
        tallest = std::max(tallest, panels_[last].layout.height);
      }
      const double room = (script_.width - used) / static_cast<double>(last - first + 1);
      double x = room;
      depth += (first > 0 ? kPanelGap : kMargin) + (has_titles ? kTitleHeight : 0);
      for (std::size_t k = first; k < last; ++k) {
        const Panel& panel = panels_[k];
        corners_[k] = {x + (panel.width() - panel.layout.width) / 2, -depth - panel.layout.height};
        x += panel.width() + kPanelGap + (room - kPanelGap > 0 && last - first > 1 ? room - kPanelGap : 0);
      }
      depth += tallest;
      first = last;
    }
    script_.height = depth + kMargin;
    for (Corner& corner : corners_) corner.y += script_.height;
  }

  void add(const Panel& panel, const Corner& corner) {
    const LayeredLayout& layout = panel.layout;
    if (panels_.size() > 1)
      script_.text(corner.x + layout.width / 2, corner.y + layout.height + kTitleHeight / 2, panel.title,
                   {"center", kTitleText});
    for (std::size_t e = 0; e < layout.routes.size(); ++e)
      add_route(layout.routes[e], panel.graph.looks[e], corner);
    for (std::size_t v = 0; v < layout.places.size(); ++v) {
      const LayeredLayout::Place& place = layout.places[v];
      add_node(panel.graph.nodes[v], panel.graph.boxes[v], {corner.x + place.x, corner.y + place.y});
    }
  }

  void add_route(const std::vector<std::array<double, 2>>& route, const PlanEdge& look,
                 const Corner& corner) {
    const auto end = route.back();
    const double x = corner.x + end[0], y = corner.y + end[1];
    std::string& lines = routes_[look.kind];
    for (const auto& point : route) {
      const bool is_last = &point == &route.back();
      lines += line_of(corner.x + point[0],
                       corner.y + point[1] + (is_last && look.has_arrow ? kArrowLength / 2 : 0));
    }
    lines += "\n";
    if (!look.has_arrow) return;
    arrows_[look.kind] += line_of(x, y) + line_of(x - kArrowWidth / 2, y + kArrowLength) +
                          line_of(x + kArrowWidth / 2, y + kArrowLength) + line_of(x, y) + "\n";
  }

  void add_node(const PlanNode& node, const LayeredNode& box, const Corner& middle) {
    if (node.kind != NodeKind::sphere) boxes_[node.kind] += outline(box, middle, 0);
    if (node.is_choice) inner_boxes_ += outline(box, middle, 0.6);
    const std::string_view colour = node.kind == NodeKind::guide     ? palette::kVermillion
                                    : node.kind == NodeKind::removed ? palette::kQuietText
                                                                     : palette::kText;
    script_.text(middle.x, middle.y, node.text, {"center", kSmallText, colour});
  }

  static std::string line_of(double x, double y) { return plot_number(x) + " " + plot_number(y) + "\n"; }

  static std::string outline(const LayeredNode& box, const Corner& middle, double inset) {
    const double w = box.width / 2 - inset, h = box.height / 2 - inset;
    return line_of(middle.x - w, middle.y - h) + line_of(middle.x + w, middle.y - h) +
           line_of(middle.x + w, middle.y + h) + line_of(middle.x - w, middle.y + h) +
           line_of(middle.x - w, middle.y - h) + "\n";
  }

  struct Look {
    std::string_view colour, fill;
    double line_width;
    std::string_view dash;
  };
  static Look look_of(NodeKind kind) {
    switch (kind) {
      case NodeKind::point:
        return {palette::kBlack, "#EAF2F8", 0.9, "1"};
      case NodeKind::guide:
        return {palette::kVermillion, "#FBEBDD", 0.9, "1"};
      case NodeKind::locus:
        return {palette::kFrame, "#F4F4F4", 0.5, "1"};
      case NodeKind::removed:
        return {kRemovedColour, "#FFFFFF", 0.5, "(10,6)"};
      case NodeKind::sphere:
        break;
    }
    return {palette::kFrame, "", 0.6, "1"};
  }

  void add_layer(const std::string& comment, const std::string& lines, const std::string& with) {
    const std::size_t block = script_.add_data(comment, lines);
    layers_ += fmt::format(", \\\n  data index {} using 1:2 with {}", block, with);
  }

  void finish() {
    for (const auto& [kind, lines] : routes_) {
      const Look look = look_of(kind);
      add_layer("edges", lines,
                fmt::format("lines lw {} dt {} lc rgb '{}'", look.line_width, look.dash, look.colour));
    }
    for (const auto& [kind, lines] : arrows_)
      add_layer("arrow heads", lines,
                fmt::format("filledcurves closed fs solid 1 noborder lc rgb '{}'", look_of(kind).colour));
    for (const auto& [kind, lines] : boxes_) {
      const Look look = look_of(kind);
      add_layer("boxes", lines,
                fmt::format("filledcurves closed fs solid 1 noborder lc rgb '{}'", look.fill));
      add_layer("borders", lines,
                fmt::format("lines lw {} dt {} lc rgb '{}'", look.line_width, look.dash, look.colour));
    }
    if (!inner_boxes_.empty()) add_layer("choices", inner_boxes_, "lines lw 0.4 lc rgb '#000000'");
    script_.place({0, 0, script_.width, script_.height});
    script_.command(fmt::format("set xrange [0:{}]; set yrange [0:{}]", script_.width, script_.height));
    script_.command("unset border; unset tics; unset key");
    script_.command("plot " + layers_.substr(2));
    add_notes();
  }

  void add_notes() {
    const auto has = [&](NodeKind kind) { return boxes_.contains(kind); };
    script_.notes.emplace_back(
        "Boxes: the points in the order of their construction; arrows lead to a point from those that its "
        "loci are about, a number on an arrow is the radius of the sphere around the point that it comes "
        "from.");
    if (!inner_boxes_.empty())
      script_.notes.emplace_back("Double border: two places, of which the branch of the plan takes one.");
    if (has(NodeKind::guide)) script_.notes.emplace_back("Framed radii: guide parameters.");
    if (has(NodeKind::removed))
      script_.notes.emplace_back("Dashed: the removed constraints, which the guides are to satisfy.");
    for (std::string& note : notes_on_missing(request_.rows)) script_.notes.push_back(std::move(note));
  }

  const FigureRequest& request_;
  FigureScript script_;
  std::vector<Panel> panels_;
  std::vector<Corner> corners_;
  std::map<NodeKind, std::string> routes_, arrows_, boxes_;
  std::string inner_boxes_, layers_;
};

}  // namespace

FigureKind plan_graph_kind() {
  return {"plan_graph",
          "construction plans as layered graphs, one panel a job of a method that constructs by one",
          {width_option("column")},
          [](const FigureRequest& request) { return PlanGraphFigure(request).draw(); }};
}

}  // namespace gcslab
