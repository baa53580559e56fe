#include "covering/cover.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "covering/curve_trace.h"
#include "enclosure/bound_registry.h"
#include "expression/parser.h"

namespace gcslab {
namespace {

const std::vector<std::string> kVariables = {"x", "y"};

SetBounds bounds_of(const std::vector<std::string>& equations, const std::string& name = "bernstein",
                    const std::vector<std::string>& inequalities = {}) {
  auto graph = std::make_shared<ExpressionGraph>();
  const BoundVariant& variant = bound_registry().at(name);
  const auto bound = [&](Expression function) {
    return variant.make(BoundTarget(graph, function, 2), Options(variant.options, {}, name));
  };
  SetBounds set;
  for (const std::string& text : equations)
    set.equations.push_back(bound(parse_equation(*graph, text, kVariables)));
  for (const std::string& text : inequalities) {
    set.inequalities.push_back(bound(parse_inequality(*graph, text, kVariables)));
  }
  return set;
}

TEST(Cover, DiagonalKeepsTheCellsThatTouchIt) {
  // The line x = y through 2^k x 2^k cells: the diagonal ones, and their neighbours that share a corner with
  // it.
  const Cover found = cover(bounds_of({"x - y"}), {{0, 1}, {0, 1}}, {3, Split::all});
  EXPECT_EQ(found.tree.kept_cells(), 8u + 2u * 7u);
  EXPECT_EQ(found.tree.visited_per_level(), (std::vector<std::uint64_t>{1, 4, 16, 40}));
  EXPECT_EQ(found.tree.visited_cells(), 61u);
  EXPECT_TRUE(found.undecided.empty());
}

TEST(Cover, AlternateSplitsKeepTheSameCells) {
  for (const char* curve : {"x^3 + y^3 - 3*x*y", "x - y", "x^2 + y^2 - 1"}) {
    const Box box = {{-2, 2}, {-2, 2}};
    const Cover all = cover(bounds_of({curve}, "exact"), box, {5, Split::all});
    const Cover alternate = cover(bounds_of({curve}, "exact"), box, {5, Split::alternate});
    EXPECT_EQ(all.tree.kept_cells(), alternate.tree.kept_cells()) << curve;
  }
}

TEST(Cover, TwoEquationsKeepTheCellsOfBoth) {
  const Cover found = cover(bounds_of({"x - y", "x + y - 1"}), {{0, 1}, {0, 1}}, {4, Split::all});
  EXPECT_EQ(found.tree.kept_cells(), 4u);  // the four cells around (1/2, 1/2)
}

TEST(Cover, InequalitiesDropCellsWhereTheyFail) {
  const Box box = {{-2, 2}, {-2, 2}};
  for (const char* name : {"natural", "bernstein", "exact"}) {
    const Cover whole = cover(bounds_of({"x^2 + y^2 = 1"}, name), box, {5, Split::all});
    const Cover half = cover(bounds_of({"x^2 + y^2 = 1"}, name, {"x <= 0"}), box, {5, Split::all});
    EXPECT_LT(half.tree.kept_cells(), whole.tree.kept_cells());
    half.tree.for_each_leaf([](const CoverLeaf& leaf) { EXPECT_TRUE(!leaf.kept || leaf.box[0].lower <= 0); });
  }
}

TEST(Cover, AnEmptySetLeavesNoCell) {
  const Cover found = cover(bounds_of({"x^2 + y^2 + 3"}), {{-1, 1}, {-1, 1}}, {8, Split::all});
  EXPECT_EQ(found.tree.kept_cells(), 0u);
  EXPECT_EQ(found.tree.visited_cells(), 1u);
}

TEST(Cover, ManySplitsOfTheExactBoundDoNotExhaustTheStack) {
  auto graph = std::make_shared<ExpressionGraph>();
  const BoundTarget target(graph, parse_expression(*graph, "(x - 1/3)^2 + (y - 1/3)^2", kVariables), 2);
  const BoundVariant& exact = bound_registry().at("exact");
  SetBounds set;
  set.equations.push_back(exact.make(target, Options(exact.options, {{"splits", "200000"}}, "exact")));
  EXPECT_GE(cover(set, {{0, 1}, {0, 1}}, {1, Split::all}).tree.kept_cells(), 1u);
}

TEST(Cover, AStopLeavesUndecidedBoxes) {
  std::stop_source source;
  source.request_stop();
  const Cover found = cover(bounds_of({"x - y"}), {{0, 1}, {0, 1}}, {8, Split::all}, source.get_token());
  EXPECT_EQ(found.undecided, (std::vector<Box>{{{0, 1}, {0, 1}}}));
  EXPECT_TRUE(found.tree.is_truncated());
}

TEST(Cover, AnUnboundedBoxIsAnInputError) {
  EXPECT_THROW(cover(bounds_of({"x - y"}, "natural"), {Interval::entire(), {0, 1}}, {2, Split::all}),
               InputError);
}

TEST(Cover, DepthForACellSize) {
  EXPECT_EQ(depth_for_cell_size({{0, 4}, {0, 1}}, 1), 2);
  EXPECT_EQ(depth_for_cell_size({{0, 4}}, 0.9), 3);
  EXPECT_EQ(depth_for_cell_size({{0, 4}}, 5), 0);
  EXPECT_THROW(depth_for_cell_size({{0, 4}}, 0), InputError);
}

TEST(CoverTree, JsonRoundTrips) {
  const Cover found = cover(bounds_of({"x^2 + y^2 - 1"}), {{-2, 2}, {-2, 2}}, {5, Split::alternate});
  const CoverTree again = CoverTree::from_json(found.tree.to_json());
  EXPECT_EQ(again.to_json(), found.tree.to_json());
  EXPECT_EQ(again.kept_cells(), found.tree.kept_cells());
}

TEST(CoverTree, DamagedJsonIsAnInputError) {
  nlohmann::json json = cover(bounds_of({"x - y"}), {{0, 1}, {0, 1}}, {3, Split::all}).tree.to_json();
  nlohmann::json cut = json, longer = json, letters = json;
  cut["cells"] = cut["cells"].get<int>() - 1;
  longer["cells"] = longer["cells"].get<int>() + 100;
  letters["tree"] = "?";
  EXPECT_THROW(static_cast<void>(CoverTree::from_json(cut).kept_cells()), InputError);
  EXPECT_THROW(static_cast<void>(CoverTree::from_json(longer)), InputError);
  EXPECT_THROW(static_cast<void>(CoverTree::from_json(letters)), InputError);
  EXPECT_THROW(static_cast<void>(CoverTree::from_json(nlohmann::json::object())), InputError);
}

TEST(CurveTrace, ACircleIsOneClosedLineOnTheCircle) {
  ExpressionGraph graph;
  const auto lines =
      trace_curve(parse_expression(graph, "x^2 + y^2 - 1", kVariables), {{-2, 2}, {-2, 2}}, 100);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].front(), lines[0].back());
  for (const auto& [x, y] : lines[0]) EXPECT_NEAR(x * x + y * y, 1, 1e-3);
}

}  // namespace
}  // namespace gcslab
