#include "packing/random_triangulation.h"

#include "base/random.h"

namespace gcslab {

Triangulation random_triangulation(const RandomTriangulationOptions& options) {
  Random random(options.seed, "random_triangulation");
  Triangulation graph;
  for (int i = 0; i < options.inner_vertices; ++i) {
    const std::vector<Face> faces = graph.faces();
    graph.insert_vertex(faces[random.below(faces.size())]);
  }
  for (int i = 0; i < options.flips; ++i) {
    const std::vector<Edge> edges = graph.edges();
    static_cast<void>(graph.flip(edges[random.below(edges.size())]));
  }
  return graph;
}

}  // namespace gcslab
