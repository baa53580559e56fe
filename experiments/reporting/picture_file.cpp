#include "experiments/reporting/picture_file.h"

#include <algorithm>
#include <functional>
#include <sstream>

#include "base/atomic_file.h"
#include "base/error.h"

namespace gcslab {
namespace {

namespace fs = std::filesystem;

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

void check_whole(const fs::path& path, const std::string& text, std::string_view ending) {
  if (text.find(ending, text.size() - std::min<std::size_t>(text.size(), 64)) == std::string::npos) {
    throw InputError("cannot write " + path.string() + " whole (is the disk full?)");
  }
}

std::string trimmed_number(std::string_view number) {
  if (number.find('.') == std::string_view::npos) return std::string(number);
  while (number.ends_with('0')) number.remove_suffix(1);
  if (number.ends_with('.')) number.remove_suffix(1);
  return std::string(number);
}

/// Replaces what stands between `opening` and `closing` by `change` of it, everywhere.
void replace_between(std::string& text, std::string_view opening, std::string_view closing,
                     const std::function<std::string(std::string_view)>& change) {
  std::string result;
  std::size_t done = 0;
  for (std::size_t at = text.find(opening); at != std::string::npos; at = text.find(opening, done)) {
    const std::size_t begin = at + opening.size();
    const std::size_t end = text.find(closing, begin);
    if (end == std::string::npos) break;
    result += std::string_view(text).substr(done, begin - done);
    result += change(std::string_view(text).substr(begin, end - begin));
    done = end;
  }
  text = result + text.substr(done);
}

}  // namespace

std::string shortened_path(std::string_view path) {
  std::string result;
  std::string x, y;
  std::istringstream steps{std::string(path)};
  for (std::string step; steps >> step;) {
    const std::size_t comma = step.find(',');
    if (comma == std::string::npos) {
      result += step;  // Z
      continue;
    }
    const std::string next_x = trimmed_number(std::string_view(step).substr(1, comma - 1));
    const std::string next_y = trimmed_number(std::string_view(step).substr(comma + 1));
    if (step[0] == 'L' && next_y == y) {
      result += "H" + next_x;
    } else if (step[0] == 'L' && next_x == x) {
      result += "V" + next_y;
    } else {
      result.append(1, step[0]).append(next_x).append(",").append(next_y);
    }
    x = next_x;
    y = next_y;
  }
  return result;
}

void mend_svg(const fs::path& path) {
  std::string text = read_file(path);
  check_whole(path, text, "</svg>");
  replace_all(text, "font-family=\"DejaVu Sans\"", "font-family=\"DejaVu Sans,Helvetica,Arial,sans-serif\"");
  replace_all(text, " shape-rendering='crispEdges'", "");
  replace_between(text, "<title>gnuplot_plot", "</title>", [](std::string_view) { return ""; });
  replace_all(text, "<title>gnuplot_plot</title>", "");
  replace_between(text, " d='", "'", shortened_path);
  write_file_atomically(path, text);
}

void mend_pdf(const fs::path& path) {
  std::string text = read_file(path);
  check_whole(path, text, "%%EOF");
  constexpr std::string_view kKey = "/CreationDate (D:";
  const std::size_t at = text.rfind(kKey);
  if (at != std::string::npos) text.replace(at + kKey.size(), 14, "20000101000000");
  write_file_atomically(path, text);
}

}  // namespace gcslab
