// Lines, planes, circles and spheres in drawings: where they end, what outlines they have, what they hide and
// where their parameters stand, against points and angles that are computed another way.

#include "experiments/reporting/seen_objects.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "base/random.h"
#include "experiments/reporting/class_alignment.h"
#include "experiments/reporting/figures_picture.h"
#include "experiments/reporting/object_outline.h"
#include "experiments/reporting/seen_measures.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Numbers random_numbers(Random& random, std::size_t size, double reach = 1) {
  Numbers result;
  for (std::size_t i = 0; i < size; ++i) result.push_back(random.uniform(-reach, reach));
  return result;
}

Numbers random_direction(Random& random, std::size_t size) {
  Numbers direction;
  while (direction.empty()) direction = next_axis(random_numbers(random, size), {}, 0);
  return direction;
}

View random_view(Random& random) { return {random.uniform(-180, 180), random.uniform(-90, 90)}; }

double length(const Numbers& v) { return std::sqrt(dot(v, v)); }

/// The seen points of a view, which is a rigid motion, as points of space again.
Numbers place_of(const SeenPoint& p) { return {p.x, p.y, p.away}; }

bool is_inside(const Numbers& point, const Room& room, double slack) {
  for (std::size_t i = 0; i < point.size(); ++i) {
    if (point[i] < room.low[i] - slack || point[i] > room.high[i] + slack) return false;
  }
  return true;
}

WireObject sphere(const Numbers& centre, double radius) {
  return {"s", Sort::sphere, {centre[0], centre[1], centre[2], radius}};
}

WireObject plane(const Numbers& normal, double offset) {
  return {"p", Sort::plane, {normal[0], normal[1], normal[2], offset}};
}

Wireframe with_objects(Figure points, std::vector<WireObject> objects) {
  Wireframe figure;
  for (std::size_t p = 0; p < points.size(); ++p) figure.names.push_back("P" + std::to_string(p));
  figure.points = std::move(points);
  figure.objects = std::move(objects);
  return figure;
}

TEST(ClippedLine, IsThePartOfTheLineInTheRoom) {
  Random random(fuzz_seed(), "clipped line");
  for (std::size_t n = 0; n < fuzz_cases(300); ++n) {
    const std::size_t size = n % 2 == 0 ? 2 : 3;
    const Room room = {Numbers(size, -1), Numbers(size, 1.5)};
    const Numbers point = random_numbers(random, size, 3), direction = random_direction(random, size);
    const auto clipped = clipped_line(point, direction, room);
    constexpr int kSamples = 2000;
    double from = 1e300, to = -1e300;  // what samples of the line say
    for (int k = -kSamples; k <= kSamples; ++k) {
      const double s = 10.0 * k / kSamples;
      if (!is_inside(along(point, s, direction), room, 0)) continue;
      from = std::min(from, s);
      to = std::max(to, s);
    }
    if (!clipped) {
      EXPECT_GT(from, to);
      continue;
    }
    const double begin = dot(difference(clipped->first, point), direction);
    const double end = dot(difference(clipped->second, point), direction);
    EXPECT_LT(length(difference(clipped->first, along(point, begin, direction))), 1e-12);
    EXPECT_LT(begin, end);
    if (from > to) {
      EXPECT_LT(end - begin, 10.0 / kSamples);
      continue;
    }
    EXPECT_NEAR(begin, from, 10.1 / kSamples);
    EXPECT_NEAR(end, to, 10.1 / kSamples);
  }
}

TEST(ClippedLine, AlongASideOfTheRoom) {
  const Room room = {{0, 0}, {2, 1}};
  EXPECT_FALSE(clipped_line({0, 2}, {1, 0}, room));
  const auto ends = clipped_line({7, 0.5}, {-1, 0}, room);
  ASSERT_TRUE(ends);
  EXPECT_EQ(ends->first, (Numbers{2, 0.5}));
  EXPECT_EQ(ends->second, (Numbers{0, 0.5}));
}

TEST(Room, HoldsPointsCirclesSpheresAndAPartOfEveryLineAndPlane) {
  Random random(fuzz_seed(), "room");
  for (std::size_t n = 0; n < fuzz_cases(100); ++n) {
    const Numbers centre = random_numbers(random, 3), normal = random_direction(random, 3);
    const Numbers far = random_numbers(random, 3, 20), u = random_direction(random, 3);
    WireObject circle{"c", Sort::circle, centre};
    circle.place.insert(circle.place.end(), normal.begin(), normal.end());
    circle.place.push_back(0.7);
    WireObject line{"l", Sort::line, along(far, -dot(far, u), u)};
    line.place.insert(line.place.end(), u.begin(), u.end());
    const Wireframe figure =
        with_objects({random_numbers(random, 3)}, {circle, line, plane(normal, random.uniform(-9, 9))});
    const Room room = room_of(figure);
    EXPECT_TRUE(is_inside(figure.points[0], room, 0));
    for (const Numbers& p : outline_of(circle, figure, room)) {
      EXPECT_TRUE(is_inside(p, room, 0));
      EXPECT_NEAR(length(difference(p, centre)), 0.7, 1e-12);
      EXPECT_NEAR(dot(difference(p, centre), normal), 0, 1e-12);
    }
    EXPECT_EQ(outline_of(line, figure, room).size(), 2U);
    for (const Numbers& p : outline_of(figure.objects[2], figure, room))
      EXPECT_NEAR(dot(p, normal), figure.objects[2].place[3], 1e-11);
  }
}

TEST(SeenObjects, ACircleInSpaceIsAnEllipse) {
  // Seen from above, the circle of radius 2 about (1, 0, 5), tilted by a about a parallel of the x axis, is
  // the ellipse of half axes 2 and 2 cos a.
  const double a = 0.8;
  const WireObject circle{"c", Sort::circle, {1, 0, 5, 0, -std::sin(a), std::cos(a), 2}};
  const auto seen = seen_objects(with_objects({{0, 0, 0}, {1, 0, 0}}, {circle}), {0, 90});
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_FALSE(seen[0].is_surface());
  double highest = 0;
  for (const SeenPoint& p : seen[0].outline) {
    EXPECT_NEAR((p.x - 1) * (p.x - 1) / 4 + p.y * p.y / (4 * std::cos(a) * std::cos(a)), 1, 1e-12);
    highest = std::max(highest, p.y);
  }
  EXPECT_NEAR(highest, 2 * std::cos(a), 1e-2);
  EXPECT_EQ(seen[0].outline.front().x, seen[0].outline.back().x);
}

TEST(SeenObjects, ASphereIsACircleAroundAllOfIt) {
  Random random(fuzz_seed(), "sphere");
  for (std::size_t n = 0; n < fuzz_cases(50); ++n) {
    const View view = random_view(random);
    const Numbers centre = random_numbers(random, 3);
    const auto seen = seen_objects(with_objects({{0, 0, 0}}, {sphere(centre, 0.6)}), view);
    ASSERT_EQ(seen.size(), 1U);
    const SeenPoint middle = view.seen(centre);
    for (const SeenPoint& p : seen[0].outline)
      EXPECT_NEAR(std::hypot(p.x - middle.x, p.y - middle.y), 0.6, 1e-12);
    for (const SeenPoint& p : seen[0].relief) {
      EXPECT_NEAR(length(difference(place_of(p), place_of(middle))), 0.6, 1e-12);
      EXPECT_LE(p.away, middle.away + 1e-12) << "the nearer half";
    }
    const Numbers on_it = along(centre, 0.6, random_direction(random, 3));
    const SeenPoint p = view.seen(on_it);
    EXPECT_LE(std::hypot(p.x - middle.x, p.y - middle.y), 0.6 + 1e-12);
    EXPECT_EQ(seen[0].hides(p, 1e-9), p.away > middle.away) << "its rear half";
  }
}

TEST(SeenObjects, HideWhatRaysToTheReaderMeetThem) {
  Random random(fuzz_seed(), "hidden");
  std::size_t hidden = 0;
  for (std::size_t n = 0; n < fuzz_cases(400); ++n) {
    const View view = random_view(random);
    const Figure points = {random_numbers(random, 3), random_numbers(random, 3), random_numbers(random, 3)};
    const Numbers normal = random_direction(random, 3);
    const Wireframe figure =
        with_objects(points, {plane(normal, random.uniform(-0.5, 0.5)), sphere(points[1], 0.5)});
    const auto seen = seen_objects(figure, view);
    ASSERT_EQ(seen.size(), 2U);
    const Numbers x = random_numbers(random, 3, 1.5);
    // The way from x to the reader, in steps: does it cross the plane's rectangle, or enter the sphere?
    const Numbers towards = {-view.seen(Numbers{1, 0, 0}).away, -view.seen(Numbers{0, 1, 0}).away,
                             -view.seen(Numbers{0, 0, 1}).away};
    const double rate = dot(normal, towards);
    const double way = (figure.objects[0].place[3] - dot(normal, x)) / rate;
    const std::vector<Numbers> corners = outline_of(figure.objects[0], figure, room_of(figure));
    const Numbers offset = difference(along(x, way, towards), corners[0]);
    const Numbers one = difference(corners[1], corners[0]), other = difference(corners[3], corners[0]);
    const double s = dot(offset, one) / dot(one, one), t = dot(offset, other) / dot(other, other);
    const bool is_behind_plane = way > 0 && s > 0 && s < 1 && t > 0 && t < 1;
    double nearest = 1e300;
    for (int k = 0; k < 3000; ++k)
      nearest = std::min(nearest, length(difference(along(x, 0.002 * k, towards), points[1])));
    if (std::abs(nearest - 0.5) > 1e-4) {
      EXPECT_EQ(seen[1].hides(view.seen(x), 0), nearest < 0.5);
    }
    if (std::abs(rate) < 1e-3 || std::abs(way) < 1e-6) continue;
    EXPECT_EQ(seen[0].hides(view.seen(x), 0), is_behind_plane);
    hidden += is_behind_plane ? 1 : 0;
  }
  EXPECT_GT(hidden, 0U);
}

TEST(Openness, IsNothingEdgeOnOrEndOn) {
  const WireObject upright{"l", Sort::line, {1, 0, 0, 0, 0, 1}};
  const Wireframe lines = with_objects({}, {upright}), planes = with_objects({}, {plane({0, 0, 1}, 0)});
  EXPECT_NEAR(openness(lines, {30, 90}), 0, 1e-7);
  EXPECT_NEAR(openness(lines, {30, 0}), 1, 1e-12);
  EXPECT_NEAR(openness(planes, {30, 90}), 1, 1e-12);
  EXPECT_NEAR(openness(planes, {30, 0}), 0, 1e-12);
  EXPECT_NEAR(openness(planes, {-50, 30}), 0.5, 1e-12);
}

// ---- measures ----

double angle_between(const SeenAngle& angle) {
  const Numbers u = difference(place_of(angle.from), place_of(angle.at));
  const Numbers v = difference(place_of(angle.to), place_of(angle.at));
  return std::acos(dot(u, v) / (length(u) * length(v)));
}

TEST(SeenMeasures, OfAnglesAreTheAngles) {
  Random random(fuzz_seed(), "angles");
  std::size_t drawn = 0;
  for (std::size_t n = 0; n < fuzz_cases(300); ++n) {
    const auto line = [&] {
      const Numbers u = random_direction(random, 3), p = random_numbers(random, 3);
      WireObject result{"l", Sort::line, along(p, -dot(p, u), u)};
      result.place.insert(result.place.end(), u.begin(), u.end());
      return result;
    };
    const auto some_plane = [&] { return plane(random_direction(random, 3), random.uniform(-0.5, 0.5)); };
    Wireframe figure = with_objects({{-1, -1, -1}, {1, 1, 1}}, {});
    double expected = 0;
    const auto direction = [&](std::size_t k) {
      const auto parts = parts_of(figure.objects[k].sort, Universe::space, figure.objects[k].place);
      return parts.direction;
    };
    if (n % 3 == 0) {
      figure.objects = {line(), line()};
    } else if (n % 3 == 1) {
      figure.objects = {line(), some_plane()};
    } else {
      figure.objects = {some_plane(), some_plane()};
    }
    expected = std::acos(std::abs(dot(direction(0), direction(1))));
    if (n % 3 == 1) expected = std::numbers::pi / 2 - expected;
    figure.measures = {{"angle", {2, 3}, "a"}};
    const auto measures = seen_measures(figure, random_view(random));
    if (measures.empty()) continue;  // they meet outside of the room
    ++drawn;
    ASSERT_TRUE(measures[0].angle);
    EXPECT_NEAR(angle_between(*measures[0].angle), expected, 1e-6) << n;
    EXPECT_EQ(measures[0].guides.size(), 2U);
  }
  EXPECT_GT(drawn, fuzz_cases(300) / 4);
}

TEST(SeenMeasures, InThePlane) {
  // l: y = x, m: y = 0, circle about (3, 1) of radius 2, the point (0, 2) and its distance sqrt(2) from l.
  const double h = std::sqrt(0.5);
  Wireframe figure = with_objects(
      {{0, 2}, {3, 1}, {3, 3}},
      {{"l", Sort::line, {-h, h, 0}}, {"m", Sort::line, {0, 1, 0}}, {"c", Sort::circle, {3, 1, 2}}});
  figure.measures = {{"distance", {0, 3}, "d = 1.41"},
                     {"angle", {3, 4}, "a = 45°"},
                     {"radius", {5}, "r = 2"},
                     {"area", {0, 1, 2}, "f = 3"}};
  const auto measures = seen_measures(figure, {});
  ASSERT_EQ(measures.size(), 4U);
  const auto [from, foot] = measures[0].guides[0];
  EXPECT_NEAR(foot.x, 1, 1e-12);
  EXPECT_NEAR(foot.y, 1, 1e-12);
  EXPECT_EQ(from.y, 2);
  EXPECT_NEAR(angle_between(*measures[1].angle), std::numbers::pi / 4, 1e-12);
  EXPECT_NEAR(measures[1].angle->at.x, 0, 1e-12);
  EXPECT_GT(measures[1].angle->from.x, 0) << "towards the figure";
  EXPECT_TRUE(measures[1].guides.empty()) << "the lines are drawn";
  const auto [centre, rim] = measures[2].guides[0];
  EXPECT_NEAR(std::hypot(rim.x - centre.x, rim.y - centre.y), 2, 1e-12);
  EXPECT_NEAR(measures[3].middle->x, 2, 1e-12);
  EXPECT_EQ(measures[3].guides.size(), 3U);
}

TEST(SeenMeasures, OfAVolumeIsTheParallelepiped) {
  Wireframe figure = with_objects({{1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1.5, 0.5, 2}}, {});
  figure.measures = {{"volume", {0, 1, 2, 3}, "v = 0.333"}};
  const auto measures = seen_measures(figure, {0, 90});
  ASSERT_EQ(measures.size(), 1U);
  EXPECT_EQ(measures[0].guides.size(), 12U);
  double right = 0, top = 0;
  for (const auto& [from, to] : measures[0].guides) {
    right = std::max({right, from.x, to.x});
    top = std::max({top, from.y, to.y});
  }
  EXPECT_NEAR(right, 2.5, 1e-12);  // 1 + 1 + 0.5
  EXPECT_NEAR(top, 1.5, 1e-12);
  EXPECT_NEAR(measures[0].middle->x, 1.75, 1e-12);
}

// ---- figures with objects ----

FigurePicture sample_picture() {
  FigurePicture picture;
  picture.wires.names = {"A", "B"};
  picture.wires.edges = {{0, 1, "c = 5"}};
  picture.wires.objects = {{"l", Sort::line}, {"k", Sort::circle}};
  picture.wires.measures = {{"radius", {3}, "r = 2"}, {"distance", {0, 2}, "d = 1"}};
  picture.figures = {{{{0, 0}, {5, 0}, {0, 1, 1}, {2.5, 1, 2}}, 4, true},
                     {{{0, 0}, {5, 0}, {0, 1, -1}, {2.5, 1, 2}}, 4, true}};
  return picture;
}

TEST(FigurePicture, WithObjectsIsReadBack) {
  const FigurePicture again =
      figure_picture_from_json(nlohmann::ordered_json::parse(to_json(sample_picture()).dump()));
  EXPECT_EQ(to_json(again), to_json(sample_picture()));
  EXPECT_EQ(wireframe_at(again, 1).objects[0].place, (Numbers{0, 1, -1}));
  auto broken = to_json(sample_picture());
  broken["figures"]["objects"][1]["sort"] = "ellipse";
  EXPECT_THROW(figure_picture_from_json(broken), InputError);
  broken = to_json(sample_picture());
  broken["figures"]["classes"][0]["points"][2] = {1, 2};
  EXPECT_THROW(figure_picture_from_json(broken), InputError);
  broken = to_json(sample_picture());
  broken["figures"]["measures"][0]["objects"][0] = 4;
  EXPECT_THROW(figure_picture_from_json(broken), InputError);
}

TEST(FigurePicture, OfARowWithoutObjectsHasNone) {
  auto old = to_json(sample_picture());
  old["figures"].erase("objects");
  old["figures"].erase("measures");
  for (auto& figure : old["figures"]["classes"]) {
    figure["points"].erase(3);
    figure["points"].erase(2);
  }
  EXPECT_TRUE(wireframe_at(figure_picture_from_json(old), 0).objects.empty());
}

TEST(ReflectedUpright, MovesObjectsWithThePoints) {
  const std::vector<Sort> sorts = {Sort::point, Sort::point, Sort::line, Sort::circle};
  const Figure upright = {{0, 0}, {5, 0}, {0.6, 0.8, 1}, {2, 1, 3}};
  Figure mirrored = upright;  // at both axes
  mirrored[1][0] = -5;
  mirrored[2] = {-0.6, -0.8, 1};
  mirrored[3] = {-2, -1, 3};
  EXPECT_EQ(reflected_upright(mirrored, sorts, {0, 1}), upright);
}

TEST(ClassAlignment, TellsFiguresApartByTheirObjects) {
  const FigurePicture first = sample_picture();
  FigurePicture second = first;
  std::swap(second.figures[0], second.figures[1]);
  second.figures[0].places[2] = {0, -1, 1};  // the other normal of the same line
  const auto lines = aligned_classes({&first, &second});
  ASSERT_EQ(lines.size(), 2U) << "y = 1 meets the circle about (2.5, 1) in another way than y = -1";
  EXPECT_EQ(lines[0], (AlignedLine{0, 1}));
  EXPECT_EQ(lines[1], (AlignedLine{1, 0}));
}

TEST(FiguresPicture, DrawsObjectsWithNamesAndParameters) {
  const FigureScript script = draw_figures(sample_picture(), "line and circle");
  for (const char* words : {"'l'", "'k'", "'r = 2'", "'d = 1'", "'c = 5'"})
    EXPECT_TRUE(has(script.commands(), words)) << words << "\n" << script.commands();
  EXPECT_TRUE(has(script.data(), "curves, depth 6 of 6")) << script.data();
  EXPECT_TRUE(has(script.data(), "what is measured")) << script.data();
}

}  // namespace
}  // namespace gcslab
