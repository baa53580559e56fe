#include "experiments/reporting/row.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace gcslab {

std::string Row::at(const std::string& axis) const {
  const auto found = axes.find(axis);
  if (found != axes.end()) return found->second;
  const auto constant = constants.find(axis);
  return constant == constants.end() ? "" : constant->second;
}

std::string place_text(const Row& row) {
  std::string text = row.at("problem") + ", " + row.at("method");
  for (const auto& [axis, value] : row.axes) {
    if (axis != "problem" && axis != "method") text.append(", ").append(axis).append(" ").append(value);
  }
  return text;
}

std::string outcome_word(const Row& row) {
  if (row.status == "not_applicable") return "n/a";
  if (row.status == "budget_exhausted") {
    // What usually runs out is time, and its reason need not say so.
    const bool of_memory = row.reason.find("memory") != std::string::npos;
    return of_memory ? "out of memory" : "timeout";
  }
  std::string word = row.status;
  std::ranges::replace(word, '_', ' ');
  return word;
}

}  // namespace gcslab
