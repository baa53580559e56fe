#include "experiments/corpus/problem_loader.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiments/corpus/corpus.h"

namespace gcslab {

Problem load_problem_of_kind(const std::string& name_or_path, const std::vector<std::string>& kinds,
                             const std::string& valuation) {
  const std::filesystem::path path = Corpus::standard().problem_path(name_or_path);
  const std::string kind = kind_of_file(path);
  if (std::ranges::find(kinds, kind) == kinds.end()) {
    throw InputError(
        fmt::format("{}: is of kind '{}'; expected one of {}", path.string(), kind, fmt::join(kinds, ", ")));
  }
  return load_problem(path, valuation);
}

const std::vector<std::string>& system_kinds() {
  static const std::vector<std::string> kinds = {"system",  "constraint_system", "curve",
                                                 "surface", "space_curve",       "function"};
  return kinds;
}

Problem load_system(const std::string& name_or_path, const std::string& valuation) {
  return load_problem_of_kind(name_or_path, system_kinds(), valuation);
}

}  // namespace gcslab
