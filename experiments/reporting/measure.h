#pragma once

// What a group of rows says of one value: median and spread.
//
// A value is a count or exact number of the task ("kept_cells"), a timing ("wall_s"), a measure of the
// process
// ("peak_rss_mb"), a numeric axis ("depth"), "status", or the quotient of two of these ("wall_s/kept_cells").
// One row speaks for itself: its samples are its repetitions. Of several rows (seeds) each gives its median
// as a sample.

#include <optional>
#include <string>
#include <vector>

#include "experiments/reporting/row_table.h"

namespace gcslab {

/// The name of a value or of a quotient of values.
class ValueName {
 public:
  /// Throws InputError when the text is neither.
  explicit ValueName(const std::string& text);

  std::string text() const;
  /// Words for headings: "kept cells", "wall time", "wall time per kept cell".
  std::string heading() const;
  /// "s", "MB" or empty. A quotient has the unit of its numerator where its denominator is a pure number.
  std::string unit() const;
  /// Depends on the machine, so that it is never compared exactly.
  bool is_of_machine() const;

  const std::string& numerator() const { return numerator_; }
  const std::string& denominator() const { return denominator_; }  ///< empty: no quotient

 private:
  std::string numerator_;
  std::string denominator_;
};

struct Measure {
  double median = 0;
  double minimum = 0;
  double maximum = 0;
  double lower_quartile = 0;
  double upper_quartile = 0;
  std::size_t samples = 0;  ///< 0: the value is a text
  std::string text;         ///< the exact text of a value that is one ("1/4", a list, a status); else empty

  bool is_number() const { return samples > 0; }
};

/// The numbers that a row gives for a value; none when it has no such number.
std::vector<double> samples_of(const Row& row, const ValueName& value);

/// The value over those of the rows that have a result; nothing when none of them has the value.
std::optional<Measure> measure(const RowPointers& rows, const ValueName& value);

/// Quartiles by linear interpolation between order statistics; `samples` must not be empty.
Measure summarise(std::vector<double> samples);

/// The number that a text spells, "p/q" included.
std::optional<double> number_from_text(const std::string& text);

}  // namespace gcslab
