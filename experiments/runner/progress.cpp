#include "experiments/runner/progress.h"

#include <cmath>
#include <fmt/format.h>
#include <ostream>

#include "experiments/runner/supervisor.h"

namespace gcslab {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

bool is_ordinary(Status status) { return status == Status::complete || status == Status::partial; }

}  // namespace

Progress::Progress(std::ostream& stream, bool is_terminal, std::string experiment, std::size_t to_run)
    : stream_(stream), is_terminal_(is_terminal), experiment_(std::move(experiment)), to_run_(to_run) {}

Progress::~Progress() { clear_line(); }

void Progress::finished(const FinishedJob& job) {
  ++done_;
  const JobResult& result = job.result;
  if (is_terminal_ && is_ordinary(result.status)) return;
  clear_line();
  const std::string reason = result.reason.empty() ? "" : " (" + result.reason + ")";
  stream_ << fmt::format("[{}/{}] {}: {} in {:.2f} s{}\n", done_, to_run_, job.job.place(),
                         name_of(result.status), job.wall_s, reason)
          << std::flush;
}

void Progress::tick(std::size_t running) {
  constexpr double kRedraw_s = 0.5;
  if (!is_terminal_ || seconds_since(drawn_) < kRedraw_s) return;
  drawn_ = Clock::now();
  clear_line();
  stream_ << fmt::format("{}: {} of {} jobs, {} running, {}", experiment_, done_, to_run_, running,
                         time_left())
          << std::flush;
}

std::string Progress::time_left() const {
  const double elapsed = seconds_since(start_);
  if (done_ == 0) return duration_text(elapsed) + " so far";
  const double left = elapsed / static_cast<double>(done_) * static_cast<double>(to_run_ - done_);
  return "about " + duration_text(left) + " left";
}

void Progress::clear_line() {
  if (is_terminal_) stream_ << "\r\033[K" << std::flush;
}

std::string duration_text(double seconds) {
  const long whole = std::lround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace gcslab
