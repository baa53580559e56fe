// Figures that are the same up to isometry.

#include "geometry/congruence.h"

#include <cmath>
#include <gtest/gtest.h>

#include "base/random.h"
#include "geometry/constraint_system.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

FigureBox boxed(const Figure& figure, double radius) {
  FigureBox result;
  for (const auto& point : figure) {
    result.emplace_back();
    for (const double x : point) result.back().emplace_back(x - radius, x + radius);
  }
  return result;
}

Figure turned_and_mirrored(Figure figure, double angle, bool is_mirrored) {
  for (auto& point : figure) {
    const double x = point[0], y = point[1];
    point[0] = std::cos(angle) * x - std::sin(angle) * y + 3;
    point[1] = std::sin(angle) * x + std::cos(angle) * y;
    if (is_mirrored) point[2] = -point[2];
  }
  return figure;
}

TEST(CongruenceClasses, AreThoseOfMovedAndMirroredFigures) {
  Random random(fuzz_seed(), "congruence");
  for (std::size_t n = 0; n < fuzz_cases(50); ++n) {
    std::vector<FigureBox> figures;
    std::vector<std::vector<std::size_t>> expected(3);
    std::vector<Figure> originals(3, Figure(5, std::vector<double>(3)));
    for (Figure& figure : originals) {
      for (auto& point : figure) {
        for (double& x : point) x = random.uniform(-1, 1);
      }
    }
    for (std::size_t f = 0; f < 12; ++f) {
      const std::size_t which = f < 3 ? f : random.below(3);
      figures.push_back(
          boxed(turned_and_mirrored(originals[which], random.uniform(0, 6), random.below(2) == 1), 1e-12));
      expected[which].push_back(f);
    }
    ASSERT_EQ(congruence_classes(figures), expected);
  }
}

TEST(CongruenceClasses, TellFiguresThatDifferInOneDistanceApart) {
  const Figure figure = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Figure other = figure;
  other[3][2] = 1.001;
  EXPECT_EQ(congruence_classes({boxed(figure, 1e-6), boxed(other, 1e-6)}).size(), 2U);
  EXPECT_EQ(congruence_classes({boxed(figure, 1e-2), boxed(other, 1e-2)}).size(), 1U);  // boxes cannot tell
  EXPECT_TRUE(congruence_classes({}).empty());
}

}  // namespace
}  // namespace gcslab
