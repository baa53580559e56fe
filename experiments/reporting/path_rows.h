#pragma once

// The traced paths of rows, for the figure kinds that draw them.

#include <string>
#include <vector>

#include "experiments/reporting/figure.h"
#include "experiments/solving/figure_picture.h"
#include "experiments/solving/traced_path.h"

namespace gcslab {

/// The texts of a row on the axes on which the rows differ.
std::string name_of_row(const Row& row, const RowPointers& rows);

struct PathRow {
  const Row* row;
  std::string name;  ///< what tells the row from the others; empty for one alone
  TracedPath path;
  FigurePicture picture;
};

/// Those that ran their course. Throws InputError when one of them holds no path, or none is left.
std::vector<PathRow> path_rows(const FigureRequest& request);

}  // namespace gcslab
