#pragma once

// Random Apollonian networks with the exact places of their discs.
//
// Oracle: for four mutually tangent circles of curvatures a, b, c, d and centres w, x, y, z (complex numbers)
// the other circle that is tangent to the first three has curvature d' = 2(a + b + c) - d and centre z' with
// d' z' = 2(a w + b x + c y) - d z (Descartes 1643; Lagarias, Mallows, Wilks 2002). The outer discs of radii
// 1, 2, 3 lie in the circle of radius 6 around (3, 4), curvature -1/6. So all numbers are rational.

#include <array>
#include <map>
#include <vector>

#include "base/random.h"
#include "packing/packing_system.h"

namespace gcslab {

/// Curvature, and curvature times centre.
struct Curvature {
  Rational k, kx, ky;

  static Curvature of(const RationalDisc& disc) {
    const Rational k = 1 / disc.radius;
    return {k, k * disc.x, k * disc.y};
  }
  RationalDisc disc() const { return {kx / k, ky / k, 1 / k}; }
};

struct ApollonianNetwork {
  Triangulation graph;
  std::vector<RationalDisc> discs;

  ApollonianNetwork(int inner_vertices, std::uint64_t seed) {
    Random random(seed, "apollonian_network_test");
    std::vector<Curvature> circles;
    for (const RationalDisc& disc : standard_outer_discs()) circles.push_back(Curvature::of(disc));
    std::map<Face, Curvature> beyond;  // of each face: the other circle that touches its three
    beyond[Face{0, 1, 2}] = {Rational(-1, 6), Rational(-3, 6), Rational(-4, 6)};
    for (int i = 0; i < inner_vertices; ++i) {
      const std::vector<Face> faces = graph.faces();
      const Face face = faces[random.below(faces.size())];
      circles.push_back(other(circles, face, beyond.at(face)));
      graph.insert_vertex(face);
      const int w = graph.vertices() - 1;
      // The new vertex has the largest number: the smallest one of each new face stays first.
      for (std::size_t j = 0; j < 3; ++j) {
        const int u = face[j], v = face[(j + 1) % 3], t = face[(j + 2) % 3];
        const Face part = u < v ? Face{u, v, w} : Face{v, w, u};
        beyond[part] = circles[static_cast<std::size_t>(t)];
      }
    }
    for (const Curvature& circle : circles) discs.push_back(circle.disc());
  }

 private:
  static Curvature other(const std::vector<Curvature>& circles, const Face& face, const Curvature& fourth) {
    Curvature result = {-fourth.k, -fourth.kx, -fourth.ky};
    for (const int v : face) {
      const Curvature& c = circles[static_cast<std::size_t>(v)];
      result.k += 2 * c.k;
      result.kx += 2 * c.kx;
      result.ky += 2 * c.ky;
    }
    return result;
  }
};

}  // namespace gcslab
