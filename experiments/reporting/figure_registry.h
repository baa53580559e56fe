#pragma once

// The kinds of figures, one file each.

#include "experiments/reporting/figure.h"

namespace gcslab {

FigureKind cover_panels_kind();
FigureKind boxes_kind();
FigureKind range_bars_kind();
FigureKind series_kind();
FigureKind drawing_kind();
FigureKind figures_kind();
FigureKind paths_kind();
FigureKind deformation_kind();
FigureKind distribution_kind();
FigureKind performance_profile_kind();
FigureKind plan_graph_kind();
FigureKind ray_panels_kind();

}  // namespace gcslab
