#include "experiments/reporting/figure_registry.h"

#include <fmt/format.h>
#include <map>

#include "base/error.h"

namespace gcslab {
namespace {

Options read_options(const ReportItem& item, const FigureKind& kind) {
  std::map<std::string, std::string> given;
  for (const auto& [name, value] : item.options) {
    given[name] = value.text;
    try {
      static_cast<void>(Options(kind.options, {{name, value.text}}, kind.name));
    } catch (const InputError& error) {
      throw InputError(value.where, error.what());
    }
  }
  return {kind.options, given, kind.name};
}

const FigureKind& kind_of(const ReportItem& item) {
  try {
    return figure_kinds().at(item.kind);
  } catch (const InputError& error) {
    throw InputError(item.where, error.what());
  }
}

}  // namespace

const Registry<FigureKind>& figure_kinds() {
  static const Registry<FigureKind> kinds("kind of figure", {
                                                                cover_panels_kind(),
                                                                boxes_kind(),
                                                                range_bars_kind(),
                                                                series_kind(),
                                                                drawing_kind(),
                                                                figures_kind(),
                                                                paths_kind(),
                                                                deformation_kind(),
                                                                distribution_kind(),
                                                                performance_profile_kind(),
                                                                plan_graph_kind(),
                                                                ray_panels_kind(),
                                                            });
  return kinds;
}

void check_figure(const ReportItem& item) { static_cast<void>(read_options(item, kind_of(item))); }

FigureScript draw_figure(const ReportItem& item, const ReportContext& context) {
  const FigureKind& kind = kind_of(item);
  const SelectedRows rows(context, item);
  FigureScript figure = kind.draw({item, context, rows.all(), read_options(item, kind)});
  for (std::string& note : notes_on_references(context, item)) figure.notes.push_back(std::move(note));
  return figure;
}

OptionSpec width_option(const std::string& default_width) {
  return {.name = "width",
          .meaning = "one column of a journal (84 mm) or its page (174 mm)",
          .default_value = default_width,
          .choices = {"column", "page"}};
}

double width_from(const Options& options) {
  return options.word("width") == "column" ? kColumnWidth : kPageWidth;
}

std::vector<std::string> notes_on_missing(const RowPointers& rows) {
  constexpr std::size_t kMostNamed = 3;
  std::map<std::pair<std::string, std::string>, RowPointers> groups;  // by method and outcome
  for (const Row* row : rows) {
    if (row->has_result()) continue;
    groups[{row->at("method"), outcome_word(*row) + (row->reason.empty() ? "" : ": " + row->reason)}]
        .push_back(row);
  }
  std::vector<std::string> notes;
  for (const auto& [group, members] : groups) {
    std::string places = fmt::format("{}, {} jobs", group.first, members.size());
    if (members.size() <= kMostNamed) {
      places.clear();
      for (const Row* row : members) places += (places.empty() ? "" : "; ") + place_text(*row);
    }
    notes.push_back("Not drawn: " + places + " (" + group.second + ").");
  }
  return notes;
}

}  // namespace gcslab
