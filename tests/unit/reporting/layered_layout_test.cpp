// Layered drawings: boxes apart, lines that lead down and pass by the boxes, fewest crossings in small cases.

#include "experiments/reporting/layered_layout.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "base/random.h"

namespace gcslab {
namespace {

struct Graph {
  std::vector<LayeredNode> nodes;
  std::vector<LayeredEdge> edges;
};

/// Nodes of random sizes on some layers, each with edges from some above it.
Graph random_graph(std::uint64_t seed) {
  Random random(seed, "layered_layout_test");
  Graph graph;
  const std::size_t count = 3 + random.below(25);
  std::size_t layer = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (k > 0 && random.below(2) == 0) ++layer;
    graph.nodes.push_back(
        {layer, 3 + static_cast<double>(random.below(30)), 2 + static_cast<double>(random.below(5))});
    for (int e = 0; e < 3 && k > 0; ++e) {
      const std::size_t from = random.below(k);
      const bool is_new = std::ranges::none_of(
          graph.edges, [&](const LayeredEdge& edge) { return edge.from == from && edge.to == k; });
      if (graph.nodes[from].layer < layer && is_new) graph.edges.push_back({from, k});
    }
  }
  return graph;
}

void expect_apart(const Graph& graph, const LayeredLayout& layout) {
  for (std::size_t a = 0; a < graph.nodes.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const double dx = std::abs(layout.places[a].x - layout.places[b].x);
      const double dy = std::abs(layout.places[a].y - layout.places[b].y);
      const bool is_beside = dx > (graph.nodes[a].width + graph.nodes[b].width) / 2 + 1;
      const bool is_above = dy > (graph.nodes[a].height + graph.nodes[b].height) / 2 + 1;
      EXPECT_TRUE(is_beside || is_above) << "nodes " << a << " and " << b;
    }
  }
}

void expect_downwards(const Graph& graph, const LayeredLayout& layout) {
  ASSERT_EQ(layout.routes.size(), graph.edges.size());
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const auto& route = layout.routes[e];
    for (std::size_t i = 1; i < route.size(); ++i) EXPECT_LE(route[i][1], route[i - 1][1] + 1e-9) << "edge " << e;
    const LayeredNode &from = graph.nodes[graph.edges[e].from], &to = graph.nodes[graph.edges[e].to];
    const auto &start = layout.places[graph.edges[e].from], &end = layout.places[graph.edges[e].to];
    EXPECT_NEAR(route.front()[1], start.y - from.height / 2, 1e-9);
    EXPECT_NEAR(route.back()[1], end.y + to.height / 2, 1e-9);
    EXPECT_LE(std::abs(route.front()[0] - start.x), from.width / 2);
    EXPECT_LE(std::abs(route.back()[0] - end.x), to.width / 2);
  }
}

void expect_past_boxes(const Graph& graph, const LayeredLayout& layout) {
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    for (std::size_t v = 0; v < graph.nodes.size(); ++v) {
      if (v == graph.edges[e].from || v == graph.edges[e].to) continue;
      for (const auto& point : layout.routes[e]) {
        EXPECT_TRUE(std::abs(point[0] - layout.places[v].x) > graph.nodes[v].width / 2 ||
                    std::abs(point[1] - layout.places[v].y) > graph.nodes[v].height / 2)
            << "edge " << e << " through node " << v;
      }
    }
  }
}

TEST(LayeredLayout, KeepsBoxesApartAndLinesDownwardsPastThem) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Graph graph = random_graph(seed);
    const LayeredLayout layout = layered_layout(graph.nodes, graph.edges);
    expect_apart(graph, layout);
    expect_downwards(graph, layout);
    expect_past_boxes(graph, layout);
    for (std::size_t v = 0; v < graph.nodes.size(); ++v) {
      EXPECT_GE(layout.places[v].x - graph.nodes[v].width / 2, -1e-9);
      EXPECT_LE(layout.places[v].x + graph.nodes[v].width / 2, layout.width + 1e-9);
      EXPECT_LE(layout.places[v].y + graph.nodes[v].height / 2, layout.height + 1e-9);
    }
  }
}

/// Given crosswise, two stars can be drawn without a crossing.
TEST(LayeredLayout, UntanglesCrossedEdges) {
  const Graph graph = {{{0, 4, 4}, {0, 4, 4}, {1, 4, 4}, {1, 4, 4}, {1, 4, 4}, {1, 4, 4}},
                       {{0, 4}, {0, 5}, {1, 2}, {1, 3}}};
  const LayeredLayout layout = layered_layout(graph.nodes, graph.edges);
  const auto x = [&](std::size_t v) { return layout.places[v].x; };
  const bool is_first_left = x(0) < x(1);
  for (const std::size_t a : {4U, 5U}) {
    for (const std::size_t b : {2U, 3U}) EXPECT_EQ(x(a) < x(b), is_first_left);
  }
}

TEST(LayeredLayout, PutsANodeOverItsOnlyOne) {
  const Graph graph = {{{0, 4, 4}, {1, 4, 4}, {1, 4, 4}, {2, 4, 4}}, {{0, 1}, {0, 2}, {1, 3}}};
  const LayeredLayout layout = layered_layout(graph.nodes, graph.edges);
  EXPECT_NEAR(layout.places[1].x, layout.places[3].x, 0.1);
  EXPECT_NEAR(layout.places[0].x, (layout.places[1].x + layout.places[2].x) / 2, 0.6);
  EXPECT_GT(layout.places[0].y, layout.places[1].y);
  EXPECT_EQ(layout.places[1].y, layout.places[2].y);
}

}  // namespace
}  // namespace gcslab
