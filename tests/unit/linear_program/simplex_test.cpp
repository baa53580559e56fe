// Our own simplex method: the edges stay an inverse, and hard polytopes are solved to full accuracy.

#include "linear_program/simplex.h"

#include <cmath>
#include <gtest/gtest.h>

#include "base/random.h"
#include "experiments/microbenchmarks/bernstein_polytope.h"
#include "linear_program/edge_matrix.h"
#include "linear_program/exact_basis.h"
#include "linear_program/safe_bound.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

/// A matrix of normals beside the edges that are to be its inverse.
class Normals {
 public:
  explicit Normals(std::size_t size) : rows_(size, std::vector<double>(size, 0.0)) {
    for (std::size_t j = 0; j < size; ++j) rows_[j][j] = 1;
    edges_.reset(size);
  }
  /// A random normal takes the slot that it can take with least growth of the edges.
  void exchange_random(Random& random) {
    const std::size_t size = rows_.size();
    std::vector<double> normal(size, 0.0);
    std::vector<int> columns;
    std::vector<double> values;
    for (std::size_t j = 0; j < size; ++j) {
      if (random.below(2) == 0) continue;
      normal[j] = random.uniform(-1, 1);
      columns.push_back(static_cast<int>(j));
      values.push_back(normal[j]);
    }
    std::vector<double> along(edges_.stride());
    std::vector<double> edge(edges_.stride());
    edges_.along_edges(columns, values, along.data());
    std::size_t slot = 0;
    for (std::size_t t = 1; t < size; ++t) {
      if (std::abs(along[t]) > std::abs(along[slot])) slot = t;
    }
    if (std::abs(along[slot]) < 0.1) return;
    edges_.copy_edge(slot, edge.data());
    edges_.exchange(slot, along.data(), edge.data());
    rows_[slot] = normal;
    ++exchanges_;
  }
  int exchanges() const { return exchanges_; }
  /// The largest error of normals * edges = 1 and of the squared lengths.
  double error() const {
    double largest = 0;
    const std::size_t size = rows_.size();
    for (std::size_t t = 0; t < size; ++t) {
      double squared_length = 0;
      for (std::size_t i = 0; i < size; ++i) {
        double product = i == t ? -1 : 0;
        for (std::size_t j = 0; j < size; ++j) product += rows_[i][j] * edges_.coordinate(j)[t];
        largest = std::max(largest, std::abs(product));
        squared_length += edges_.coordinate(i)[t] * edges_.coordinate(i)[t];
      }
      largest = std::max(largest, std::abs(squared_length - edges_.squared_length(t)) / squared_length);
    }
    return largest;
  }

 private:
  int exchanges_ = 0;
  std::vector<std::vector<double>> rows_;
  EdgeMatrix edges_;
};

TEST(EdgeMatrix, StaysTheInverseOfTheNormals) {
  Random random(fuzz_seed(), "edges");
  for (const std::size_t size : {1U, 2U, 3U, 4U, 5U, 9U, 17U}) {
    Normals normals(size);
    for (int i = 0; i < 60; ++i) normals.exchange_random(random);
    EXPECT_GT(normals.exchanges(), 10);
    EXPECT_LT(normals.error(), 1e-8) << size;
  }
}

TEST(Simplex, FinalBasesOfBernsteinPolytopesAreExactlyOptimalOrAsGood) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const RandomBernsteinPolytope polytope(5, 0.2, seed);
    Simplex simplex({});
    simplex.load(polytope.model());
    for (int column = 0; column < 5; ++column) {
      for (const double sign : {1.0, -1.0}) {
        const LinearTerm objective{column, sign};
        LpSolution solution;
        simplex.minimise({&objective, 1}, solution);
        ASSERT_EQ(solution.status, LpStatus::optimal);
        const ExactVertex vertex = exact_vertex(polytope.model(), {&objective, 1}, solution.basis);
        ASSERT_TRUE(vertex.is_vertex);
        EXPECT_NEAR(nearest_double(vertex.objective), solution.objective, 1e-11);
        EXPECT_NEAR(safe_lower_bound(polytope.model(), {&objective, 1}, solution.multipliers),
                    solution.objective, 1e-11);
      }
    }
  }
}

TEST(Simplex, WarmAndColdFindTheSameBoundsFromBoxToBox) {
  RandomBernsteinPolytope polytope(8, 0.3, 5);
  Simplex warm({});
  Simplex cold({true});
  for (int box = 0; box < 4; ++box) {
    warm.load(polytope.model());
    cold.load(polytope.model());
    for (int column = 0; column < 8; ++column) {
      const LinearTerm objective{column, 1.0};
      LpSolution by_warm, by_cold;
      warm.minimise({&objective, 1}, by_warm);
      cold.minimise({&objective, 1}, by_cold);
      ASSERT_EQ(by_warm.status, LpStatus::optimal);
      ASSERT_EQ(by_cold.status, LpStatus::optimal);
      EXPECT_NEAR(by_warm.objective, by_cold.objective, 1e-9);
    }
    polytope.move_box(0.2);
  }
}

TEST(Simplex, ReportsTheIterationLimit) {
  const RandomBernsteinPolytope polytope(6, 0.2, 1);
  Simplex simplex({false, 3});
  simplex.load(polytope.model());
  const LinearTerm objective{0, 1.0};
  LpSolution solution;
  simplex.minimise({&objective, 1}, solution);
  EXPECT_EQ(solution.status, LpStatus::iteration_limit);
}

}  // namespace
}  // namespace gcslab
