#include "verifier/json_place.h"

#include <algorithm>
#include <cmath>

#include "verifier/proof_reader.h"

namespace gcslab::verifier {

JsonPlace JsonPlace::at(const std::string& key) const {
  if (auto place = find(key)) return *place;
  refuse("has no key '" + key + "'");
}

std::optional<JsonPlace> JsonPlace::find(const std::string& key) const {
  if (!value_->is_object()) refuse("is no object");
  const auto found = value_->find(key);
  if (found == value_->end()) return std::nullopt;
  return JsonPlace(*found, pointer_ + "/" + key);
}

std::vector<JsonPlace> JsonPlace::items() const {
  if (!value_->is_array()) refuse("is no list");
  std::vector<JsonPlace> result;
  for (std::size_t i = 0; i < value_->size(); ++i)
    result.emplace_back((*value_)[i], pointer_ + "/" + std::to_string(i));
  return result;
}

std::string JsonPlace::text() const {
  if (!value_->is_string()) refuse("is no text");
  return value_->get<std::string>();
}

std::string JsonPlace::word(const std::vector<std::string>& words) const {
  std::string result = text();
  if (std::ranges::find(words, result) == words.end()) refuse("'" + result + "' is no word of the format");
  return result;
}

double JsonPlace::number() const {
  double result = 0;
  if (value_->is_number()) {
    result = value_->get<double>();
  } else if (!read_hexadecimal(text(), result)) {
    refuse("is no number");
  }
  if (!std::isfinite(result)) refuse("is not finite");
  return result;
}

Interval JsonPlace::interval() const {
  const std::vector<JsonPlace> ends = items();
  if (ends.size() != 2) refuse("is not [lower, upper]");
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double lower = 0;
  double upper = 0;
  if (!read_hexadecimal(ends[0].text(), lower)) ends[0].refuse("is no number in hexadecimal digits");
  if (!read_hexadecimal(ends[1].text(), upper)) ends[1].refuse("is no number in hexadecimal digits");
  if (!(lower <= upper) || lower == kInfinity || upper == -kInfinity) refuse("is no interval");
  return {lower, upper};
}

Box JsonPlace::box(std::size_t variables) const {
  Box result;
  for (const JsonPlace& side : items()) result.push_back(side.interval());
  if (result.size() != variables) refuse("has not one interval a variable");
  return result;
}

}  // namespace gcslab::verifier
