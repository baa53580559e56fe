#pragma once

// Small rows, configs and folders for the tests of reports.

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <unistd.h>
#include <vector>

#include "experiments/reporting/report_context.h"
#include "experiments/runner/report_item.h"

namespace gcslab {

/// A complete row with counts and three repetitions of about `wall_s`.
inline Row sample_row(const std::string& problem, const std::string& method, double kept, double wall_s,
                      const std::string& depth = "8", const std::string& seed = "1") {
  Row row;
  row.job = problem + "-" + method + "-" + depth + "-" + seed;
  row.axes = {{"problem", problem}, {"method", method}, {"depth", depth}, {"seed", seed}};
  row.status = "complete";
  row.values["kept_cells"] = static_cast<std::int64_t>(kept);
  row.timings["wall_s"] = {wall_s, 1.5 * wall_s, 0.5 * wall_s};
  row.peak_rss_mb = 10;
  row.provenance = {{"cpu", "a processor"}, {"compiler", "gcc 12"}, {"commit", "0123abc"}};
  return row;
}

inline Row with_outcome(Row row, const std::string& status, const std::string& reason) {
  row.status = status;
  row.reason = reason;
  row.values = Json::object();
  row.timings = Json::object();
  row.artifact = nullptr;
  return row;
}

inline ReportContext sample_context(std::vector<Row> rows) {
  return {"sample",
          "A sample",
          "made up",
          3,
          {},
          {},
          RowTable({"problem", "method", "depth", "seed"}, std::move(rows)),
          {}};
}

inline ReportItem sample_item(const std::string& file, std::vector<std::string> rows,
                              std::vector<std::string> columns, std::vector<std::string> values) {
  ReportItem item;
  item.where = {"sample.yaml", 12};
  item.file = file;
  item.rows = std::move(rows);
  item.columns = std::move(columns);
  item.values = std::move(values);
  return item;
}

inline void set_option(ReportItem& item, const std::string& name, const std::string& value) {
  item.options[name] = PlacedText{value, {"sample.yaml", 14}};
}

/// A folder that goes with this object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "gcslab-report-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace gcslab
