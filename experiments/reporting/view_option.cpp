#include "experiments/reporting/view_option.h"

#include <sstream>

#include "base/error.h"

namespace gcslab {

OptionSpec view_option(const std::string& default_view) {
  return {.name = "view",
          .meaning =
              "of figures in space: best, or degrees about the upright axis and above the ground, "
              "such as -35,22",
          .default_value = default_view};
}

std::optional<View> view_from(const FigureRequest& request) {
  const std::string& view = request.options.word("view");
  if (view == "best") return std::nullopt;
  View chosen;
  char comma = 0;
  std::istringstream stream(view);
  if (!(stream >> chosen.turned >> comma >> chosen.raised) || comma != ',' || stream.peek() != EOF)
    throw InputError(request.item.where,
                     "'" + request.item.file + "': view '" + view +
                         "': expected best, or degrees turned and raised, such as -35,22");
  return chosen;
}

}  // namespace gcslab
