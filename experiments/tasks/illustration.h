#pragma once

// What the drawings of the task `illustrate` share: shapes and panels as JSON, which the figure kind
// `drawing` puts on paper, and exact points.

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/option.h"
#include "experiments/tasks/job_result.h"
#include "interval/rational.h"

namespace gcslab {

using RationalPoint = std::array<Rational, 2>;
using ControlPolygon = std::vector<RationalPoint>;

/// What a drawing gives: panels, and numbers for tables.
struct Drawn {
  Json panels = Json::array();
  Json values = Json::object();
};

/// A drawing that can be asked for.
struct Illustration {
  std::string name;
  std::string summary;
  std::function<Drawn(const std::filesystem::path&, const Options&)> draw;
  std::vector<OptionSpec> options{};
};

/// The drawings, by what they show.
std::vector<Illustration> bernstein_illustrations();
std::vector<Illustration> polytope_illustrations();
std::vector<Illustration> solver_illustrations();
std::vector<Illustration> plan_illustrations();

Json point_json(const RationalPoint& p);
Json points_json(const ControlPolygon& points);
/// The kinds and styles are those of experiments/reporting/drawing.cpp.
Json shape(const char* kind, const char* style, Json points, const std::string& text = "");
/// A text on or beside a point.
Json label(const char* style, const RationalPoint& place, const std::string& text,
           const char* anchor = "corner");

/// Convex hull by Andrew's monotone chain (1979), exact, counterclockwise.
ControlPolygon convex_hull(ControlPolygon points);

/// Limits of an axis around all points, with a margin on either side as part of their extent.
Json limits_around(const ControlPolygon& points, std::size_t axis, double margin = 0.08);

}  // namespace gcslab
