#pragma once

// A whole path of a curve H(x, t) = 0 in R^(m+1), from a point with t = 0, followed by prediction and
// correction (Allgower, Georg 1990).
//
// The tangent keeps its orientation where t turns back. A step is refused, and halved, when the correction
// goes far or does not contract, or turns the tangent much. Three more things tell a jump to another path:
//   - the sign of det (J; tangent) is constant on a regular curve. Where it changes over a step, branches
//     cross there (the point is looked for, see critical_point.h, and the path goes straight on), or the step
//     cut across where two branches come near and turn away: it is refused;
//   - a closed path that the start is not on;
//   - an odd number of crossings of t = 1 by a closed path.
// After the last two the whole path is followed again with smaller steps. Nothing of this is a proof; a
// certifier gives one.
//
// A path that does not return to its start is followed in the other direction too.

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "homotopy/corrector.h"

namespace gcslab {

class ChartedCurve;
class PathCertifier;

enum class StepControl {
  adaptive,  ///< by the error of the prediction and the turn of the tangent
  fixed      ///< always the first step; when one fails, the whole path again with steps half as long
};

struct TrackerOptions {
  std::string predictor = "hermite";
  CorrectorOptions corrector{};
  StepControl step_control = StepControl::adaptive;
  double first_step = 0.01;
  double largest_step = 0.5;  ///< times the distance from the origin, where that is more than 1
  double least_step = 1e-10;
  double largest_turn = 0.4;  ///< of the tangent in a step, radians
  double deviation = 0.02;    ///< aimed at: of the prediction, as part of the step
  double infinity = 1e5;      ///< a path that gets that far from the origin is said to go to infinity
  std::uint64_t maximum_steps = 1'000'000;
  bool stops_at_first_crossing = false;
};

enum class PathEnd {
  cycle,         ///< back at the start
  to_infinity,   ///< far out
  to_undefined,  ///< to a point at which the equations are undefined, or so singular that it goes on nowhere
  stuck,         ///< no step succeeds
  budget         ///< the steps are used up, or the user or an option stopped it
};
/// The words of results; a path that is stuck has the word of budget.
std::string_view name_of(PathEnd end);

/// A point of the path with t = 1.
struct Crossing {
  std::vector<double> v;
  double length;             ///< from the start, negative in the other direction
  std::size_t rank;          ///< of the Jacobian by x
  bool is_touching = false;  ///< t turns back there without crossing
};

/// A point at which branches cross.
struct BranchPoint {
  std::vector<double> v;
  double length;  ///< as of crossings
};

struct Path {
  PathEnd end = PathEnd::budget;           ///< in the first direction
  PathEnd other_end = PathEnd::budget;     ///< in the other one; of a cycle: the same
  std::vector<double> last, other_last;    ///< the last points; of a cycle: the start
  std::vector<Crossing> crossings;         ///< in the order met, the first direction first
  std::vector<BranchPoint> branch_points;  ///< likewise
  double length = 0;
  std::uint64_t steps = 0;
  std::uint64_t refused = 0;        ///< steps tried in vain
  std::uint64_t precise_steps = 0;  ///< tried with more digits than doubles have
  int restarts = 0;                 ///< after jumps that were noticed, or steps too long
  std::uint64_t chart_changes = 0;
  std::uint64_t tubes = 0;           ///< of the proof, when one was asked for
  std::uint64_t unproved_steps = 0;  ///< across branch points, of which nothing is proved
  bool is_return_proved = false;     ///< that a cycle leads back to the start
};

/// What is known while a path is followed, enough to go on from.
struct PathState {
  Path path;
  int direction = 1;
  CurvePoint here;
  std::optional<CurvePoint> before;
  double step = 0;
  double length = 0;    ///< travelled in this direction
  CurvePoint landmark;  ///< to notice loops without the start: a point that later ones replace
  std::uint64_t steps_to_next_landmark = 0;
};

/// Called after each step.
using PathObserver = std::function<void(const PathState&)>;

/// What may help to follow a path.
struct PathAids {
  PathObserver observer{};
  const PathState* from = nullptr;  ///< where to go on
  /// Each step is taken only when it is proved that the curve leads from one point to the next, with as many
  /// crossings of t = 1 as are noted; across branch points nothing is proved, and such steps are counted.
  PathCertifier* certifier = nullptr;
  /// The same curve with more digits, for points where only small steps succeed.
  Curve* precise = nullptr;
  /// The curve itself, where it has several charts: after each step, and where no step succeeds, the path
  /// goes on in a better one. The points of the result are chartless ones, lengths those in the charts.
  ChartedCurve* charts = nullptr;
};

/// Follows the path through `start`, whose last coordinate is 0 and where H vanishes up to rounding. Throws
/// NotApplicable, with the reason, where the Jacobian has no full rank or is undefined at the start.
Path follow_path(Curve& curve, const std::vector<double>& start, const TrackerOptions& options,
                 const std::stop_token& stop = {}, const PathAids& aids = {});

}  // namespace gcslab
