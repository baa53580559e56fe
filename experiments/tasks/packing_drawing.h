#pragma once

#include <string>

#include "box_solver/search.h"
#include "experiments/tasks/job_result.h"

namespace gcslab {

/// The discs of a circle packing and the graph of their tangencies, as the figure kind `drawing` takes them;
/// null when the system is no packing or has not exactly one solution. `name` is the problem's.
Json packing_drawing(const std::string& name, const SystemFunctions& functions, const SearchResult& found);

}  // namespace gcslab
