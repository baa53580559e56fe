// Table kind basins: which figures, up to isometry, methods reach on how many jobs, such as from how many
// random sketches. One block a problem, one line a figure that some job has certified.

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "experiments/reporting/class_alignment.h"
#include "experiments/reporting/report_context.h"
#include "experiments/reporting/table_kind.h"
#include "experiments/runner/report_item.h"

namespace gcslab {
namespace {

class BasinsBuilder {
 public:
  BasinsBuilder(const ReportItem& item, const ReportContext& context)
      : item_(item), context_(context), rows_(context, item) {
    for (const AxisKey& key : keys_on(rows_.all(), {"method"})) methods_.push_back(key.front());
  }

  Table build() {
    table_.caption = item_.caption.empty() ? context_.title : item_.caption;
    table_.head_names = {"figure"};
    table_.record_axes = {"problem", "method"};
    for (const std::string& method : methods_) table_.column_heads.push_back({method});
    for (const AxisKey& key : keys_on(rows_.all(), {"problem"}))
      table_.blocks.push_back(block_of(key.front(), rows_at(rows_.all(), {"problem"}, key)));
    table_.notes.emplace_back(
        "Numbers of jobs that reach a figure; a job may reach several. Figures that some job has certified "
        "are "
        "told apart, the most often reached first; the others are put together.");
    return std::move(table_);
  }

 private:
  /// Of one problem: the jobs, and which of them reach each class.
  struct Reach {
    RowPointers jobs;
    std::vector<FigurePicture> pictures;
    std::vector<AlignedLine> classes;

    bool is_certified(const AlignedLine& line) const {
      for (std::size_t job = 0; job < jobs.size(); ++job) {
        if (line[job] && pictures[job].figures[*line[job]].is_certified) return true;
      }
      return false;
    }
    std::size_t times(const AlignedLine& line) const {
      return static_cast<std::size_t>(
          std::ranges::count_if(line, [](const auto& figure) { return figure.has_value(); }));
    }
  };

  Reach reach_of(const RowPointers& rows) const {
    Reach reach;
    for (const Row* row : rows) {
      if (!row->has_result()) continue;
      reach.jobs.push_back(row);
      try {
        reach.pictures.push_back(figure_picture_from_json(row->artifact));
      } catch (const InputError& error) {
        throw InputError(item_.where, "'" + item_.file + "': " + row->at("problem") + ": " + error.what());
      }
    }
    std::vector<const FigurePicture*> columns;
    for (const FigurePicture& picture : reach.pictures) columns.push_back(&picture);
    reach.classes = aligned_classes(columns);
    return reach;
  }

  /// How many jobs of each method a condition holds for.
  template <class Condition>
  TableLine counted(const std::string& problem, const std::string& head, const Reach& reach,
                    const Condition& holds) {
    TableLine line{{head}, {}};
    for (const std::string& method : methods_) {
      std::size_t count = 0;
      for (std::size_t job = 0; job < reach.jobs.size(); ++job)
        count += static_cast<std::size_t>(reach.jobs[job]->at("method") == method && holds(job));
      add(line, problem, method, head, count);
    }
    return line;
  }

  void add(TableLine& line, const std::string& problem, const std::string& method, const std::string& what,
           std::size_t count) {
    TableCell cell;
    cell.text = count == 0 ? "–" : std::to_string(count);
    line.cells.push_back(std::move(cell));
    const auto number = static_cast<double>(count);
    table_.records.push_back({{problem, method}, what, "", "", number, number, number, 1, "", ""});
  }

  TableBlock block_of(const std::string& problem, const RowPointers& rows) {
    const Reach reach = reach_of(rows);
    std::vector<AlignedLine> regular, singular;
    for (const AlignedLine& line : reach.classes)
      (reach.is_certified(line) ? regular : singular).push_back(line);
    std::ranges::stable_sort(regular, std::ranges::greater{},
                             [&](const AlignedLine& line) { return reach.times(line); });
    TableBlock block{heading_of("problem", problem), {}};
    for (std::size_t k = 0; k < regular.size(); ++k)
      block.lines.push_back(counted(problem, fmt::format("{}", k + 1), reach,
                                    [&](std::size_t job) { return regular[k][job].has_value(); }));
    const auto has_one_of = [&](const std::vector<AlignedLine>& lines, std::size_t job) {
      return std::ranges::any_of(lines, [&](const AlignedLine& line) { return line[job].has_value(); });
    };
    if (!singular.empty())
      block.lines.push_back(counted(problem, "singular figures", reach,
                                    [&](std::size_t job) { return has_one_of(singular, job); }));
    block.lines.push_back(counted(problem, "none", reach,
                                  [&](std::size_t job) { return reach.pictures[job].figures.empty(); }));
    block.lines.push_back(different(problem, reach, regular));
    block.lines.push_back(counted(problem, "jobs", reach, [](std::size_t) { return true; }));
    return block;
  }

  TableLine different(const std::string& problem, const Reach& reach,
                      const std::vector<AlignedLine>& regular) {
    TableLine line{{"different figures, certified"}, {}};
    for (const std::string& method : methods_) {
      const auto is_reached = [&](const AlignedLine& figure) {
        for (std::size_t job = 0; job < reach.jobs.size(); ++job) {
          if (figure[job] && reach.jobs[job]->at("method") == method) return true;
        }
        return false;
      };
      add(line, problem, method, line.heads.front(),
          static_cast<std::size_t>(std::ranges::count_if(regular, is_reached)));
    }
    return line;
  }

  const ReportItem& item_;
  const ReportContext& context_;
  SelectedRows rows_;
  std::vector<std::string> methods_;
  Table table_;
};

}  // namespace

TableKind basins_table_kind() {
  return {"basins",
          "which figures of constraint systems methods reach, on how many jobs",
          {},
          [](const ReportItem& item, const ReportContext& context) {
            return BasinsBuilder(item, context).build();
          }};
}

}  // namespace gcslab
