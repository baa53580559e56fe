#include "linear_program/vertex_pool.h"

#include <algorithm>

namespace gcslab {
namespace {

constexpr std::size_t kMemory = std::size_t{32} << 20;

std::size_t capacity_for(const SimplexVertex& vertex) {
  const std::size_t bytes = vertex.slots() * vertex.edges().stride() * sizeof(double);
  return std::clamp<std::size_t>(kMemory / std::max<std::size_t>(bytes, 1), 4, 256);
}

}  // namespace

double cost_at(const SimplexVertex& vertex, std::span<const double> cost) {
  double total = 0;
  for (std::size_t j = 0; j < cost.size(); ++j) total += cost[j] * vertex.values()[j];
  return total;
}

void VertexPool::remember(const SimplexVertex& vertex) {
  const std::size_t capacity = capacity_for(vertex);
  if (next_ >= capacity) next_ = 0;
  if (next_ == vertices_.size()) vertices_.emplace_back();
  vertices_[next_++] = vertex;
  used_ = std::max(used_, next_);
}

const SimplexVertex* VertexPool::best(std::span<const double> cost, double below) const {
  const SimplexVertex* result = nullptr;
  for (std::size_t i = 0; i < used_; ++i) {
    const double value = cost_at(vertices_[i], cost);
    if (value >= below) continue;
    below = value;
    result = &vertices_[i];
  }
  return result;
}

}  // namespace gcslab
