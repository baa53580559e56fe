// Plans as JSON and as graphs on paper.

#include <gtest/gtest.h>

#include "experiments/reporting/figure.h"
#include "experiments/solving/plan_diagram.h"
#include "support/error_text.h"
#include "unit/reporting/sample_rows.h"

namespace gcslab {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

PlanDiagram sample_plan() {
  PlanDiagram plan;
  plan.steps = {{"A", 1, {}},
                {"B", 1, {{"sphere", {"A"}, "h0"}}},
                {"C", 2, {{"sphere", {"A"}, "k0", true}, {"coplanar", {"A", "B"}}}}};
  plan.removed = {{"distance", {"B", "C"}, "h1"}};
  return plan;
}

Row plan_row(const std::string& method, const PlanDiagram& plan) {
  Row row = sample_row("p", method, 1, 1);
  row.artifact = {{"plan", to_json(plan)}};
  return row;
}

FigureScript drawn(std::vector<Row> rows) {
  ReportItem item = sample_item("f", {}, {}, {});
  item.form = ReportItem::Form::figure;
  item.kind = "plan_graph";
  return draw_figure(item, sample_context(std::move(rows)));
}

TEST(PlanDiagram, SurvivesItsJson) {
  const Json json = to_json(sample_plan());
  EXPECT_EQ(to_json(plan_diagram_from_json(json)), json);
  EXPECT_EQ(json["steps"][2]["places"], 2);
  EXPECT_EQ(json["steps"][2]["loci"][0],
            (Json{{"kind", "sphere"}, {"of", {"A"}}, {"value", "k0"}, {"guide", true}}));
  EXPECT_FALSE(json["steps"][2]["loci"][1].contains("guide"));
  EXPECT_EQ(json["removed_constraints"][0]["of"], (Json{"B", "C"}));
}

TEST(PlanDiagram, IsRefusedWhereItIsNotTriangular) {
  PlanDiagram plan = sample_plan();
  std::swap(plan.steps[1], plan.steps[2]);
  EXPECT_TRUE(
      has(error_text([&] { plan_diagram_from_json(to_json(plan)); }), "uses B, which no step before"));
  plan = sample_plan();
  plan.steps.push_back(plan.steps[0]);
  EXPECT_TRUE(has(error_text([&] { plan_diagram_from_json(to_json(plan)); }), "places A twice"));
  EXPECT_TRUE(has(error_text([] { plan_diagram_from_json(Json::object()); }), "not as it should be"));
}

TEST(PlanGraph, NamesPointsRadiiGuidesAndWhatIsRemoved) {
  const FigureScript figure = drawn({plan_row("plan of m", sample_plan())});
  for (const char* text : {"A (1)", "B (2)", "C (3)", "h0", "k0", "coplanar", "distance B C = h1"})
    EXPECT_TRUE(has(figure.commands(), text)) << text;
  std::string notes;
  for (const std::string& note : figure.notes) notes += note;
  for (const char* part : {"Double border", "guide parameters", "removed constraints"})
    EXPECT_TRUE(has(notes, part)) << part;
}

TEST(PlanGraph, PutsPlansSideBySideWithTheirNames) {
  const FigureScript one = drawn({plan_row("plan of m", sample_plan())});
  const FigureScript two =
      drawn({plan_row("plan of m", sample_plan()), plan_row("plan of n", sample_plan())});
  EXPECT_FALSE(has(one.commands(), "plan of m"));
  EXPECT_TRUE(has(two.commands(), "plan of m") && has(two.commands(), "plan of n"));
  EXPECT_GT(two.height, one.height);
  EXPECT_LE(two.width, kColumnWidth);
}

TEST(PlanGraph, SaysWhatItNeeds) {
  Row row = sample_row("p", "m", 1, 1);
  row.artifact = Json::object();
  EXPECT_TRUE(has(error_text([&] { drawn({row}); }), "needs a method that constructs"));
  EXPECT_TRUE(has(error_text([&] { drawn({with_outcome(row, "failed", "why")}); }), "no job has a plan"));
}

}  // namespace
}  // namespace gcslab
