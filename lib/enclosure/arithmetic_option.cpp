#include "enclosure/arithmetic_option.h"

namespace gcslab {

std::vector<OptionSpec> with_arithmetic_options(std::vector<OptionSpec> own) {
  std::vector<std::string> names;
  names.reserve(kArithmetics.size());
  for (const Arithmetic arithmetic : kArithmetics) names.emplace_back(name_of(arithmetic));
  std::vector<OptionSpec> options = {
      choice_option("arithmetic", "interval arithmetic; unrounded is the unsound baseline", "fast", names),
      integer_option("bits", "precision of the arithmetic mpfr; the others have 53", "bits", 53, 2, 100000)};
  options.insert(options.end(), own.begin(), own.end());
  return options;
}

}  // namespace gcslab
