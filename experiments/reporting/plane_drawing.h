#pragma once

// What all panels over a box of two variables share: their shape, axes and curves.

#include <string>
#include <vector>

#include "experiments/reporting/report_context.h"
#include "interval/interval.h"

namespace gcslab {

/// Height over width of the panel in which both variables have the same scale; 1 for domains that are so long
/// that no panel would be legible.
double panel_aspect(const Box& domain);

/// The gnuplot commands for axes that are exactly the domain; without `vertical_tics` no numbers stand on the
/// left.
std::string axis_commands(const Box& domain, bool vertical_tics);

/// The polyline with fewer points, none of the left out ones farther than `tolerance` from it (Douglas,
/// Peucker 1973).
Polyline simplified(const Polyline& line, double tolerance);

/// The data lines of a curve with as many points as a panel can show.
std::string curve_lines(const std::vector<Polyline>& curve, const Box& domain);

}  // namespace gcslab
