#pragma once

// Layered drawings of acyclic graphs: nodes in horizontal layers, edges from layer to layer downwards, with
// few crossings (Sugiyama, Tagawa, Toda 1981).

#include <array>
#include <cstddef>
#include <vector>

namespace gcslab {

struct LayeredNode {
  std::size_t layer;  ///< 0: the highest
  double width, height;
};

/// From a node to one of a lower layer.
struct LayeredEdge {
  std::size_t from, to;
};

struct LayeredGaps {
  double nodes = 2.5, lines = 2, layers = 4;
};

/// Lengths as those of the nodes; y grows upwards from 0, x to the right from 0.
struct LayeredLayout {
  struct Place {
    double x, y;  ///< of the middle
  };
  std::vector<Place> places;                               ///< of the nodes
  std::vector<std::vector<std::array<double, 2>>> routes;  ///< of the edges, from node to node, never upwards
  double width = 0, height = 0;
};

/// Promise: nodes do not overlap, routes pass by the nodes that they do not end at, and never lead upwards.
LayeredLayout layered_layout(const std::vector<LayeredNode>& nodes, const std::vector<LayeredEdge>& edges,
                             const LayeredGaps& gaps = {});

}  // namespace gcslab
