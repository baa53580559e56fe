// Paths of sketches: what they cross are solutions, and of the octahedron those that its box solver's proof
// has.

#include "homotopy/path_tracker.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "base/random.h"
#include "geometry/constraint_system_reader.h"
#include "geometry/sketch.h"
#include "support/error_text.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

struct Figured {
  ConstraintSystem system;
  Frame frame;
  GeometricEquations equations;
};

Figured corpus_figure(const std::string& name) {
  const YamlNode file =
      YamlNode::load_file(std::string(GCSLAB_SOURCE_DIR) + "/data/polyhedra/" + name + ".yaml");
  Figured result{read_constraint_system(file), {}, {}};
  result.frame = frame_of(result.system);
  result.equations = geometric_equations(result.system, result.frame);
  return result;
}

std::vector<double> unknowns_of(const Figured& figured, const Figure& figure) {
  return unknowns_of(figured.equations, in_frame(figured.system, figured.frame, figure));
}

std::vector<double> wanted_of(const Figured& figured) { return values_of(figured.system.valuation("")); }

std::vector<std::vector<double>> distances_of(const Figured& figured,
                                              const std::vector<Crossing>& crossings) {
  std::vector<std::vector<double>> classes;
  for (const Crossing& crossing : crossings) {
    const Figure figure = figure_at(figured.equations, crossing.unknowns);
    std::vector<double> distances;
    for (std::size_t p = 0; p < figure.size(); ++p) {
      for (std::size_t q = 0; q < p; ++q) {
        double sum = 0;
        for (std::size_t axis = 0; axis < figure[p].size(); ++axis)
          sum += std::pow(figure[p][axis] - figure[q][axis], 2);
        distances.push_back(std::sqrt(sum));
      }
    }
    const auto is_same = [&](const std::vector<double>& other) {
      for (std::size_t i = 0; i < other.size(); ++i) {
        if (std::abs(other[i] - distances[i]) > 1e-6) return false;
      }
      return true;
    };
    if (std::ranges::none_of(classes, is_same)) classes.push_back(distances);
  }
  return classes;
}

TEST(SketchPath, OfTheOctahedronCrossesItsFiguresAndReturns) {
  const Figured octahedron = corpus_figure("octahedron");
  std::size_t most = 0;
  for (std::size_t seed = 0; seed < fuzz_cases(100); ++seed) {
    ConstraintSystem drawn = octahedron.system;
    drawn.random_sketch = seed;
    const Figure sketch = *sketch_of(drawn);
    Homotopy homotopy(octahedron.equations,
                      linear_path(parameters_of(octahedron.system, sketch), wanted_of(octahedron)));
    const SketchPath path = follow_sketch(homotopy, unknowns_of(octahedron, sketch), {});
    EXPECT_EQ(path.end, PathEnd::cycle) << "seed " << seed;
    EXPECT_EQ(path.crossings.size() % 2, 0U) << "seed " << seed;  // a closed curve
    for (const Crossing& crossing : path.crossings) ASSERT_LT(crossing.residual, 1e-12) << "seed " << seed;
    const std::size_t classes = distances_of(octahedron, path.crossings).size();
    EXPECT_LE(classes, 4U) << "seed " << seed;  // by the box solver's proof
    most = std::max(most, classes);
  }
  EXPECT_EQ(most, 4U);
}

TEST(SketchPath, OfASingularSketchIsRefusedWithTheReason) {
  const Figured octahedron = corpus_figure("octahedron");
  Figure flat(6, std::vector<double>(3, 0.0));
  Random random(fuzz_seed(), "flat sketch");
  for (auto& point : flat) {
    for (std::size_t axis = 0; axis < 2; ++axis) point[axis] = random.uniform(-1, 1);
  }
  Homotopy homotopy(octahedron.equations,
                    linear_path(parameters_of(octahedron.system, flat), wanted_of(octahedron)));
  EXPECT_NE(error_text([&] { follow_sketch(homotopy, unknowns_of(octahedron, flat), {}); }).find("singular"),
            std::string::npos);
}

TEST(Homotopy, HasTheDerivativesThatDifferencesShow) {
  const Figured pentahedron = corpus_figure("pentahedron");
  Random random(fuzz_seed(), "homotopy");
  for (const bool is_compact : {false, true}) {
    std::vector<double> sketch;
    for (std::size_t p = 0; p < pentahedron.system.parameters.size(); ++p)
      sketch.push_back(random.uniform(0.5, 2));
    const std::vector<double> wanted = wanted_of(pentahedron);
    Homotopy homotopy(pentahedron.equations,
                      is_compact ? compact_support_path(sketch, wanted, 3) : linear_path(sketch, wanted));
    const std::size_t m = homotopy.size();
    for (std::size_t n = 0; n < fuzz_cases(20); ++n) {
      std::vector<double> v(m + 1), values(m), above(m), below(m);
      for (double& x : v) x = random.uniform(-1, 1);
      Matrix<double> derivatives(m, m + 1);
      ASSERT_TRUE(homotopy.jacobian(v, values, derivatives));
      for (std::size_t j = 0; j <= m; ++j) {
        const double h = 1e-6, x = v[j];
        v[j] = x + h;
        ASSERT_TRUE(homotopy.values(v, above));
        v[j] = x - h;
        ASSERT_TRUE(homotopy.values(v, below));
        v[j] = x;
        for (std::size_t k = 0; k < m; ++k)
          ASSERT_NEAR(derivatives(k, j), (above[k] - below[k]) / (2 * h), 1e-7);
      }
    }
  }
}

TEST(ParameterPath, GoesFromTheSketchToWhatIsWanted) {
  const std::vector<double> sketch = {1, 2.5, 0.1}, wanted = {3, 0.3, 0.7};
  for (const auto& path : {linear_path(sketch, wanted), compact_support_path(sketch, wanted, 1)}) {
    std::vector<double> values(3), derivatives(3), other(3), unused(3);
    path->at(0, values, derivatives);
    EXPECT_EQ(values, sketch);
    path->at(1, values, derivatives);
    EXPECT_EQ(values, wanted);
    for (const double t : {-2.0, 0.3, 1.7}) {
      path->at(t, values, derivatives);
      path->at(t + 1e-6, other, unused);
      for (std::size_t p = 0; p < 3; ++p) EXPECT_NEAR(derivatives[p], (other[p] - values[p]) / 1e-6, 1e-5);
    }
  }
  std::vector<double> values(3), derivatives(3);
  for (const double t : {-5.0, 6.0}) {
    compact_support_path(sketch, wanted, 1)->at(t, values, derivatives);
    EXPECT_LT(values[1], 0);  // a length that no figure has
  }
}

}  // namespace
}  // namespace gcslab
