#pragma once

// Figures of many equal panels over boxes of two variables: one line of panels a row key, one panel a column
// key, with the outcome in words where a job has no result.

#include <optional>
#include <string>
#include <vector>

#include "experiments/reporting/figure.h"
#include "interval/interval.h"

namespace gcslab {

class PanelGrid {
 public:
  /// Where the item names no axes there is one line a problem and one panel a method.
  explicit PanelGrid(const FigureRequest& request);
  virtual ~PanelGrid() = default;
  PanelGrid(const PanelGrid&) = delete;
  PanelGrid& operator=(const PanelGrid&) = delete;

  FigureScript draw();

 protected:
  /// What a row with a result shows: a box of two variables. Throws InputError when the row holds nothing
  /// that can be drawn.
  virtual Box domain_of(const Row& row) = 0;
  virtual void draw_panel(const Row& row, const PanelBox& panel, bool vertical_tics) = 0;
  /// The counts below a panel, in words that fit `room` millimetres.
  virtual std::string counts_text(const Row& row, double room) const = 0;
  /// What stands in the caption before and after the jobs that are not drawn.
  virtual std::vector<std::string> leading_notes() const = 0;
  virtual std::vector<std::string> closing_notes() const = 0;

  [[noreturn]] void fail(const std::string& message) const;
  bool shows_counts() const { return request_.options.flag("counts"); }

  const FigureRequest& request_;
  FigureScript figure_;

 private:
  /// The panels that stand side by side: some columns of one row key.
  struct Line {
    std::vector<const Row*> rows;  ///< null: no such job
    std::vector<std::string> titles;
    std::string label;
    std::vector<std::optional<Box>> domains;
    double aspect = 0;  ///< height over width of the tallest panel
    bool has_titles = true;
  };
  double title_height(const Line& line) const;
  double number_width() const;

  void collect_lines();
  std::size_t panels_per_line(std::size_t count) const;
  Line line_of(const std::vector<std::string>& axes, const AxisKey& row_key,
               const std::vector<AxisKey>& columns);
  static std::string joined(const std::vector<std::string>& axes, const AxisKey& key);
  void lay_out();
  void write_title(const PanelBox& box, const std::string& title);
  static bool has_vertical_tics(const Line& line, std::size_t column);
  PanelBox box_of(const Line& line, double top, std::size_t column) const;
  void draw_line(const Line& line, double top);
  void draw_outcome(const Row* row, const PanelBox& box);
  void write_notes();

  const ReportItem& item_;
  std::vector<std::string> row_axes_;
  std::vector<std::string> column_axes_;
  std::vector<Line> lines_;
  std::vector<double> tops_;
  std::size_t columns_ = 1;
  double left_ = 0;
  double gap_ = 0;
  double panel_width_ = 0;
  bool has_row_labels_ = false;
  bool draws_first_seed_ = false;
};

/// The option panels_per_line of such figures.
OptionSpec panels_per_line_option();

}  // namespace gcslab
