#include "construction/plan_escapes.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numbers>

#include "base/error.h"
#include "geometry/numeric_vector.h"
#include "geometry/sketch.h"

namespace gcslab {
namespace {

/// Whether constraints keep the point near one of those before it, step by step over points that are not.
bool is_tied(const ConstraintSystem& system, std::size_t point, const std::vector<bool>& is_before) {
  std::vector<bool> is_near(system.points(), false);
  std::vector<std::size_t> open = {point};
  is_near[point] = true;
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    for (const Constraint& constraint : system.constraints) {
      const std::vector<std::size_t>& pair = constraint.objects;
      if (constraint.kind->nearness == Nearness::unknown || std::ranges::find(pair, at) == pair.end())
        continue;
      const std::size_t other = pair[0] == at ? pair[1] : pair[0];
      if (is_before[other]) return true;
      if (!is_near[other]) open.push_back(other);
      is_near[other] = true;
    }
  }
  return false;
}

std::string name_of(const Constraint& constraint, const ConstraintSystem& system) {
  std::string text = constraint.kind->name;
  for (const std::size_t object : constraint.objects) text += " " + system.objects[object].name;
  return text;
}

/// "a", "a and b", "a, b and c".
std::string joined(const std::vector<std::string>& parts) {
  if (parts.size() < 2) return parts.empty() ? "" : parts[0];
  const std::vector<std::string> first(parts.begin(), parts.end() - 1);
  return fmt::format("{} and {}", fmt::join(first, ", "), parts.back());
}

std::string configuration_of(const PlanEscape& escape, const Plan& plan, const ConstraintSystem& system) {
  std::vector<std::string> guides, planes;
  for (const std::size_t g : escape.guides) {
    guides.push_back(fmt::format("k{} = distance {} {}", g, system.objects[plan.guides[g].point].name,
                                 system.objects[plan.guides[g].centre].name));
  }
  for (const std::size_t c : escape.constraints) {
    std::string plane = name_of(system.constraints[c], system);
    if (std::ranges::find(planes, plane) == planes.end()) planes.push_back(std::move(plane));
  }
  std::string text = system.objects[escape.point].name + " infinitely far";
  if (!guides.empty() && !planes.empty()) text += " in the loci of " + joined(planes);
  if (!guides.empty()) return text + ": " + joined(guides) + " infinite";
  return text + ": the loci of " + joined(planes) + " do not meet in one point";
}

}  // namespace

std::vector<PlanEscape> escapes_of(const Plan& plan, const ConstraintSystem& system) {
  const FigureVariables variables(system);
  const Frame frame = plan.frame(system.universe);
  std::vector<PlanEscape> result;
  std::vector<bool> is_before(system.points(), false);
  for (const PlanStep& step : plan.steps) {
    PlanEscape escape{step.point, {}, {}, {}};
    bool is_bounded = step.loci.empty() || is_tied(system, step.point, is_before);
    is_before[step.point] = true;
    for (const LocusSource& source : step.loci) {
      if (source.guide) {
        escape.guides.push_back(*source.guide);
        continue;
      }
      const Constraint& constraint = system.constraints[*source.constraint];
      is_bounded =
          is_bounded || loci_of(system, constraint, step.point, frame, variables)[source.part].is_sphere;
      escape.constraints.push_back(*source.constraint);
    }
    if (is_bounded) continue;
    escape.configuration = configuration_of(escape, plan, system);
    result.push_back(std::move(escape));
  }
  return result;
}

namespace {

/// "angle P2 P3 P4 goes to 0", of the angles about a point that are flat in the figure.
std::string flat_angles(const ConstraintSystem& system, std::size_t point, const Figure& figure) {
  constexpr double kFlat = 1e-2;
  std::vector<double> values;
  try {
    values = parameters_of(system, figure);
  } catch (const InputError&) {  // points coincide
    return "";
  }
  std::vector<std::string> flat;
  for (const Constraint& constraint : system.constraints) {
    const auto& named = constraint.objects;
    if (constraint.kind->name != "angle" || std::ranges::find(named, point) == named.end()) continue;
    const double angle = values[*constraint.parameter];
    if (std::abs(angle) > kFlat && std::abs(angle - std::numbers::pi) > kFlat) continue;
    flat.push_back(name_of(constraint, system) + " goes to " + (angle < 1 ? "0" : "180 degrees"));
  }
  return joined(flat);
}

}  // namespace

std::string escape_met(const std::vector<PlanEscape>& escapes, const Plan& plan,
                       const ConstraintSystem& system, const Figure& figure, double far) {
  const Numbers& origin = figure[plan.steps.front().point];
  for (const PlanStep& step : plan.steps) {
    const Numbers side = difference(figure[step.point], origin);
    if (std::sqrt(dot(side, side)) <= far) continue;
    const auto met = std::ranges::find(escapes, step.point, &PlanEscape::point);
    if (met == escapes.end()) return "";
    const std::string flat = flat_angles(system, step.point, figure);
    return met->configuration + (flat.empty() ? "" : "; " + flat);
  }
  return "";
}

}  // namespace gcslab
