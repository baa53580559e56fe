#include "selftest_task.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "base/content_hash.h"
#include "base/error.h"
#include "experiments/tasks/job_result.h"

namespace gcslab {
namespace {

using Milliseconds = std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

OptionSpec real(const char* name, double value) {
  return {.name = name, .meaning = "a number", .default_value = value};
}
OptionSpec flag(const char* name, bool value) {
  return {.name = name, .meaning = "a flag", .default_value = value};
}
OptionSpec word(const char* name, std::string value, std::vector<std::string> choices = {}) {
  return {
      .name = name, .meaning = "a word", .default_value = std::move(value), .choices = std::move(choices)};
}
OptionSpec integer(const char* name, std::int64_t value, double minimum, double maximum) {
  return {.name = name, .meaning = "a count", .default_value = value, .minimum = minimum, .maximum = maximum};
}

JobResult answer(std::int64_t number) {
  JobResult result;
  result.status = Status::complete;
  result.values["answer"] = number;
  return result;
}

JobResult out_of_time() {
  JobResult result;
  result.status = Status::budget_exhausted;
  result.reason = "asked to stop";
  return result;
}

/// Until `seconds` of wall time have passed, or for as long as nobody asks to stop.
JobResult pass_time(const Job& job, const std::stop_token& stop, bool busy) {
  const auto end = Clock::now() + std::chrono::duration<double>(job.options.real("seconds"));
  while (Clock::now() < end) {
    if (job.options.flag("heeds_stop") && stop.stop_requested()) return out_of_time();
    if (!busy) std::this_thread::sleep_for(Milliseconds(1));
  }
  return answer(1);
}

JobResult allocate(const Job& job) {
  std::vector<std::vector<char>> blocks;
  const auto size = static_cast<std::size_t>(job.options.integer("block_mb")) * 1'000'000;
  for (std::int64_t block = 0; block < job.options.integer("blocks"); ++block) {
    blocks.emplace_back(size, static_cast<char>(block + 1));
    std::this_thread::sleep_for(Milliseconds(5));
  }
  return answer(static_cast<std::int64_t>(blocks.size()));
}

JobResult die(const Job& job) {
  std::cerr << "about to die\n";
  std::raise(job.options.word("signal") == "segv" ? SIGSEGV : SIGABRT);
  return {};
}

JobResult end_process(const Job& job) {
  std::cerr << job.options.word("words") << '\n' << std::flush;
  std::_Exit(static_cast<int>(job.options.integer("code")));
}

JobResult vary() {
  static std::int64_t calls = 0;
  return answer(++calls);
}

JobResult large(const Job& job) {
  JobResult result = answer(1);
  result.artifact = std::string(static_cast<std::size_t>(job.options.integer("bytes")), 'x');
  return result;
}

JobResult undeclared() {
  JobResult result = answer(1);
  result.values["surprise"] = 2;
  return result;
}

std::vector<std::string> expand(const std::string& entry) {
  static const std::vector<std::string> known = {"one", "two",   "three", "four", "five",
                                                 "six", "seven", "eight", "nine", "wrong-kind"};
  if (entry == "suite:all") return {"one", "two", "three"};
  if (entry == "suite:odd") return {"one", "three"};
  if (std::ranges::find(known, entry) != known.end()) return {entry};
  throw InputError(unknown_name_message("problem", entry, known));
}

std::string hash_of_problem(const std::string& name) {
  const char* edition = std::getenv("SELFTEST_EDITION");
  return content_hash(name + (edition == nullptr ? "" : edition));
}

}  // namespace

std::vector<MethodInfo> SelftestTask::methods() const {
  return {
      {"succeed",
       "answers",
       Promise::rigorous,
       1,
       {integer("answer", 42, -100, 100), flag("negative", false), real("scale", 1.0),
        word("arithmetic", "fast", {"fast", "slow"})}},
      {"sleep", "takes time", Promise::rigorous, 1, {real("seconds", 0.05), flag("heeds_stop", true)}},
      {"spin", "takes processor time", Promise::rigorous, 1, {real("seconds", 10), flag("heeds_stop", true)}},
      {"allocate",
       "takes memory",
       Promise::rigorous,
       1,
       {integer("block_mb", 1, 0, 1e6), integer("blocks", 1, 0, 1e6)}},
      {"die", "raises a signal", Promise::rigorous, 1, {word("signal", "segv", {"segv", "abort"})}},
      {"end_process", "calls exit", Promise::rigorous, 1, {integer("code", 3, 0, 255), word("words", "bye")}},
      {"fail", "throws", Promise::rigorous, 1, {}},
      {"refuse", "does not apply", Promise::rigorous, 1, {}},
      {"vary", "answers differently each time", Promise::baseline, 1, {}},
      {"large", "has a large artifact", Promise::rigorous, 1, {integer("bytes", 10, 0, 1e9)}},
      {"undeclared", "reports a value that is not declared", Promise::rigorous, 1, {}},
  };
}

std::vector<OptionSpec> SelftestTask::parameters() const {
  return {integer("depth", 8, 0, 30), real("cell_size", 0.5), word("split", "all", {"all", "alternate"})};
}

void SelftestTask::check(const Job& job) const {
  if (job.problem == "wrong-kind") throw InputError("is a letter; task selftest takes numbers");
}

JobResult SelftestTask::run(const Job& job, const std::stop_token& stop) const {
  if (job.method == "succeed") return answer(job.options.integer("answer"));
  if (job.method == "sleep") return pass_time(job, stop, false);
  if (job.method == "spin") return pass_time(job, stop, true);
  if (job.method == "allocate") return allocate(job);
  if (job.method == "die") return die(job);
  if (job.method == "end_process") return end_process(job);
  if (job.method == "refuse") throw NotApplicable("transcendental terms");
  if (job.method == "vary") return vary();
  if (job.method == "large") return large(job);
  if (job.method == "undeclared") return undeclared();
  throw std::runtime_error("no solution found");
}

const Catalogue& selftest_catalogue() {
  static const TaskRegistry tasks("task", {TaskEntry(std::make_shared<SelftestTask>())});
  static const Catalogue catalogue{tasks, {expand, hash_of_problem}, {}};
  return catalogue;
}

}  // namespace gcslab
