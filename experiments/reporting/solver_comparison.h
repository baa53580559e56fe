#pragma once

// What runs of several methods on the same problems say of the methods.
//
// Shifted geometric mean of t_1 ... t_n with shift s: exp(mean of log(t_i + s)) - s (Achterberg 2007,
// Constraint integer programming, appendix A.3). Against the plain geometric mean, the shift keeps
// differences far below it from counting.
//
// Performance profile (Dolan, More 2002, Math. Program. 91:201): the ratio r(p, m) is the cost of method m on
// problem p over the least cost of any method that solves p; the profile of m at tau is the share of all
// problems with r(p, m) <= tau. A problem that m does not solve has no ratio; one that no method solves
// counts among all problems.

#include <optional>
#include <string>
#include <vector>

#include "base/option.h"
#include "experiments/reporting/measure.h"

namespace gcslab {

/// Costs are not negative and the shift is positive, or costs are positive. There is at least one.
double shifted_geometric_mean(const std::vector<double>& costs, double shift);

/// The ratios of one method, ascending, and how many problems there are in all.
struct PerformanceProfile {
  std::vector<double> ratios;
  std::size_t problems = 0;

  /// The share of problems solved within `tau` times the least cost.
  double share(double tau) const;
};

/// costs[problem][method]; nothing where the method does not solve the problem. Costs below `floor` (> 0) are
/// taken as it. One profile a method.
std::vector<PerformanceProfile> performance_profiles(
    const std::vector<std::vector<std::optional<double>>>& costs, double floor);

/// What a problem counts as solved by.
enum class Solved {
  proved,  ///< the outcome `complete`: all solutions, with proof that none is missing
  ended    ///< nothing undecided, and as many solutions as are known: what a baseline can achieve at best
};

/// The option `solved`, with the default `proved`.
OptionSpec solved_option();
Solved solved_from(const Options& options);

/// The runs of a group of rows: of each method on each problem at most one (seeds and parameters tell
/// problems apart too).
class SolverComparison {
 public:
  explicit SolverComparison(const RowPointers& rows);

  const std::vector<std::string>& methods() const { return methods_; }
  std::size_t problems() const { return problems_.size(); }
  /// The problem's corpus name, without seed and parameters.
  std::string problem_name(std::size_t problem) const { return names_[problem]; }

  /// Null where there is no such job or figure.
  const Row* run(std::size_t problem, std::size_t method) const { return runs_[problem][method]; }
  bool is_reference(std::size_t method) const;

  bool is_solved(std::size_t problem, std::size_t method, Solved criterion) const;
  /// The median of the value where the problem is solved.
  std::optional<double> cost(std::size_t problem, std::size_t method, const ValueName& value,
                             Solved criterion) const;
  /// Every method has a run, or a figure.
  bool is_complete(std::size_t problem) const;

  /// How many solutions are known by other means, when any run of the problem says so.
  std::optional<std::int64_t> known_solutions(std::size_t problem) const;
  /// Known roots that a run which ended with nothing undecided did not find (or those that the row itself
  /// names): they are lost.
  std::int64_t lost_roots(std::size_t problem, std::size_t method) const;
  /// Known roots not certified by a run that ended with undecided boxes, where they may be.
  std::int64_t open_roots(std::size_t problem, std::size_t method) const;
  /// Solutions beyond the known ones.
  std::int64_t false_roots(std::size_t problem, std::size_t method) const;

 private:
  /// Known minus found of a run that ended; 0 when that cannot be told.
  std::int64_t missing(std::size_t problem, std::size_t method) const;

  std::vector<std::string> methods_;
  std::vector<AxisKey> problems_;
  std::vector<std::string> names_;
  std::vector<std::vector<const Row*>> runs_;  ///< [problem][method]
};

}  // namespace gcslab
