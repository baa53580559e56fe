// Figures that are the same up to isometry.

#include "geometry/congruence.h"

#include <cmath>
#include <gtest/gtest.h>

#include "base/random.h"
#include "geometry/constraint_system.h"
#include "geometry/sketch.h"
#include "support/fuzz.h"
#include "unit/geometry/isometry.h"

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

const std::vector<Sort> kPoints(5, Sort::point);

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
    ASSERT_EQ(congruence_classes(kPoints, Universe::space, figures), expected);
  }
}

/// Which sorts a figure has, and where.
struct Kind {
  Universe universe;
  std::vector<Sort> sorts;
};

std::vector<Kind> kinds() {
  constexpr Sort P = Sort::point, L = Sort::line, E = Sort::plane, C = Sort::circle, S = Sort::sphere;
  return {{Universe::plane, {P, P, L, L, C}}, {Universe::plane, {L, L, L, C, C}},
          {Universe::space, {P, P, L, L, E}}, {Universe::space, {P, L, L, L, C}},
          {Universe::space, {P, E, E, C, S}}, {Universe::space, {L, L, E, E, S}}};
}

Figure random_figure(const Kind& kind, Random& random) {
  ConstraintSystem system;
  system.universe = kind.universe;
  for (const Sort sort : kind.sorts) system.objects.push_back({"O", sort});
  system.random_sketch = random.next() >> 1;
  return *sketch_of(system);
}

TEST(CongruenceClasses, OfObjectsOfEverySortDoNotSeeTheSignsOfDirections) {
  Random random(fuzz_seed(), "congruence of objects");
  for (const Kind& kind : kinds()) {
    for (std::size_t n = 0; n < fuzz_cases(30); ++n) {
      const std::vector<Figure> originals = {random_figure(kind, random), random_figure(kind, random)};
      std::vector<FigureBox> figures;
      std::vector<std::vector<std::size_t>> expected(2);
      for (std::size_t f = 0; f < 8; ++f) {
        const std::size_t which = f < 2 ? f : random.below(2);
        figures.push_back(boxed(randomly_moved(kind.sorts, kind.universe, originals[which], random), 1e-12));
        expected[which].push_back(f);
      }
      ASSERT_EQ(congruence_classes(kind.sorts, kind.universe, figures), expected);
    }
  }
}

/// One object moved alone, by a rotation about another place.
TEST(CongruenceClasses, TellFiguresApartInWhichOneObjectIsElsewhere) {
  Random random(fuzz_seed(), "congruence of other figures");
  for (const Kind& kind : kinds()) {
    for (std::size_t n = 0; n < fuzz_cases(30); ++n) {
      const Figure figure = random_figure(kind, random);
      for (std::size_t k = 0; k < figure.size(); ++k) {
        Figure other = figure;
        other[k] = randomly_moved({kind.sorts[k]}, kind.universe, {figure[k]}, random)[0];
        ASSERT_EQ(
            congruence_classes(kind.sorts, kind.universe, {boxed(figure, 1e-12), boxed(other, 1e-12)}).size(),
            2U);
      }
    }
  }
}

/// Three lines through a point with the same angles between each two: along the edges of an acute corner, or
/// one of them on the other side. No pair tells the two apart.
TEST(CongruenceClasses, SeeTheProductOfThreeSigns) {
  const std::vector<Sort> sorts = {Sort::point, Sort::line, Sort::line, Sort::line};
  const auto corner = [](double c) {  // cosines c, c, and c or -c
    const double s = std::sqrt(1 - c * c);
    return [=](double sign) {
      const double y = (sign * c - c * c) / s;
      return Figure{
          {0, 0, 0}, {0, 0, 0, 1, 0, 0}, {0, 0, 0, c, s, 0}, {0, 0, 0, c, y, std::sqrt(1 - c * c - y * y)}};
    };
  }(0.3);
  EXPECT_EQ(
      congruence_classes(sorts, Universe::space, {boxed(corner(1), 1e-9), boxed(corner(-1), 1e-9)}).size(),
      2U);
}

TEST(CongruenceClasses, TellFiguresThatDifferInOneDistanceApart) {
  const std::vector<Sort> sorts(4, Sort::point);
  const Figure figure = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Figure other = figure;
  other[3][2] = 1.001;
  const auto classes = [&](double radius) {
    return congruence_classes(sorts, Universe::space, {boxed(figure, radius), boxed(other, radius)}).size();
  };
  EXPECT_EQ(classes(1e-6), 2U);
  EXPECT_EQ(classes(1e-2), 1U);  // boxes cannot tell
  EXPECT_TRUE(congruence_classes({}, Universe::space, {}).empty());
}

}  // namespace
}  // namespace gcslab
