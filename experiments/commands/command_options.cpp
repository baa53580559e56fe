#include "experiments/commands/command_options.h"

#include <cmath>
#include <cstdlib>

#include "base/error.h"

namespace gcslab {

CLI::Validator positive_number() {
  return CLI::Validator(
      [](std::string& text) {
        const double number = std::strtod(text.c_str(), nullptr);
        return number > 0 && std::isfinite(number) ? "" : "must be a positive number";
      },
      "POSITIVE");
}

std::map<std::string, std::string> option_texts(const std::vector<std::string>& assignments) {
  std::map<std::string, std::string> texts;
  for (const std::string& assignment : assignments) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) throw InputError("--set \"" + assignment + "\": expected option=value");
    if (!texts.emplace(assignment.substr(0, equals), assignment.substr(equals + 1)).second) {
      throw InputError("--set gives the option '" + assignment.substr(0, equals) + "' twice");
    }
  }
  return texts;
}

}  // namespace gcslab
