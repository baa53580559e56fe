#include <cmath>
#include <fmt/format.h>

#include "experiments/reporting/escape.h"
#include "experiments/reporting/table_writers.h"

namespace gcslab {
namespace {

std::string number_text(double number) { return std::isnan(number) ? "" : fmt::format("{}", number); }

std::string record_line(const TableRecord& record) {
  std::string line;
  for (const std::string& text : record.key) line += escape_csv(text) + ",";
  line += escape_csv(record.value) + "," + escape_csv(record.unit);
  const bool has_number = record.samples > 0;
  for (const double number : {record.median, record.minimum, record.maximum}) {
    line += "," + (has_number ? number_text(number) : "");
  }
  line += fmt::format(",{},", record.samples) + escape_csv(record.text);
  return line + "," + escape_csv(record.status) + "," + escape_csv(record.reason) + "\n";
}

}  // namespace

std::string csv_text(const Table& table) {
  std::string text;
  for (const std::string& axis : table.record_axes) text += escape_csv(axis) + ",";
  text += "value,unit,median,min,max,samples,text,status,reason\n";
  for (const TableRecord& record : table.records) text += record_line(record);
  return text;
}

}  // namespace gcslab
