#include "experiments/reporting/solver_comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/check.h"

namespace gcslab {
namespace {

std::optional<std::int64_t> count_of(const Row& row, const char* name) {
  if (!row.values.contains(name) || !row.values.at(name).is_number_integer()) return std::nullopt;
  return row.values.at(name).get<std::int64_t>();
}

std::vector<std::string> distinct_texts(const RowPointers& rows, const std::string& axis) {
  std::vector<std::string> texts;
  for (const AxisKey& key : keys_on(rows, {axis})) texts.push_back(key.front());
  return texts;
}

std::vector<std::string> axes_beside_method(const RowPointers& rows) {
  std::vector<std::string> axes = {"problem"};
  if (rows.empty()) return axes;
  for (const auto& [axis, text] : rows.front()->axes) {
    if (axis != "problem" && axis != "method") axes.push_back(axis);
  }
  return axes;
}

}  // namespace

double shifted_geometric_mean(const std::vector<double>& costs, double shift) {
  GCSLAB_CHECK(!costs.empty() && shift >= 0);
  double sum = 0;
  for (const double cost : costs) {
    GCSLAB_CHECK(cost >= 0 && cost + shift > 0);
    sum += shift > 0 ? std::log1p(cost / shift) : std::log(cost);
  }
  const double mean = sum / static_cast<double>(costs.size());
  return shift > 0 ? shift * std::expm1(mean)
                   : std::exp(mean);  // no cancellation for costs far below the shift
}

double PerformanceProfile::share(double tau) const {
  if (problems == 0) return 0;
  const auto within = std::ranges::upper_bound(ratios, tau) - ratios.begin();
  return static_cast<double>(within) / static_cast<double>(problems);
}

std::vector<PerformanceProfile> performance_profiles(
    const std::vector<std::vector<std::optional<double>>>& costs, double floor) {
  GCSLAB_CHECK(floor > 0);
  std::vector<PerformanceProfile> profiles(costs.empty() ? 0 : costs.front().size());
  for (const auto& of_problem : costs) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& cost : of_problem) least = std::min(least, cost ? std::max(*cost, floor) : least);
    for (std::size_t method = 0; method < of_problem.size(); ++method) {
      ++profiles[method].problems;
      if (of_problem[method]) profiles[method].ratios.push_back(std::max(*of_problem[method], floor) / least);
    }
  }
  for (PerformanceProfile& profile : profiles) std::ranges::sort(profile.ratios);
  return profiles;
}

OptionSpec solved_option() {
  return choice_option(
      "solved",
      "proved: the outcome is complete; ended: nothing is undecided, and as many solutions are "
      "found as are known",
      "proved", {"proved", "ended"});
}

Solved solved_from(const Options& options) {
  return options.word("solved") == "ended" ? Solved::ended : Solved::proved;
}

SolverComparison::SolverComparison(const RowPointers& rows) : methods_(distinct_texts(rows, "method")) {
  const std::vector<std::string> axes = axes_beside_method(rows);
  problems_ = keys_on(rows, axes);
  for (const AxisKey& key : problems_) {
    names_.push_back(key.front());
    runs_.emplace_back(methods_.size(), nullptr);
  }
  for (const Row* row : rows) {
    const auto problem = std::ranges::find(problems_, key_of(*row, axes)) - problems_.begin();
    const auto method = std::ranges::find(methods_, row->at("method")) - methods_.begin();
    runs_[static_cast<std::size_t>(problem)][static_cast<std::size_t>(method)] = row;
  }
}

bool SolverComparison::is_reference(std::size_t method) const {
  return std::ranges::any_of(
      runs_, [&](const auto& runs) { return runs[method] != nullptr && runs[method]->is_reference; });
}

bool SolverComparison::is_solved(std::size_t problem, std::size_t method, Solved criterion) const {
  const Row* row = run(problem, method);
  if (row == nullptr) return false;
  if (criterion == Solved::proved || !row->has_result()) return row->status == "complete";
  return count_of(*row, "undecided").value_or(0) == 0 && missing(problem, method) == 0 &&
         lost_roots(problem, method) == 0;
}

std::optional<double> SolverComparison::cost(std::size_t problem, std::size_t method, const ValueName& value,
                                             Solved criterion) const {
  if (!is_solved(problem, method, criterion)) return std::nullopt;
  const std::vector<double> samples = samples_of(*run(problem, method), value);
  return samples.empty() ? std::nullopt : std::optional(summarise(samples).median);
}

bool SolverComparison::is_complete(std::size_t problem) const {
  return std::ranges::none_of(runs_[problem], [](const Row* row) { return row == nullptr; });
}

std::optional<std::int64_t> SolverComparison::known_solutions(std::size_t problem) const {
  for (const Row* row : runs_[problem]) {
    if (row == nullptr) continue;
    if (const auto known = count_of(*row, "known_solutions")) return known;
  }
  return std::nullopt;
}

std::int64_t SolverComparison::missing(std::size_t problem, std::size_t method) const {
  const Row* row = run(problem, method);
  if (row == nullptr || !row->has_result()) return 0;
  const auto known = known_solutions(problem);
  const auto found = count_of(*row, "solutions");
  return known && found ? *known - *found : 0;
}

std::int64_t SolverComparison::lost_roots(std::size_t problem, std::size_t method) const {
  const Row* row = run(problem, method);
  if (row == nullptr || !row->has_result()) return 0;
  if (const auto lost = count_of(*row, "lost_roots")) return *lost;
  const bool has_undecided = count_of(*row, "undecided").value_or(0) > 0;
  return has_undecided ? 0 : std::max<std::int64_t>(0, missing(problem, method));
}

std::int64_t SolverComparison::open_roots(std::size_t problem, std::size_t method) const {
  return std::max<std::int64_t>(0, missing(problem, method) - lost_roots(problem, method));
}

std::int64_t SolverComparison::false_roots(std::size_t problem, std::size_t method) const {
  return std::max<std::int64_t>(0, -missing(problem, method));
}

}  // namespace gcslab
