#pragma once

// The option `view` of figures in space.

#include <optional>
#include <string>

#include "experiments/reporting/axonometry.h"
#include "experiments/reporting/figure.h"

namespace gcslab {

OptionSpec view_option(const std::string& default_view);
/// Nothing: the best. Throws InputError with the item's place when the word is no view.
std::optional<View> view_from(const FigureRequest& request);

}  // namespace gcslab
