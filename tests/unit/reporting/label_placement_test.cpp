// Texts in drawings: exact clipping, and places that are free where there is room.

#include "experiments/reporting/label_placement.h"

#include <cmath>
#include <gtest/gtest.h>

#include "experiments/reporting/figure_script.h"

namespace gcslab {
namespace {

const PaperBox kPage = {{0, 0}, 100, 100};

/// Around a text whose centre is given, a little smaller than the placer keeps free.
PaperBox text_box(const PaperPoint& centre, const std::string& text) {
  return {centre, text_width(text), 1.9};
}

TEST(PaperBox, MeasuresTheSegmentInside) {
  const PaperBox box = {{1, 2}, 4, 2};
  EXPECT_DOUBLE_EQ(box.length_inside({{-9, 2}, {9, 2}}), 4);
  EXPECT_DOUBLE_EQ(box.length_inside({{1, 2}, {1, 9}}), 1);
  EXPECT_DOUBLE_EQ(box.length_inside({{0, 1.5}, {0.3, 1.9}}), 0.5);
  EXPECT_DOUBLE_EQ(box.length_inside({{-9, 3.1}, {9, 3.1}}), 0);
  EXPECT_DOUBLE_EQ(box.length_inside({{4, 0}, {6, 4}}), 0);
  EXPECT_DOUBLE_EQ(box.length_inside({{0, 0}, {4, 4}}), 2 * std::sqrt(2));  // from (1, 1) to (3, 3)
}

TEST(LabelPlacer, FindsTheFreeSideOfAPoint) {
  std::vector<PaperSegment> lines;
  for (int degrees = 0; degrees <= 270; degrees += 15) {  // free: to the lower right
    const double angle = degrees * std::acos(-1) / 180;
    lines.push_back({{0, 0}, {20 * std::cos(angle), 20 * std::sin(angle)}});
  }
  LabelPlacer placer(kPage, lines, {{0, 0}});
  const PaperPoint place = placer.beside_point({0, 0}, {0, 0}, "P0");
  EXPECT_GT(place[0], 0);
  EXPECT_LT(place[1], 0);
  for (const PaperSegment& line : lines) EXPECT_EQ(text_box(place, "P0").length_inside(line), 0);
}

TEST(LabelPlacer, PrefersTheSideThatIsAskedFor) {
  LabelPlacer placer(kPage, {}, {{0, 0}, {10, 0}});
  EXPECT_GT(placer.beside_point({0, 0}, {0, 1}, "A")[1], 1);
  EXPECT_LT(placer.beside_point({10, 0}, {0, -1}, "B")[1], -1);
}

TEST(LabelPlacer, GoesOnIntoAnAngleUntilTheTextFits) {
  const std::vector<PaperSegment> arms = {{{0, 0}, {40, 0}}, {{0, 0}, {40, 20}}};
  LabelPlacer placer(kPage, arms, {{0, 0}});
  const PaperPoint place = placer.beyond_point({4, 1}, {4, 1}, "w = 27°");
  EXPECT_GT(place[1], 0);
  EXPECT_LT(place[1], place[0] / 2);  // between the arms
  for (const PaperSegment& arm : arms) EXPECT_EQ(text_box(place, "w = 27°").length_inside(arm), 0);
}

TEST(LabelPlacer, KeepsTextsApartAndOnThePage) {
  const PaperBox page = {{0, 0}, 40, 16};
  const std::vector<PaperPoint> points = {{0, 0}, {1.5, 0}, {0, 1.5}, {19.5, 7.5}, {-19.5, -7.5}};
  LabelPlacer placer(page, {{{-15, 4}, {15, 4}}}, points);
  std::vector<PaperBox> placed;
  for (const PaperPoint& point : points)
    placed.push_back(text_box(placer.beside_point(point, {0, 0}, "P10"), "P10"));
  placed.push_back(text_box(placer.beside_line({{-15, 4}, {15, 4}}, "h = 30"), "h = 30"));
  placed.push_back(text_box(placer.beside_line({{-15, 4}, {15, 4}}, "again"), "again"));
  for (std::size_t i = 0; i < placed.size(); ++i) {
    EXPECT_LE(std::abs(placed[i].centre[0]) + placed[i].width / 2, 20) << i;
    EXPECT_LE(std::abs(placed[i].centre[1]) + placed[i].height / 2, 8) << i;
    EXPECT_EQ(placed[i].length_inside({{-15, 4}, {15, 4}}), 0) << i;
    for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(placed[i].overlaps(placed[k])) << i << " and " << k;
  }
}

TEST(LabelPlacer, PutsALengthBesideTheMiddleOfItsLine) {
  LabelPlacer placer(kPage, {{{0, 0}, {30, 0}}}, {{0, 0}, {30, 0}});
  const PaperPoint place = placer.beside_line({{0, 0}, {30, 0}}, "c = 5");
  EXPECT_DOUBLE_EQ(place[0], 15);
  EXPECT_GT(place[1], 1);
  EXPECT_LT(place[1], 3);
}

}  // namespace
}  // namespace gcslab
