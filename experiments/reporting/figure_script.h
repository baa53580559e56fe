#pragma once

// A figure as data blocks and gnuplot commands; gnuplot.h turns it into files.
//
// Lengths are millimetres from the lower left corner of the figure, font sizes points as printed.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gcslab {

/// Width of one column of a journal, and of its whole page.
inline constexpr double kColumnWidth = 84;
inline constexpr double kPageWidth = 174;

/// No text is smaller than the first, in points.
inline constexpr double kSmallText = 7;
inline constexpr double kTitleText = 8;
inline constexpr double kMillimetresPerPoint = 25.4 / 72;

/// The rectangle between the axes of a panel.
struct PanelBox {
  double left = 0, bottom = 0, width = 0, height = 0;

  double right() const { return left + width; }
  double top() const { return bottom + height; }
  double centre() const { return left + width / 2; }
};

struct TextStyle {
  std::string_view alignment = "left";  ///< left, center or right of the point
  double size = kSmallText;
  std::string_view colour = "#202020";
  bool upwards = false;  ///< turned by 90 degrees
};

class FigureScript {
 public:
  double width = kPageWidth;
  double height = 0;
  std::vector<std::string> notes;  ///< sentences for the caption

  /// Adds a block of data lines; blank lines in it separate its parts. Returns its number for `index`.
  std::size_t add_data(std::string_view comment, std::string_view lines);
  /// Adds a line to the script.
  void command(std::string_view line);

  /// Sets the margins so that the axes of the next plot are `box`.
  void place(const PanelBox& box);
  /// Writes a text; it appears with the next plot.
  void text(double x, double y, std::string_view words, const TextStyle& style = {});
  /// Draws a straight line between two places of the figure; it appears with the next plot.
  void rule(double x0, double y0, double x1, double y1, std::string_view style);
  /// Removes the texts and rules that have appeared, before the next panel.
  void clear_texts() { command("unset label; unset arrow"); }

  const std::string& data() const { return data_; }
  const std::string& commands() const { return commands_; }

 private:
  std::string position(double x, double y) const;

  std::string data_;
  std::string commands_;
  std::size_t blocks_ = 0;
};

/// The width that a text takes, in millimetres; an estimate from mean widths of DejaVu Sans.
double text_width(std::string_view words, double size = kSmallText);

/// How many of `count` panels stand in a line when at most `most` can and all lines are about equally long.
std::size_t even_line(std::size_t count, std::size_t most);

/// The text in lines that fit the width, broken between words.
std::vector<std::string> wrapped(std::string_view words, double width, double size = kSmallText);

/// The number with the digits that a drawing can show.
std::string plot_number(double number);

}  // namespace gcslab
