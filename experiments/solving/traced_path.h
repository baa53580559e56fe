#pragma once

// Where a homotopy path runs, as the JSON that a row of a run carries to the drawings.

#include <nlohmann/json.hpp>

#include "geometry/geometric_equations.h"
#include "homotopy/figure_curve.h"
#include "homotopy/path_trace.h"

namespace gcslab {

struct TracedPoint {
  std::vector<double> unknowns;
  double t = 0;
};

struct TracedPath {
  std::vector<std::string> names;  ///< of the unknowns
  /// Of each object of the figures: the numbers of the unknowns that are its coordinates; -1: it is 0.
  std::vector<std::vector<int>> coordinates;
  std::vector<TracedPoint> points;  ///< along the path
  std::size_t sketch = 0;           ///< which of them is the sketch
  std::vector<TracedPoint> crossings;
  std::vector<TracedPoint> critical;

  /// The figure there.
  Figure figure(const TracedPoint& point) const;
};

/// At most `most` points of what the trace noted, and what the path met.
TracedPath traced_path(const PathTrace& trace, const Path& path, const FigureCurve& curve,
                       const GeometricEquations& equations, std::size_t most);

/// {"unknowns", "coordinates", "points": [[x, .., t]], "sketch", "crossings", "critical"}; numbers with the
/// digits that a drawing can show.
nlohmann::ordered_json to_json(const TracedPath& path);
/// The inverse. Throws InputError when the JSON is no such thing.
TracedPath traced_path_from_json(const nlohmann::ordered_json& json);

}  // namespace gcslab
