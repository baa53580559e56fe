#include "experiments/reporting/gnuplot.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <stdexcept>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "experiments/reporting/palette.h"
#include "experiments/reporting/picture_file.h"

namespace gcslab {
namespace {

namespace fs = std::filesystem;

constexpr double kTimeout = 120;
constexpr double kPixelsPerMillimetre = 96 / 25.4;

// ---- the script ----

/// Terminal settings under which a font size is points and a line width of 1 is one point, in both formats.
std::string terminal_lines(const FigureScript& figure, const std::string& file) {
  std::string text = "if (!exists(\"format\")) format = \"pdf\"\n";
  text += fmt::format(
      "if (format eq \"svg\") set terminal svg size {:.0f},{:.0f} font 'DejaVu Sans,{}' fontscale 1.3333 "
      "linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'\n",
      figure.width * kPixelsPerMillimetre, figure.height * kPixelsPerMillimetre, kSmallText);
  text += fmt::format(
      "if (format eq \"pdf\") set terminal pdfcairo size {:.2f}cm,{:.2f}cm font 'DejaVu Sans,{}' fontscale "
      "0.75 "
      "linewidth 2 dashlength 0.5 enhanced\n",
      figure.width / 10, figure.height / 10, kSmallText);
  return text + fmt::format("set output '{}.'.format\ndata = '{}.dat'\n", file, file);
}

std::string style_lines() {
  return fmt::format(
      "set encoding utf8\nset minussign\nunset key\nset border 15 lw 0.5 lc rgb '{}' front\n"
      "set tics nomirror scale 0.4,0.2 textcolor rgb '{}'\nset xtics offset 0,0.3\nset ytics offset 0.4,0\n",
      palette::kFrame, palette::kText);
}

std::string one_line(std::string text) {
  for (char& c : text) c = c == '\n' ? ' ' : c;
  return text;
}

// ---- running gnuplot ----

[[noreturn]] void become(const std::vector<std::string>& command, const fs::path& folder, int error_output) {
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const int nothing = ::open("/dev/null", O_RDWR);
  ::dup2(nothing, 0);
  ::dup2(nothing, 1);
  ::dup2(error_output, 2);
  if (::chdir(folder.c_str()) == 0) ::execvp(arguments[0], arguments.data());
  ::_exit(errno == ENOENT ? 127 : 126);
}

/// Reads until the other end closes; false when the time is over before.
bool read_all(int descriptor, std::string& text, double timeout_s) {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::duration<double>(timeout_s);
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return false;
    pollfd waiting{descriptor, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, static_cast<int>(left));
    if (ready < 0 && errno != EINTR) return false;
    if (ready <= 0) continue;
    char buffer[4096];
    const ssize_t count = ::read(descriptor, buffer, sizeof buffer);
    if (count <= 0) return true;
    text.append(buffer, static_cast<std::size_t>(count));
  }
}

void complain(const ProgramEnd& end, const fs::path& script) {
  if (end.exit_code == 127) {
    throw InputError(
        "gnuplot is not installed: figures need the package gnuplot-nox (apt-get install gnuplot-nox), "
        "or ask for tables alone with --format md,tex,csv");
  }
  const std::string cause = end.timed_out ? fmt::format("took longer than {} s", kTimeout)
                                          : fmt::format("ended with code {}", end.exit_code);
  throw std::runtime_error(fmt::format("gnuplot {} on {}: {}", cause, script.string(), end.error_text));
}

void draw(const fs::path& folder, const std::string& file, const std::string& format) {
  const fs::path picture = folder / (file + "." + format);
  fs::remove(picture);
  const std::vector<std::string> command = {"gnuplot", "-e", "format=\"" + format + "\"", file + ".gp"};
  const ProgramEnd end = run_program(command, folder, kTimeout);
  if (end.exit_code != 0 || !fs::exists(picture)) complain(end, folder / (file + ".gp"));
  format == "svg" ? mend_svg(picture) : mend_pdf(picture);
}

}  // namespace

ProgramEnd run_program(const std::vector<std::string>& command, const fs::path& folder, double timeout_s) {
  int pipe_ends[2];
  if (::pipe2(pipe_ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t process = ::fork();
  if (process < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (process == 0) become(command, folder, pipe_ends[1]);
  ::close(pipe_ends[1]);
  ProgramEnd end;
  end.timed_out = !read_all(pipe_ends[0], end.error_text, timeout_s);
  if (end.timed_out) ::kill(process, SIGKILL);
  ::close(pipe_ends[0]);
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
  return end;
}

std::string script_text(const FigureScript& figure, const std::string& caption, const std::string& file) {
  std::string text = "# " + one_line(caption) + "\n";
  text += fmt::format(
      "# Written by gcslab report. To draw it again after a change:\n#   gnuplot -e 'format=\"svg\"' {}.gp\n",
      file);
  text += "# Line widths and font sizes are points, as printed at the figure's own size.\n";
  text += terminal_lines(figure, file) + style_lines();
  text += fmt::format("set multiplot # {} mm x {:.0f} mm\n", figure.width, figure.height);
  return text + figure.commands() + "unset multiplot\nunset output\n";
}

void write_figure(const FigureScript& figure, const std::string& caption, const fs::path& folder,
                  const std::string& file, const std::set<std::string>& formats) {
  make_folder(folder);
  write_file_atomically(folder / (file + ".dat"), figure.data());
  write_file_atomically(folder / (file + ".gp"), script_text(figure, caption, file));
  for (const std::string& format : formats) draw(folder, file, format);
}

}  // namespace gcslab
