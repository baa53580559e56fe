#include "experiments/reporting/reference.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "experiments/reporting/measure.h"
#include "experiments/reporting/number_format.h"
#include "experiments/reporting/report_context.h"

namespace gcslab {
namespace {

// ---- writing ----

Json medians_json(const Row& row) {
  Json medians = Json::object();
  for (const auto& [name, samples] : row.timings.items()) {
    const std::vector<double> numbers = samples_of(row, ValueName(name));
    if (!numbers.empty()) medians[name] = summarise(numbers).median;
  }
  return medians;
}

Json row_json(const Row& row, const std::vector<std::string>& axes) {
  Json place = Json::object();
  for (const std::string& axis : axes) place[axis] = row.at(axis);
  return {{"job", row.job},
          {"axes", place},
          {"status", row.status},
          {"reason", row.reason},
          {"values", row.values},
          {"timings", medians_json(row)},
          {"peak_rss_mb", row.peak_rss_mb}};
}

/// What is the same for all rows: not the seed and the time of one of them.
Json shared_provenance(const RowTable& rows) {
  Json provenance = first_provenance(rows);
  if (provenance.is_object()) {
    provenance.erase("seed");
    provenance.erase("started");
  }
  return provenance;
}

std::string one_line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

// ---- comparing ----

std::string place_of(const Json& row) {
  std::string place;
  for (const auto& [axis, text] : row.at("axes").items()) {
    if (!place.empty()) place += ", ";
    if (axis != "problem" && axis != "method") place.append(axis).append(" ");
    place += text.get<std::string>();
  }
  return place;
}

struct PlacedRow {
  std::string place;
  Json row;
};

std::vector<PlacedRow> placed_rows(const std::string& text) {
  std::vector<PlacedRow> rows;
  const Json json = Json::parse(text);
  for (const Json& row : json.at("rows")) rows.push_back({place_of(row), row});
  return rows;
}

std::string value_text(const Json& row, const std::string& name) {
  return row.at("values").contains(name) ? one_line(row.at("values").at(name)) : "absent";
}

/// A search that a limit of time ended got as far as the machine is fast.
bool was_out_of_time(const Json& row) {
  if (row.at("status") != "budget_exhausted") return false;
  const auto reason = row.at("reason").get<std::string>();
  return reason.starts_with("wall limit") || reason.starts_with("CPU limit");
}

class Comparer {
 public:
  Comparison run(const std::vector<PlacedRow>& now, const std::vector<PlacedRow>& reference) {
    comparison_.reference_rows = reference.size();
    std::map<std::string, const Json*> known;
    for (const PlacedRow& placed : reference) known[placed.place] = &placed.row;
    for (const PlacedRow& placed : now) {
      const auto found = known.find(placed.place);
      if (found == known.end()) {
        comparison_.added.push_back(placed.place);
        continue;
      }
      compare(placed, *found->second);
      known.erase(found);
    }
    for (const PlacedRow& placed : reference) {
      if (known.contains(placed.place)) comparison_.missing.push_back(placed.place);
    }
    summarise_timings();
    return std::move(comparison_);
  }

 private:
  struct Ratio {
    double value;
    std::string place;
  };

  void compare(const PlacedRow& now, const Json& reference) {
    const std::size_t before = comparison_.differences.size();
    compare_status(now, reference);
    const bool is_comparable = !was_out_of_time(now.row) && !was_out_of_time(reference);
    if (is_comparable && now.row.at("status") == reference.at("status")) compare_values(now, reference);
    compare_timings(now, reference);
    if (comparison_.differences.size() == before) ++comparison_.equal_rows;
  }

  void differ(const std::string& place, const std::string& what, const std::string& was,
              const std::string& is) {
    comparison_.differences.push_back(fmt::format("{}: {} was {}, is {}", place, what, was, is));
  }

  void compare_status(const PlacedRow& now, const Json& reference) {
    const auto was = reference.at("status").get<std::string>();
    const auto is = now.row.at("status").get<std::string>();
    if (was == is) return;
    const auto reason = now.row.at("reason").get<std::string>();
    differ(now.place, "outcome", was, is + (reason.empty() ? "" : " (" + reason + ")"));
  }

  void compare_values(const PlacedRow& now, const Json& reference) {
    for (const auto& [name, value] : reference.at("values").items()) {
      const std::string is = value_text(now.row, name);
      if (is != one_line(value)) differ(now.place, name, one_line(value), is);
    }
    for (const auto& [name, value] : now.row.at("values").items()) {
      if (!reference.at("values").contains(name)) differ(now.place, name, "absent", one_line(value));
    }
  }

  void compare_timings(const PlacedRow& now, const Json& reference) {
    for (const auto& [name, value] : now.row.at("timings").items()) {
      if (!reference.at("timings").contains(name)) continue;
      const double is = value.get<double>();
      const double was = reference.at("timings").at(name).get<double>();
      if (is > 0 && was > 0) ratios_[name].push_back({is / was, now.place});
    }
  }

  void summarise_timings() {
    for (const auto& [name, ratios] : ratios_) {
      const auto [least, greatest] = std::ranges::minmax_element(ratios, {}, &Ratio::value);
      double logarithms = 0;
      for (const Ratio& ratio : ratios) logarithms += std::log(ratio.value);
      comparison_.timings.push_back({name, std::exp(logarithms / static_cast<double>(ratios.size())),
                                     least->value, greatest->value, least->place, greatest->place,
                                     ratios.size()});
    }
  }

  Comparison comparison_;
  std::map<std::string, std::vector<Ratio>> ratios_;
};

std::string timing_line(const TimingRatio& t) {
  return fmt::format("{}: {} times the reference (geometric mean of {} rows; from {}, {}, to {}, {}).",
                     ValueName(t.timing).heading(), format_significant(t.geometric_mean, 3), t.rows,
                     format_significant(t.least, 3), t.least_place, format_significant(t.greatest, 3),
                     t.greatest_place);
}

}  // namespace

std::string rows_text(const ReportContext& context) {
  std::string text = "{\n \"experiment\": " + one_line(context.experiment) + ",\n \"provenance\": ";
  text += one_line(shared_provenance(context.rows)) + ",\n \"rows\": [";
  const char* separator = "\n  ";
  for (const Row& row : context.rows.rows()) {
    text += separator + one_line(row_json(row, context.rows.axes()));
    separator = ",\n  ";
  }
  return text + "\n ]\n}\n";
}

Comparison compare_rows(const std::string& now, const std::string& reference) {
  try {
    return Comparer().run(placed_rows(now), placed_rows(reference));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(std::string("the committed rows cannot be read: ") + error.what());
  }
}

Verdict verdict_of(const Comparison& comparison) {
  Verdict verdict;
  verdict.state = comparison.agrees() ? Verdict::State::equal : Verdict::State::different;
  for (const std::string& line : comparison.differences) verdict.lines.push_back("Differs: " + line + ".");
  for (const std::string& place : comparison.missing) verdict.lines.push_back("Gone: " + place + ".");
  for (const std::string& place : comparison.added)
    verdict.lines.push_back("New, not in the reference: " + place + ".");
  verdict.lines.push_back(fmt::format("{} of {} rows have the outcome and values of the reference.",
                                      comparison.equal_rows, comparison.reference_rows));
  for (const TimingRatio& timing : comparison.timings) verdict.lines.push_back(timing_line(timing));
  return verdict;
}

}  // namespace gcslab
