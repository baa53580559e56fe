// Table kind summary: one line a method, over all problems: outcomes, lost and false roots, and the shifted
// geometric mean of one cost.

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "base/error.h"
#include "experiments/reporting/compared_runs.h"
#include "experiments/reporting/number_format.h"

namespace gcslab {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// What the table says of one method. Means are NaN where there is nothing to average.
struct MethodSummary {
  std::int64_t problems = 0, complete = 0, partial = 0, unsolved = 0;
  std::int64_t lost = 0, open = 0, spurious = 0;
  double mean_shared = kNone;     ///< over the problems that all methods solve
  double mean_penalised = kNone;  ///< over all problems
};

/// A column: its heading, the name of its numbers in the CSV file, and what it shows.
struct SummaryColumn {
  std::string heading, name;
  std::function<double(const MethodSummary&)> number;
  bool is_mean = false;
};

class SummaryBuilder {
 public:
  SummaryBuilder(const ReportItem& item, const ReportContext& context)
      : runs_(item, context, summary_table_kind()) {}

  Table build() {
    find_shared();
    for (std::size_t method = 0; method < runs_.comparison.methods().size(); ++method)
      summaries_.push_back(summary_of(method));
    choose_columns();
    lay_out();
    write_notes();
    return std::move(table_);
  }

 private:
  bool is_time() const { return runs_.value.unit() == "s"; }
  double shift() const { return runs_.options.real("shift"); }

  /// The limit of a job, in the time that is compared.
  double limit() const {
    const bool by_cpu = runs_.value.numerator() == "cpu_s" && std::isfinite(runs_.context.limits.cpu_s);
    return by_cpu ? runs_.context.limits.cpu_s : runs_.context.limits.wall_s;
  }
  double penalty() const { return runs_.options.real("penalty") * limit(); }

  void find_shared() {
    for (std::size_t problem = 0; problem < runs_.comparison.problems(); ++problem) {
      bool by_all = true;
      for (std::size_t method = 0; method < runs_.comparison.methods().size(); ++method)
        by_all = by_all && runs_.cost(problem, method).has_value();
      if (by_all) shared_.push_back(problem);
    }
  }

  MethodSummary summary_of(std::size_t method) const {
    MethodSummary s;
    std::vector<double> penalised;
    for (std::size_t problem = 0; problem < runs_.comparison.problems(); ++problem) {
      const Row* row = runs_.comparison.run(problem, method);
      if (row == nullptr) continue;
      ++s.problems;
      ++(row->status == "complete" ? s.complete : row->has_result() ? s.partial : s.unsolved);
      s.lost += runs_.comparison.lost_roots(problem, method);
      s.open += runs_.comparison.open_roots(problem, method);
      s.spurious += runs_.comparison.false_roots(problem, method);
      penalised.push_back(runs_.cost(problem, method).value_or(penalty()));
    }
    if (!penalised.empty()) s.mean_penalised = shifted_geometric_mean(penalised, shift());
    if (!shared_.empty()) s.mean_shared = shifted_geometric_mean(shared_costs(method), shift());
    return s;
  }

  std::vector<double> shared_costs(std::size_t method) const {
    std::vector<double> costs;
    for (const std::size_t problem : shared_) costs.push_back(*runs_.cost(problem, method));
    return costs;
  }

  // ---- layout ----

  static SummaryColumn count_column(const std::string& heading, std::int64_t MethodSummary::*member) {
    return {heading, heading, [member](const MethodSummary& s) { return static_cast<double>(s.*member); }};
  }

  void choose_columns() {
    columns_ = {count_column("problems", &MethodSummary::problems),
                count_column("complete, proved", &MethodSummary::complete),
                count_column("ended without proof", &MethodSummary::partial),
                count_column("not ended", &MethodSummary::unsolved),
                count_column("lost roots", &MethodSummary::lost),
                count_column("open roots", &MethodSummary::open),
                count_column("false roots", &MethodSummary::spurious)};
    columns_.push_back({fmt::format("mean of {} that all solve", shared_.size()), "mean over shared problems",
                        [](const MethodSummary& s) { return s.mean_shared; }, true});
    if (is_time())
      columns_.push_back({"mean of all, with penalty", "mean over all problems with penalty",
                          [](const MethodSummary& s) { return s.mean_penalised; }, true});
  }

  Scale scale_of_means() const {
    std::vector<double> means;
    for (const MethodSummary& s : summaries_) means.insert(means.end(), {s.mean_shared, s.mean_penalised});
    return scale_for(runs_.value.unit(), means);
  }

  void lay_out() {
    const Scale scale = scale_of_means();
    table_.caption = runs_.item.caption.empty() ? runs_.context.title : runs_.item.caption;
    table_.head_names = {"method"};
    table_.record_axes = {"method"};
    for (const SummaryColumn& column : columns_) {
      const bool has_unit = column.is_mean && !scale.unit.empty();
      table_.column_heads.push_back({column.heading + (has_unit ? " [" + scale.unit + "]" : "")});
    }
    TableBlock block;
    for (std::size_t method = 0; method < summaries_.size(); ++method)
      block.lines.push_back(line_of(method, scale));
    table_.blocks.push_back(std::move(block));
  }

  TableLine line_of(std::size_t method, const Scale& scale) {
    TableLine line{{runs_.comparison.methods()[method]}, {}};
    for (const SummaryColumn& column : columns_) {
      const double number = column.number(summaries_[method]);
      const double shown = column.is_mean ? number * scale.factor : number;
      TableCell cell;
      cell.text = std::isnan(number) ? "–"
                  : column.is_mean   ? format_significant(shown, 3)
                                     : format_count(shown);
      cell.best = column.is_mean && is_best(method, column);
      line.cells.push_back(std::move(cell));
      add_record(method, column, number);
    }
    return line;
  }

  /// Least of the rigorous methods of this run.
  bool is_best(std::size_t method, const SummaryColumn& column) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t other = 0; other < summaries_.size(); ++other) {
      const double number = column.number(summaries_[other]);
      if (may_be_best(other) && !std::isnan(number)) least = std::min(least, number);
    }
    return may_be_best(method) && column.number(summaries_[method]) == least;
  }

  bool may_be_best(std::size_t method) const {
    const std::string& name = runs_.comparison.methods()[method];
    return !runs_.comparison.is_reference(method) &&
           std::ranges::find(runs_.context.baselines, name) == runs_.context.baselines.end();
  }

  void add_record(std::size_t method, const SummaryColumn& column, double number) {
    const std::string unit = column.is_mean ? runs_.value.unit() : "";
    const std::size_t samples = std::isnan(number) ? 0 : 1;
    table_.records.push_back({{runs_.comparison.methods()[method]},
                              column.name,
                              unit,
                              "",
                              number,
                              number,
                              number,
                              samples,
                              "",
                              ""});
  }

  // ---- what the reader must know ----

  void note(const std::string& sentence) { table_.notes.push_back(sentence); }

  std::string in_unit(double number) const {
    return format_number(number) + (runs_.value.unit().empty() ? "" : " " + runs_.value.unit());
  }

  void write_notes() {
    note(
        "Complete, proved: every solution found, with proof that none is missing. Ended without proof: boxes "
        "are left undecided, or the method proves nothing. Not ended: time or memory ran out, or not "
        "applicable.");
    note(
        "Lost roots: known ones that a run which left nothing undecided did not find, or that are known to "
        "lie in no box of its answer. Open roots: other known ones without certificate, which may lie in "
        "boxes left undecided. False roots: more solutions than are known.");
    note(fmt::format(
        "Means: shifted geometric means of the {}, shift {}{}.", runs_.value.heading(), in_unit(shift()),
        is_time()
            ? fmt::format("; with penalty: a problem that is not solved counts as {}", in_unit(penalty()))
            : ""));
    if (runs_.solved == Solved::ended)
      note("Solved, for the means: nothing undecided, and as many solutions found as are known.");
    note("Bold: least of the methods" + baselines_text() + ".");
    const std::string machine = machine_text(runs_.context.rows);
    if (runs_.value.is_of_machine() && !machine.empty()) note("Measured on one machine (" + machine + ").");
    for (const std::string& sentence : notes_on_references(runs_.context, runs_.item)) note(sentence);
  }

  std::string baselines_text() const {
    std::string names;
    for (const std::string& name : runs_.comparison.methods()) {
      if (std::ranges::find(runs_.context.baselines, name) != runs_.context.baselines.end())
        names += (names.empty() ? "" : ", ") + name;
    }
    return names.empty() ? "" : "; baselines, which are not rigorous, take no part (" + names + ")";
  }

  ComparedRuns runs_;
  std::vector<std::size_t> shared_;
  std::vector<MethodSummary> summaries_;
  std::vector<SummaryColumn> columns_;
  Table table_;
};

}  // namespace

TableKind summary_table_kind() {
  return {"summary",
          "one line a method: outcomes, lost and false roots, shifted geometric mean",
          {solved_option(),
           real_option("shift", "of the geometric mean, in the unit of the value", "", 0.01, 0, 1e9),
           real_option("penalty", "an unsolved problem counts as this many times the limit", "", 2, 1, 1e6)},
          [](const ReportItem& item, const ReportContext& context) {
            return SummaryBuilder(item, context).build();
          }};
}

}  // namespace gcslab
