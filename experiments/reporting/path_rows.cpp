#include "experiments/reporting/path_rows.h"

#include <nlohmann/json.hpp>

#include "base/error.h"

namespace gcslab {
namespace {

[[noreturn]] void fail(const FigureRequest& request, const std::string& message) {
  throw InputError(request.item.where, "'" + request.item.file + "': " + message);
}

PathRow path_row(const Row& row, const FigureRequest& request) {
  if (!row.artifact.is_object() || !row.artifact.contains("path"))
    fail(request, "the rows hold no path of " + place_text(row) +
                      "; it needs a method that follows paths, and the parameter traced_points");
  try {
    TracedPath path = traced_path_from_json(row.artifact.at("path"));
    if (path.points.empty()) fail(request, "the path of " + place_text(row) + " has no step");
    return {&row, name_of_row(row, request.rows), std::move(path), figure_picture_from_json(row.artifact)};
  } catch (const InputError& error) {
    fail(request, place_text(row) + ": " + error.what());
  }
}

}  // namespace

std::string name_of_row(const Row& row, const RowPointers& rows) {
  std::string name;
  for (const auto& [axis, text] : row.axes) {
    if (keys_on(rows, {axis}).size() > 1) name += (name.empty() ? "" : ", ") + heading_of(axis, text);
  }
  return name;
}

std::vector<PathRow> path_rows(const FigureRequest& request) {
  std::vector<PathRow> result;
  for (const Row* row : request.rows) {
    if (row->has_result()) result.push_back(path_row(*row, request));
  }
  if (result.empty()) fail(request, "no job has a path to draw");
  return result;
}

}  // namespace gcslab
