#include "experiments/reporting/layered_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/check.h"

namespace gcslab {
namespace {

using Line = std::vector<std::array<double, 2>>;

constexpr int kPieces = 16;  // of a line from layer to layer

/// A node, or where an edge passes a layer.
struct Vertex {
  std::size_t layer;
  double width, height;
  bool is_bend;
  std::vector<std::size_t> above{}, below{};
  double x = 0;
};

/// Values in order with gaps[k] at least between numbers k and k + 1, whose weighted squared distance to the
/// wishes is least (pool adjacent violators: Barlow et al. 1972).
std::vector<double> spread_out(std::vector<double> wishes, const std::vector<double>& weights,
                               const std::vector<double>& gaps) {
  struct Pool {
    double mean, weight;
    std::size_t size;
  };
  std::vector<double> shifts(wishes.size(), 0.0);
  for (std::size_t k = 1; k < wishes.size(); ++k) shifts[k] = shifts[k - 1] + gaps[k - 1];
  std::vector<Pool> pools;
  for (std::size_t k = 0; k < wishes.size(); ++k) {
    pools.push_back({wishes[k] - shifts[k], weights[k], 1});
    while (pools.size() > 1 && pools[pools.size() - 2].mean > pools.back().mean) {
      const Pool last = pools.back();
      pools.pop_back();
      Pool& pool = pools.back();
      pool.mean = (pool.mean * pool.weight + last.mean * last.weight) / (pool.weight + last.weight);
      pool.weight += last.weight;
      pool.size += last.size;
    }
  }
  std::size_t k = 0;
  for (const Pool& pool : pools) {
    for (std::size_t i = 0; i < pool.size; ++i, ++k) wishes[k] = pool.mean + shifts[k];
  }
  return wishes;
}

class Layout {
 public:
  Layout(const std::vector<LayeredNode>& nodes, const std::vector<LayeredEdge>& edges,
         const LayeredGaps& gaps)
      : gaps_(gaps), nodes_(nodes.size()) {
    for (const LayeredNode& node : nodes) vertices_.push_back({node.layer, node.width, node.height, false});
    for (const LayeredEdge& edge : edges) add(edge);
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      const std::size_t layer = vertices_[v].layer;
      if (layer >= layers_.size()) layers_.resize(layer + 1);
      layers_[layer].push_back(v);
    }
  }

  LayeredLayout made() {
    order();
    place_across();
    place_upright();
    LayeredLayout result;
    result.width = width_;
    result.height = tops_.empty() ? 0 : tops_.front();
    for (std::size_t v = 0; v < nodes_; ++v)
      result.places.push_back({vertices_[v].x, middle(vertices_[v].layer)});
    for (std::size_t e = 0; e < chains_.size(); ++e) result.routes.push_back(route(e));
    return result;
  }

 private:
  using Layers = std::vector<std::vector<std::size_t>>;

  void add(const LayeredEdge& edge) {
    GCSLAB_CHECK(vertices_[edge.from].layer < vertices_[edge.to].layer);
    std::vector<std::size_t> chain = {edge.from};
    for (std::size_t layer = vertices_[edge.from].layer + 1; layer < vertices_[edge.to].layer; ++layer) {
      chain.push_back(vertices_.size());
      vertices_.push_back({layer, 0, 0, true});
    }
    chain.push_back(edge.to);
    for (std::size_t k = 1; k < chain.size(); ++k) {
      vertices_[chain[k - 1]].below.push_back(chain[k]);
      vertices_[chain[k]].above.push_back(chain[k - 1]);
    }
    chains_.push_back(std::move(chain));
  }

  // ---- the order in each layer ----

  std::vector<std::size_t> ranks() const {
    std::vector<std::size_t> result(vertices_.size());
    for (const auto& layer : layers_) {
      for (std::size_t k = 0; k < layer.size(); ++k) result[layer[k]] = k;
    }
    return result;
  }

  /// Of the lines from two neighbours of a layer to another layer, when `left` stands left.
  static std::size_t crossings_of(const std::vector<std::size_t>& left, const std::vector<std::size_t>& right,
                                  const std::vector<std::size_t>& rank) {
    std::size_t count = 0;
    for (const std::size_t a : left) {
      for (const std::size_t b : right) count += rank[a] > rank[b] ? 1U : 0U;
    }
    return count;
  }

  std::size_t crossings() const {
    const std::vector<std::size_t> rank = ranks();
    std::size_t count = 0;
    for (const auto& layer : layers_) {
      for (std::size_t i = 0; i < layer.size(); ++i) {
        for (std::size_t j = i + 1; j < layer.size(); ++j)
          count += crossings_of(vertices_[layer[i]].below, vertices_[layer[j]].below, rank);
      }
    }
    return count;
  }

  void order() {
    constexpr int kSweeps = 40;
    Layers best = layers_;
    std::size_t fewest = crossings();
    for (int sweep = 0; sweep < kSweeps && fewest > 0; ++sweep) {
      const bool is_down = sweep % 2 == 0;
      for (std::size_t k = 0; k < layers_.size(); ++k)
        sort_by_neighbours(is_down ? k : layers_.size() - 1 - k, is_down);
      exchange_neighbours();
      const std::size_t count = crossings();
      if (count >= fewest) continue;
      fewest = count;
      best = layers_;
    }
    layers_ = best;
  }

  void sort_by_neighbours(std::size_t layer, bool is_down) {
    const std::vector<std::size_t> rank = ranks();
    const auto mean = [&](std::size_t v) {
      const auto& others = is_down ? vertices_[v].above : vertices_[v].below;
      if (others.empty()) return static_cast<double>(rank[v]);
      double sum = 0;
      for (const std::size_t other : others) sum += static_cast<double>(rank[other]);
      return sum / static_cast<double>(others.size());
    };
    std::ranges::stable_sort(layers_[layer], {}, mean);
  }

  void exchange_neighbours() {
    constexpr int kRounds = 10;
    std::vector<std::size_t> rank = ranks();
    for (int round = 0; round < kRounds; ++round) {
      bool is_better = false;
      for (auto& layer : layers_) {
        for (std::size_t k = 0; k + 1 < layer.size(); ++k) {
          const Vertex &a = vertices_[layer[k]], &b = vertices_[layer[k + 1]];
          const std::size_t now = crossings_of(a.above, b.above, rank) + crossings_of(a.below, b.below, rank);
          const std::size_t then =
              crossings_of(b.above, a.above, rank) + crossings_of(b.below, a.below, rank);
          if (then >= now) continue;
          std::swap(layer[k], layer[k + 1]);
          std::swap(rank[layer[k]], rank[layer[k + 1]]);
          is_better = true;
        }
      }
      if (!is_better) return;
    }
  }

  // ---- places ----

  /// Long edges are to be straight, so bends pull most.
  static double weight(const Vertex& a, const Vertex& b) {
    if (a.is_bend && b.is_bend) return 8;
    return a.is_bend || b.is_bend ? 2 : 1;
  }

  double gap(const Vertex& left, const Vertex& right) const {
    const double between = left.is_bend || right.is_bend ? gaps_.lines : gaps_.nodes;
    return (left.width + right.width) / 2 + between;
  }

  void place_layer(const std::vector<std::size_t>& layer) {
    std::vector<double> wishes, weights, gaps;
    for (std::size_t k = 0; k < layer.size(); ++k) {
      const Vertex& vertex = vertices_[layer[k]];
      double sum = 0, total = 0;
      for (const auto* others : {&vertex.above, &vertex.below}) {
        for (const std::size_t other : *others) {
          const double w = weight(vertex, vertices_[other]);
          sum += w * vertices_[other].x;
          total += w;
        }
      }
      wishes.push_back(total > 0 ? sum / total : vertex.x);
      weights.push_back(std::max(total, 1e-3));
      if (k > 0) gaps.push_back(gap(vertices_[layer[k - 1]], vertex));
    }
    const std::vector<double> x = spread_out(std::move(wishes), weights, gaps);
    for (std::size_t k = 0; k < layer.size(); ++k) vertices_[layer[k]].x = x[k];
  }

  void place_across() {
    constexpr int kSweeps = 1000;
    for (const auto& layer : layers_) {
      for (std::size_t k = 1; k < layer.size(); ++k)
        vertices_[layer[k]].x = vertices_[layer[k - 1]].x + gap(vertices_[layer[k - 1]], vertices_[layer[k]]);
    }
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      for (std::size_t k = 0; k < layers_.size(); ++k)
        place_layer(layers_[sweep % 2 == 0 ? k : layers_.size() - 1 - k]);
    }
    double left = 0, right = 0;
    for (const Vertex& vertex : vertices_) {
      const bool is_first = &vertex == vertices_.data();
      left = is_first ? vertex.x - vertex.width / 2 : std::min(left, vertex.x - vertex.width / 2);
      right = is_first ? vertex.x + vertex.width / 2 : std::max(right, vertex.x + vertex.width / 2);
    }
    for (Vertex& vertex : vertices_) vertex.x -= left;
    width_ = right - left;
  }

  /// Layers are farther apart where lines between them go far to the side.
  void place_upright() {
    constexpr double kSlope = 0.12, kMost = 3;
    std::vector<double> reach(layers_.size(), 0.0), heights(layers_.size(), 0.0);
    for (const Vertex& vertex : vertices_) {
      heights[vertex.layer] = std::max(heights[vertex.layer], vertex.height);
      for (const std::size_t other : vertex.below)
        reach[vertex.layer] = std::max(reach[vertex.layer], std::abs(vertices_[other].x - vertex.x));
    }
    tops_.resize(layers_.size());
    bottoms_.resize(layers_.size());
    double y = 0;
    for (std::size_t k = layers_.size(); k-- > 0;) {
      bottoms_[k] = y;
      tops_[k] = y + heights[k];
      if (k > 0) y = tops_[k] + std::clamp(kSlope * reach[k - 1], gaps_.layers, kMost * gaps_.layers);
    }
  }

  double middle(std::size_t layer) const { return (tops_[layer] + bottoms_[layer]) / 2; }

  /// Where an edge leaves or enters a node: its edges share the side in the order of where they lead.
  double port(std::size_t v, std::size_t other, bool is_below) const {
    constexpr double kShare = 0.6, kWidest = 2;
    const Vertex& vertex = vertices_[v];
    if (vertex.is_bend) return vertex.x;
    std::vector<std::size_t> others = is_below ? vertex.below : vertex.above;
    std::ranges::sort(others, {}, [&](std::size_t o) { return vertices_[o].x; });
    const auto count = static_cast<double>(others.size());
    const auto number = static_cast<double>(std::ranges::find(others, other) - others.begin());
    const double step = std::min(kWidest, kShare * vertex.width / std::max(count - 1, 1.0));
    return vertex.x + (number - (count - 1) / 2) * step;
  }

  /// Smooth where that keeps off the nodes, otherwise upright across each layer.
  Line route(std::size_t edge) const {
    Line smooth = smooth_route(edge);
    return keeps_off(smooth, edge) ? smooth : upright_route(edge);
  }

  /// The middle of the sides that an edge leaves and enters, and its bends between them.
  Line knots(std::size_t edge) const {
    const std::vector<std::size_t>& chain = chains_[edge];
    const std::size_t from = chain.front(), to = chain.back();
    Line line = {{port(from, chain[1], true), middle(vertices_[from].layer) - vertices_[from].height / 2}};
    for (std::size_t k = 1; k + 1 < chain.size(); ++k)
      line.push_back({vertices_[chain[k]].x, middle(vertices_[chain[k]].layer)});
    line.push_back(
        {port(to, chain[chain.size() - 2], false), middle(vertices_[to].layer) + vertices_[to].height / 2});
    return line;
  }

  /// A curve over y through the knots that turns back nowhere between them (Fritsch, Carlson 1980), upright
  /// at both ends.
  Line smooth_route(std::size_t edge) const {
    const Line points = knots(edge);
    const auto secant = [&](std::size_t k) {
      return (points[k + 1][0] - points[k][0]) / (points[k + 1][1] - points[k][1]);
    };
    std::vector<double> slopes(points.size(), 0.0);
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
      const double before = secant(k - 1), after = secant(k);
      if (before * after > 0) slopes[k] = 2 * before * after / (before + after);
    }
    Line line = {points.front()};
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      const double x0 = points[k][0], x1 = points[k + 1][0], y0 = points[k][1],
                   dy = points[k + 1][1] - points[k][1];
      for (int i = 1; i <= kPieces; ++i) {
        const double s = static_cast<double>(i) / kPieces, r = 1 - s;
        line.push_back({x0 * r * r * (1 + 2 * s) + x1 * s * s * (1 + 2 * r) +
                            dy * s * r * (slopes[k] * r - slopes[k + 1] * s),
                        y0 + s * dy});
      }
    }
    return line;
  }

  Line upright_route(std::size_t edge) const {
    const std::vector<std::size_t>& chain = chains_[edge];
    Line line;
    for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
      const Vertex &upper = vertices_[chain[k]], &lower = vertices_[chain[k + 1]];
      const double x0 = port(chain[k], chain[k + 1], true), x1 = port(chain[k + 1], chain[k], false);
      const double y0 = bottoms_[upper.layer], y1 = tops_[lower.layer];
      if (!upper.is_bend) line.push_back({x0, middle(upper.layer) - upper.height / 2});
      for (int i = 0; i <= kPieces; ++i) {
        const double s = static_cast<double>(i) / kPieces;
        line.push_back({x0 + (x1 - x0) * s * s * (3 - 2 * s), y0 + (y1 - y0) * s});
      }
      if (!lower.is_bend) line.push_back({x1, middle(lower.layer) + lower.height / 2});
    }
    return line;
  }

  bool keeps_off(const Line& line, std::size_t edge) const {
    const double distance = gaps_.lines / 3;
    for (std::size_t v = 0; v < nodes_; ++v) {
      if (v == chains_[edge].front() || v == chains_[edge].back()) continue;
      const Vertex& node = vertices_[v];
      const double y = middle(node.layer);
      for (const auto& point : line) {
        if (std::abs(point[0] - node.x) < node.width / 2 + distance &&
            std::abs(point[1] - y) < node.height / 2 + distance)
          return false;
      }
    }
    return true;
  }

  LayeredGaps gaps_;
  std::size_t nodes_;
  std::vector<Vertex> vertices_;  ///< the nodes first
  std::vector<std::vector<std::size_t>> chains_;
  Layers layers_;
  std::vector<double> tops_, bottoms_;
  double width_ = 0;
};

}  // namespace

LayeredLayout layered_layout(const std::vector<LayeredNode>& nodes, const std::vector<LayeredEdge>& edges,
                             const LayeredGaps& gaps) {
  return Layout(nodes, edges, gaps).made();
}

}  // namespace gcslab
