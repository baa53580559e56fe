#include "experiments/reporting/measure.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "base/check.h"
#include "base/error.h"

namespace gcslab {
namespace {

std::optional<double> plain_number(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') return std::nullopt;
  return number;
}

bool is_timing(const std::string& name) { return name.ends_with("_s"); }

std::string unit_of(const std::string& name) {
  if (is_timing(name)) return "s";
  if (name.ends_with("_mb")) return "MB";
  return "";
}

std::string heading_of_value(const std::string& name) {
  if (name == "wall_s") return "wall time";
  if (name == "cpu_s") return "CPU time";
  if (name == "prepare_s") return "preparation time";
  if (name == "step_s") return "time of a step";
  if (name == "peak_rss_mb") return "peak memory";
  std::string words = name;
  if (is_timing(name)) words = name.substr(0, name.size() - 2) + "_time";
  if (name.ends_with("_mb")) words = name.substr(0, name.size() - 3);
  std::ranges::replace(words, '_', ' ');
  return words;
}

/// "kept cells" -> "kept cell", "boxes" -> "box".
std::string singular(std::string words) {
  const std::size_t ending = words.ends_with("xes") ? 2 : words.ends_with("s") ? 1 : 0;
  words.resize(words.size() - ending);
  return words;
}

std::vector<double> numbers_from(const Json& json) {
  if (json.is_number()) return {json.get<double>()};
  if (json.is_string()) {
    const auto number = number_from_text(json.get<std::string>());
    return number ? std::vector<double>{*number} : std::vector<double>{};
  }
  return {};
}

std::vector<double> numbers_of_list(const Json& json) {
  if (!json.is_array()) return numbers_from(json);
  std::vector<double> numbers;
  for (const Json& item : json) {
    for (const double number : numbers_from(item)) numbers.push_back(number);
  }
  return numbers;
}

std::vector<double> plain_samples(const Row& row, const std::string& name) {
  if (row.timings.contains(name)) return numbers_of_list(row.timings.at(name));
  if (row.values.contains(name)) return numbers_from(row.values.at(name));
  if (name == "peak_rss_mb" && row.was_run() && !row.is_reference) return {row.peak_rss_mb};
  const auto number = number_from_text(row.at(name));
  return number ? std::vector<double>{*number} : std::vector<double>{};
}

std::string text_from(const Json& json) {
  if (json.is_string()) return json.get<std::string>();
  if (!json.is_array()) return json.dump();
  std::string text;
  for (const Json& item : json) text += (text.empty() ? "" : ", ") + text_from(item);
  return text;
}

/// The value as it stands in the row, where that is more exact than a double.
std::string exact_text(const Row& row, const ValueName& value) {
  if (value.numerator() == "status") return outcome_word(row);
  if (!value.denominator().empty() || !row.values.contains(value.numerator())) return "";
  const Json& json = row.values.at(value.numerator());
  return json.is_number() ? "" : text_from(json);
}

/// The one text on which all rows agree; empty when they do not.
std::string agreed_text(const RowPointers& rows, const ValueName& value) {
  const std::string text = exact_text(*rows.front(), value);
  const bool agreed =
      std::ranges::all_of(rows, [&](const Row* row) { return exact_text(*row, value) == text; });
  return agreed ? text : "";
}

double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const double weight = place - static_cast<double>(below);
  // Equal neighbours need no interpolation, which infinite samples would not survive.
  if (weight == 0 || sorted[below] == sorted[below + 1]) return sorted[below];
  return sorted[below] + weight * (sorted[below + 1] - sorted[below]);
}

}  // namespace

ValueName::ValueName(const std::string& text) {
  const std::size_t slash = text.find('/');
  numerator_ = text.substr(0, slash);
  if (slash != std::string::npos) denominator_ = text.substr(slash + 1);
  const bool bad_quotient =
      slash != std::string::npos && (denominator_.empty() || denominator_.find('/') != std::string::npos);
  if (numerator_.empty() || bad_quotient)
    throw InputError("'" + text + "' is neither a value nor a quotient of two");
}

std::string ValueName::text() const {
  return denominator_.empty() ? numerator_ : numerator_ + "/" + denominator_;
}

std::string ValueName::heading() const {
  const std::string above = heading_of_value(numerator_);
  return denominator_.empty() ? above : above + " per " + singular(heading_of_value(denominator_));
}

std::string ValueName::unit() const {
  std::string above = unit_of(numerator_);
  const std::string below = denominator_.empty() ? "" : unit_of(denominator_);
  if (below.empty()) return above;
  return above == below ? "" : (above.empty() ? "1" : above) + "/" + below;
}

bool ValueName::is_of_machine() const {
  return !unit_of(numerator_).empty() || (!denominator_.empty() && !unit_of(denominator_).empty());
}

std::optional<double> number_from_text(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return plain_number(text);
  const auto above = plain_number(text.substr(0, slash));
  const auto below = plain_number(text.substr(slash + 1));
  if (!above || !below || *below == 0) return std::nullopt;
  return *above / *below;
}

Measure summarise(std::vector<double> samples) {
  GCSLAB_CHECK(!samples.empty());
  std::ranges::sort(samples);
  Measure result;
  result.median = quantile(samples, 0.5);
  result.minimum = samples.front();
  result.maximum = samples.back();
  result.lower_quartile = quantile(samples, 0.25);
  result.upper_quartile = quantile(samples, 0.75);
  result.samples = samples.size();
  return result;
}

std::vector<double> samples_of(const Row& row, const ValueName& value) {
  std::vector<double> samples = plain_samples(row, value.numerator());
  if (value.denominator().empty()) return samples;
  const std::vector<double> divisors = plain_samples(row, value.denominator());
  if (divisors.empty()) return {};
  const double divisor = summarise(divisors).median;
  if (divisor == 0) return {};
  for (double& sample : samples) sample /= divisor;
  return samples;
}

std::optional<Measure> measure(const RowPointers& rows, const ValueName& value) {
  RowPointers usable;
  std::vector<double> medians;
  std::vector<double> last;
  for (const Row* row : rows) {
    if (!row->has_result()) continue;
    usable.push_back(row);
    last = samples_of(*row, value);
    if (!last.empty()) medians.push_back(summarise(last).median);
  }
  if (usable.empty()) return std::nullopt;
  Measure result;
  if (!medians.empty()) result = summarise(usable.size() == 1 ? last : medians);
  result.text = agreed_text(usable, value);
  if (!result.is_number() && result.text.empty()) return std::nullopt;
  return result;
}

}  // namespace gcslab
