// Table kind against: every problem by the methods of this run, against the better of another program's
// figures; below, the shifted geometric means over the problems that both solve.

#include <algorithm>
#include <fmt/format.h>
#include <limits>

#include "base/error.h"
#include "experiments/reporting/compared_runs.h"
#include "experiments/reporting/number_format.h"

namespace gcslab {
namespace {

/// A method of this run against the references.
struct Rivalry {
  std::vector<double> here, there;  ///< costs over the problems that both solve
  std::string only_there, only_here;
};

class AgainstBuilder {
 public:
  AgainstBuilder(const ReportItem& item, const ReportContext& context)
      : runs_(item, context, against_table_kind()) {}

  Table build() {
    if (runs_.item.references.empty())
      throw InputError(runs_.item.where,
                       "'" + runs_.item.file + "': a table of kind against needs references");
    for (std::size_t method = 0; method < runs_.comparison.methods().size(); ++method)
      (runs_.comparison.is_reference(method) ? theirs_ : ours_).push_back(method);
    lay_out();
    for (const std::size_t method : ours_) rivalries_.push_back(rivalry_of(method));
    add_means();
    write_notes();
    return std::move(table_);
  }

 private:
  using Cost = std::optional<double>;

  Cost cost(std::size_t problem, std::size_t method) const { return runs_.cost(problem, method); }

  /// The least cost of the other program, however it was run.
  Cost best_of_theirs(std::size_t problem) const {
    Cost best;
    for (const std::size_t method : theirs_) {
      const Cost given = cost(problem, method);
      if (given && (!best || *given < *best)) best = given;
    }
    return best;
  }

  bool has_figure(std::size_t problem) const {
    return std::ranges::any_of(theirs_,
                               [&](std::size_t m) { return runs_.comparison.run(problem, m) != nullptr; });
  }

  Rivalry rivalry_of(std::size_t method) const {
    Rivalry rivalry;
    for (std::size_t problem = 0; problem < runs_.comparison.problems(); ++problem) {
      if (!has_figure(problem)) continue;
      const Cost here = cost(problem, method), there = best_of_theirs(problem);
      const std::string name = heading_of("problem", runs_.comparison.problem_name(problem));
      if (here && there) {
        rivalry.here.push_back(*here);
        rivalry.there.push_back(*there);
      } else if (here || there) {
        std::string& list = here ? rivalry.only_here : rivalry.only_there;
        list += (list.empty() ? "" : ", ") + name;
      }
    }
    return rivalry;
  }

  // ---- problem by problem ----

  void lay_out() {
    table_.caption = runs_.item.caption.empty() ? runs_.context.title : runs_.item.caption;
    table_.head_names = {"problem"};
    table_.record_axes = {"problem", "method"};
    table_.column_heads = {{"better of the references (not the same run)", value_heading()}};
    for (const std::size_t method : ours_) {
      table_.column_heads.push_back({runs_.comparison.methods()[method], value_heading()});
      table_.column_heads.push_back({runs_.comparison.methods()[method], "ratio"});
    }
    TableBlock block{"problem by problem", {}};
    for (std::size_t problem = 0; problem < runs_.comparison.problems(); ++problem) {
      if (has_figure(problem)) block.lines.push_back(line_of(problem));
    }
    table_.blocks.push_back(std::move(block));
  }

  std::string value_heading() const {
    return runs_.value.unit().empty() ? runs_.value.heading()
                                      : runs_.value.heading() + " [" + runs_.value.unit() + "]";
  }

  TableLine line_of(std::size_t problem) {
    const std::string& name = runs_.comparison.problem_name(problem);
    TableLine line{{heading_of("problem", name)}, {}};
    const Cost there = best_of_theirs(problem);
    line.cells.push_back(cell_of(there, outcome_of_theirs(problem)));
    record(name, "better of the references", runs_.value.text(), runs_.value.unit(), there);
    for (const std::size_t method : ours_) {
      const Row* row = runs_.comparison.run(problem, method);
      const Cost here = cost(problem, method);
      line.cells.push_back(cell_of(here, row == nullptr ? "–" : outcome_word(*row)));
      const Cost ratio = here && there && *there > 0 ? Cost(*here / *there) : std::nullopt;
      line.cells.push_back(cell_of(ratio, "–"));
      record(name, runs_.comparison.methods()[method], runs_.value.text(), runs_.value.unit(), here);
      record(name, runs_.comparison.methods()[method], "ratio to the better reference", "", ratio);
    }
    return line;
  }

  static TableCell cell_of(const Cost& number, const std::string& otherwise) {
    TableCell cell;
    cell.text = number ? format_number(*number) : otherwise;
    return cell;
  }

  /// Of a problem that the other program does not solve: how its first run ended.
  std::string outcome_of_theirs(std::size_t problem) const {
    for (const std::size_t method : theirs_) {
      if (const Row* row = runs_.comparison.run(problem, method)) return outcome_word(*row);
    }
    return "–";
  }

  void record(const std::string& problem, const std::string& method, const std::string& value,
              const std::string& unit, const Cost& number) {
    const double shown = number.value_or(std::numeric_limits<double>::quiet_NaN());
    const std::size_t samples = number ? 1 : 0;
    table_.records.push_back({{problem, method}, value, unit, "", shown, shown, shown, samples, "", ""});
  }

  // ---- means ----

  double mean(const std::vector<double>& costs) const {
    return shifted_geometric_mean(costs, runs_.options.real("shift"));
  }

  void add_means() {
    TableBlock block{"over the problems solved by both", {}};
    const std::string unit = runs_.value.unit().empty() ? "" : " [" + runs_.value.unit() + "]";
    block.lines = {mean_line("problems", [](const Rivalry& r) { return static_cast<double>(r.here.size()); }),
                   mean_line("mean here" + unit, [this](const Rivalry& r) { return mean(r.here); }),
                   mean_line("mean there" + unit, [this](const Rivalry& r) { return mean(r.there); }),
                   mean_line("mean here / mean there",
                             [this](const Rivalry& r) { return mean(r.here) / mean(r.there); })};
    table_.blocks.push_back(std::move(block));
  }

  TableLine mean_line(const std::string& head, const std::function<double(const Rivalry&)>& number) {
    TableLine line{{head}, {TableCell{}}};
    for (std::size_t i = 0; i < ours_.size(); ++i) {
      const bool any = !rivalries_[i].here.empty();
      const Cost shown = any || head == "problems" ? Cost(number(rivalries_[i])) : std::nullopt;
      line.cells.push_back(cell_of(shown, "–"));
      line.cells.push_back(TableCell{});
      record("all solved by both", runs_.comparison.methods()[ours_[i]], head, "", shown);
    }
    return line;
  }

  // ---- what the reader must know ----

  void note(const std::string& sentence) { table_.notes.push_back(sentence); }

  void write_notes() {
    std::string names;
    for (const std::size_t method : theirs_)
      names += (names.empty() ? "" : ", ") + runs_.comparison.methods()[method];
    note("References: " + names + "; of each problem the run that solves it with the lesser " +
         runs_.value.heading() + ". Ratio: this run over that.");
    note(fmt::format("Means: shifted geometric means, shift {}{}.",
                     format_number(runs_.options.real("shift")),
                     runs_.value.unit().empty() ? "" : " " + runs_.value.unit()));
    for (std::size_t i = 0; i < ours_.size(); ++i) {
      const std::string& name = runs_.comparison.methods()[ours_[i]];
      note("Solved there and not by " + name + ": " + none_or(rivalries_[i].only_there) + ".");
      note("Solved by " + name + " and not there: " + none_or(rivalries_[i].only_here) + ".");
    }
    const std::string machine = machine_text(runs_.context.rows);
    if (runs_.value.is_of_machine() && !machine.empty()) note("This run: one machine (" + machine + ").");
    for (const std::string& sentence : notes_on_references(runs_.context, runs_.item)) note(sentence);
  }

  static std::string none_or(const std::string& names) { return names.empty() ? "none" : names; }

  ComparedRuns runs_;
  std::vector<std::size_t> ours_, theirs_;
  std::vector<Rivalry> rivalries_;
  Table table_;
};

}  // namespace

TableKind against_table_kind() {
  return {"against",
          "problems by the methods of this run, against the better figure of another program, with means",
          {solved_option(),
           real_option("shift", "of the geometric mean, in the unit of the value", "", 0.01, 0, 1e9)},
          [](const ReportItem& item, const ReportContext& context) {
            return AgainstBuilder(item, context).build();
          }};
}

}  // namespace gcslab
