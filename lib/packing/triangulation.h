#pragma once

// Triangulations of a triangle: simple planar graphs all of whose faces, the outer one included, are
// triangles.
//
// Vertices are numbers from 0; the outer face is 0, 1, 2, which stand counterclockwise around all others.
// With N vertices there are 3N - 6 edges and 2N - 5 inner faces (Euler 1758). Being simple with N >= 4, the
// graph is 3-connected, so that its faces do not depend on how it is drawn (Whitney 1932).

#include <array>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace gcslab {

/// Two vertices, the smaller one first.
using Edge = std::pair<int, int>;
/// Three vertices, counterclockwise.
using Face = std::array<int, 3>;

class Triangulation {
 public:
  /// The triangle alone.
  Triangulation();

  /// The triangulation with these edges; nothing when the graph is no triangulation or 0, 1, 2 is no face of
  /// it. Edges are given once each.
  static std::optional<Triangulation> of_graph(int vertices, std::span<const Edge> edges);

  int vertices() const { return vertices_; }
  /// Vertices beside the outer three; they have the numbers from 3 on.
  int inner_vertices() const { return vertices_ - 3; }
  /// In ascending order.
  std::vector<Edge> edges() const;
  /// The inner faces, each from its smallest vertex on, in ascending order.
  std::vector<Face> faces() const;
  bool has_edge(int u, int v) const { return third_.contains({u, v}); }
  /// The third vertex of the face on the left of the edge from u to v.
  int left_of(int u, int v) const;

  /// Puts the next vertex into an inner face and joins it to the corners.
  void insert_vertex(const Face& face);
  /// Replaces an edge by the other diagonal of its two faces. False, and nothing done, when the edge is an
  /// outer one or the diagonal is an edge already.
  bool flip(Edge edge);

 private:
  void add_face(int u, int v, int w);
  bool is_closed() const;

  int vertices_ = 3;
  std::map<std::pair<int, int>, int> third_;  ///< left_of; the outer face is 0, 2, 1
};

inline bool is_outer(int vertex) { return vertex < 3; }
inline bool is_outer(const Edge& edge) { return is_outer(edge.first) && is_outer(edge.second); }

}  // namespace gcslab
