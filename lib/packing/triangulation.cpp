#include "packing/triangulation.h"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>

#include "base/check.h"

namespace gcslab {
namespace {

using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                                    boost::property<boost::vertex_index_t, int>,
                                    boost::property<boost::edge_index_t, int>>;
using GraphEdge = boost::graph_traits<Graph>::edge_descriptor;

Graph graph_of(int vertices, std::span<const Edge> edges) {
  Graph graph(static_cast<std::size_t>(vertices));
  int number = 0;
  for (const auto& [u, v] : edges) {
    boost::add_edge(static_cast<std::size_t>(u), static_cast<std::size_t>(v),
                    boost::property<boost::edge_index_t, int>(number++), graph);
  }
  return graph;
}

/// The neighbours of each vertex in the order in which they stand around it, all in one sense of rotation
/// (Boyer, Myrvold 2004); empty when the graph is not planar.
std::vector<std::vector<int>> rotations(int vertices, std::span<const Edge> edges) {
  const Graph graph = graph_of(vertices, edges);
  std::vector<std::vector<GraphEdge>> around(static_cast<std::size_t>(vertices));
  namespace parameter = boost::boyer_myrvold_params;
  if (!boost::boyer_myrvold_planarity_test(parameter::graph = graph, parameter::embedding = around.data())) {
    return {};
  }
  std::vector<std::vector<int>> result(around.size());
  for (std::size_t v = 0; v < around.size(); ++v) {
    for (const GraphEdge& edge : around[v]) {
      const std::size_t source = boost::source(edge, graph);
      result[v].push_back(static_cast<int>(source == v ? boost::target(edge, graph) : source));
    }
  }
  return result;
}

}  // namespace

Triangulation::Triangulation() {
  add_face(0, 1, 2);
  add_face(0, 2, 1);
}

std::optional<Triangulation> Triangulation::of_graph(int vertices, std::span<const Edge> edges) {
  if (vertices < 4 || edges.size() != static_cast<std::size_t>(3 * vertices - 6)) return std::nullopt;
  const auto around = rotations(vertices, edges);
  if (around.empty()) return std::nullopt;
  for (const bool mirrored : {false, true}) {
    Triangulation result;
    result.vertices_ = vertices;
    result.third_.clear();
    for (std::size_t v = 0; v < around.size(); ++v) {
      for (std::size_t i = 0; i < around[v].size(); ++i) {
        const int a = around[v][i];
        const int b = around[v][(i + 1) % around[v].size()];
        result.third_[{static_cast<int>(v), mirrored ? b : a}] = mirrored ? a : b;
      }
    }
    const auto outer = result.third_.find({0, 2});
    if (result.is_closed() && outer != result.third_.end() && outer->second == 1) return result;
  }
  return std::nullopt;
}

/// Each face is the same from each of its edges, and each edge has two sides.
bool Triangulation::is_closed() const {
  return std::ranges::all_of(third_, [this](const auto& entry) {
    const auto [u, v] = entry.first;
    const auto next = third_.find({v, entry.second});
    return next != third_.end() && next->second == u && third_.contains({v, u});
  });
}

std::vector<Edge> Triangulation::edges() const {
  std::vector<Edge> result;
  for (const auto& [edge, third] : third_) {
    if (edge.first < edge.second) result.push_back(edge);
  }
  return result;
}

std::vector<Face> Triangulation::faces() const {
  std::vector<Face> result;
  for (const auto& [edge, third] : third_) {
    const auto [u, v] = edge;
    const bool is_outer_face = u == 0 && v == 2 && third == 1;
    if (u < v && u < third && !is_outer_face) result.push_back({u, v, third});
  }
  return result;
}

int Triangulation::left_of(int u, int v) const {
  const auto found = third_.find({u, v});
  GCSLAB_CHECK(found != third_.end());
  return found->second;
}

void Triangulation::add_face(int u, int v, int w) {
  third_[{u, v}] = w;
  third_[{v, w}] = u;
  third_[{w, u}] = v;
}

void Triangulation::insert_vertex(const Face& face) {
  GCSLAB_CHECK(left_of(face[0], face[1]) == face[2]);
  for (std::size_t i = 0; i < 3; ++i) add_face(face[i], face[(i + 1) % 3], vertices_);
  ++vertices_;
}

bool Triangulation::flip(Edge edge) {
  if (is_outer(edge)) return false;
  const auto [u, v] = edge;
  const int a = left_of(u, v);
  const int b = left_of(v, u);
  if (has_edge(a, b)) return false;
  third_.erase({u, v});
  third_.erase({v, u});
  add_face(u, b, a);
  add_face(b, v, a);
  return true;
}

}  // namespace gcslab
