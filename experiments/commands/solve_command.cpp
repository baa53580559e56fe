#include "experiments/commands/solve_command.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <unistd.h>

#include "base/atomic_file.h"
#include "experiments/commands/command_options.h"
#include "experiments/commands/exit_code.h"
#include "experiments/commands/interruption.h"
#include "experiments/commands/path_session.h"
#include "experiments/commands/search_progress.h"
#include "experiments/corpus/corpus.h"
#include "experiments/corpus/problem_loader.h"
#include "experiments/provenance.h"
#include "experiments/reporting/box_picture.h"
#include "experiments/reporting/cover_picture.h"
#include "experiments/reporting/figures_picture.h"
#include "experiments/solving/figures_json.h"
#include "experiments/solving/result_json.h"
#include "experiments/solving/solve_method.h"
#include "experiments/tasks/memory_use.h"
#include "experiments/tasks/stopwatch.h"
#include "geometry/degrees_of_freedom.h"

namespace gcslab {
namespace {

struct Settings {
  std::string problem;
  std::string method;  ///< empty: the default of the problem's kind
  std::vector<std::string> options;
  std::string box;
  double timeout_s = 0;
  double memory_mb = 0;
  int threads = 1;
  std::uint64_t seed = 1;
  int precision = 53;
  std::string json;
  std::string proof;
  std::string pending;
  std::string resume;
  std::string figure;
  std::string figure_variables;
};

Json method_json(const Settings& settings, const Options& options) {
  Json values = Json::object();
  for (const auto& [name, value] : options.values()) values[name] = to_string(value);
  return {{"name", settings.method},
          {"options", values},
          {"version", solve_method_registry().at(settings.method).version}};
}

/// The result of the contract.
Json result_json(const Settings& settings, const Problem& problem, const SystemFunctions& functions,
                 const Options& options, const SolveOutcome& outcome, const Json& statistics) {
  Json result = {{"problem", settings.problem},
                 {"method", method_json(settings, options)},
                 {"status", std::string(name_of(outcome.status))},
                 {"completeness", outcome.completeness},
                 {"variables", functions.system().variables},
                 {"search_box", box_to_json(functions.system().box)},
                 {"solutions", solutions_json(functions, outcome.search, settings.precision)},
                 {"undecided", undecided_json(outcome.search)}};
  if (problem.geometry != nullptr) add_figures(result, *problem.geometry, outcome.search);
  if (!outcome.paths.empty()) add_paths(result, outcome.paths);
  if (outcome.plan) add_plan(result, *outcome.plan);
  result["statistics"] = statistics;
  result["provenance"] = provenance(settings.seed, utc_now());
  if (!outcome.reason.empty()) result["reason"] = outcome.reason;
  seal(result);
  return result;
}

Json statistics_json(const SolveOutcome& outcome, const Stopwatch& watch) {
  const SearchResult& found = outcome.search;
  Json result = {{"wall_s", watch.wall_s()},
                 {"cpu_s", watch.cpu_s()},
                 {"peak_rss_mb", peak_rss_mb()},
                 {"boxes", found.statistics.boxes},
                 {"bisections", found.statistics.bisections},
                 {"undecided_volume", undecided_volume(found)}};  // infinite: null
  if (outcome.steps) result["steps"] = *outcome.steps;
  return result;
}

/// What is not proved of a solution.
std::string doubt_text(const Json& solution, std::size_t unknowns) {
  const std::string claim = solution["certificate"]["claim"];
  if (claim == "exists") return " (a root exists near, perhaps more than one)";
  if (claim != "none") return "";
  if (!solution.contains("jacobian_rank") || solution["jacobian_rank"] == unknowns) return " (not certified)";
  return fmt::format(" (not certified: singular, rank {} of {}{})",
                     solution["jacobian_rank"].get<std::size_t>(), unknowns,
                     solution["on_continuum"].get<bool>() ? ", others lie beside it" : "");
}

void print_solutions(const SystemFunctions& functions, const Json& result) {
  const auto& names = functions.system().variables;
  for (const Json& solution : result["solutions"]) {
    const bool has_digits = solution.contains("decimal");
    std::string line;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string value = has_digits ? solution["decimal"][i].get<std::string>()
                                           : fmt::format("{:.17g}", solution["point"][i].get<double>());
      line += fmt::format("{}{} = {}", i == 0 ? "" : ", ", names[i], value);
    }
    const int multiplicity = solution.value("multiplicity", 1);
    fmt::print("  {}{}{}\n", line, multiplicity > 1 ? fmt::format(" (multiplicity {})", multiplicity) : "",
               doubt_text(solution, names.size()));
  }
}

/// What a plan says before a path is followed, and how many plans it took.
void print_plan(const Json& plan) {
  if (plan.contains("plans"))
    fmt::print("  plans: {}, changed {} times\n", plan["plans"].get<std::uint64_t>(),
               plan["plan_changes"].get<std::uint64_t>());
  if (!plan.contains("escapes")) return;
  if (plan["escapes"].empty()) fmt::print("  plan: no point can go to infinity\n");
  for (const Json& escape : plan["escapes"])
    fmt::print("  plan: can go to infinity: {}\n", escape["configuration"].get<std::string>());
}

void print_paths(const Json& paths) {
  for (const Json& path : paths) {
    const std::string end = path["type"], other_end = path["other_end"];
    fmt::print("  path: {}{}, length {:.4g}, {} steps, crosses t = 1 {} times\n", end,
               end == other_end ? "" : " and " + other_end, path["length"].get<double>(),
               path["steps"].get<std::uint64_t>(), path["crossings"].size());
    for (const std::string key : {"escape", "plan_event"}) {
      const std::string text = path.value(key, ""), other = path.value("other_" + key, "");
      if (!text.empty()) fmt::print("    ends: {}\n", text);
      if (!other.empty() && other != text) fmt::print("    ends: {}\n", other);
    }
    std::map<std::string, std::size_t> events;
    for (const Json& crossing : path["crossings"]) {
      if (crossing.contains("event")) ++events[crossing["event"].get<std::string>()];
    }
    for (const auto& [event, count] : events) fmt::print("    at {} of its crossings {}\n", count, event);
  }
}

void print_summary(const Settings& settings, const SystemFunctions& functions, const Json& result) {
  constexpr std::size_t kListed = 100;
  const Json& statistics = result["statistics"];
  const std::size_t solutions = result["solutions"].size();
  const std::size_t undecided = result["undecided"].size();
  fmt::print("{} by {}: {} solution{}, {} undecided box{}, {}, completeness {} ({} boxes, {:.3g} s)\n",
             settings.problem, settings.method, solutions, solutions == 1 ? "" : "s", undecided,
             undecided == 1 ? "" : "es", result["status"].get<std::string>(),
             result["completeness"].get<std::string>(), statistics["boxes"].get<std::uint64_t>(),
             statistics["wall_s"].get<double>());
  if (result.contains("classes")) {
    const std::size_t classes = result["classes"].size();
    fmt::print("  {} figure{} up to isometry\n", classes, classes == 1 ? "" : "s");
  }
  if (result.contains("plan")) print_plan(result["plan"]);
  if (result.contains("paths")) print_paths(result["paths"]);
  if (solutions <= kListed) print_solutions(functions, result);
  if (solutions > kListed) fmt::print("  (more than {} solutions: see --json)\n", kListed);
  if (undecided == 0) return;
  const Json& volume = statistics["undecided_volume"];
  fmt::print("  undecided, at most {:.3g} in volume, for example: {}\n",
             volume.is_null() ? std::numeric_limits<double>::infinity() : volume.get<double>(),
             result["undecided"][0]["reason"].get<std::string>());
}

/// Where the proof goes; nowhere when nobody asked.
class ProofFile {
 public:
  explicit ProofFile(const std::string& path) {
    if (path.empty()) return;
    stream_.open(path, std::ios::binary);
    if (!stream_) throw InputError(path + ": cannot be written");
    log_.emplace(stream_);
  }
  ProofLog* log() { return log_ ? &*log_ : nullptr; }
  void close(const std::string& path) {
    if (!log_) return;
    stream_.close();
    if (!stream_) throw InputError(path + ": cannot be written to its end (is the disk full?)");
  }

 private:
  std::ofstream stream_;
  std::optional<ProofLog> log_;
};

void check_outputs(const Settings& settings) {
  for (const std::string& path : {settings.json, settings.proof, settings.pending}) {
    if (!path.empty() && path != "-") check_writable(path);
  }
}

/// The figures of a constraint system, or the boxes of a search, when somebody wants to see them.
class Picture {
 public:
  Picture(const Settings& settings, const Problem& problem)
      : file_(settings.figure),
        shows_boxes_(problem.geometry == nullptr || !settings.figure_variables.empty()) {
    if (file_.empty() && !settings.figure_variables.empty())
      throw InputError("--figure-variables says what --figure shows; give that too");
    if (file_.empty()) return;
    check_picture_file(file_);
    if (shows_boxes_) variables_ = pictured_variables(problem, settings.figure_variables);
  }
  SearchRecord* record() { return file_.empty() || !shows_boxes_ ? nullptr : &record_; }
  void write(const Problem& problem, const SearchResult& result, const std::string& method) const {
    if (file_.empty()) return;
    if (shows_boxes_) {
      write_box_picture(problem, search_picture(problem.system.box, record_, result), variables_, method,
                        file_);
    } else {
      write_figures_picture(figure_picture(*problem.geometry, result), problem.name + ", " + method, file_);
    }
  }

 private:
  std::string file_;
  bool shows_boxes_;
  std::array<std::size_t, 2> variables_{};
  SearchRecord record_{kDrawnBoxes};
};

/// What a method that does not search cannot be asked for.
void check_asked(const Settings& settings, const SolveMethod& method) {
  if (method.no_search.empty()) return;
  const bool is_resumable = method.follows_path;
  for (const auto& [option, value] : {std::pair("--proof", settings.proof),
                                      {"--pending", settings.pending},
                                      {"--resume", settings.resume}}) {
    if (!value.empty() && !(is_resumable && std::string_view(option) != "--proof"))
      throw InputError(fmt::format("{}: not with {}, which {}", option, method.name, method.no_search));
  }
}

/// What a stopped path belongs to. How far it may go and what certifies its solutions are not part of it.
PathIdentity path_identity(const std::string& problem_hash, const std::string& method,
                           const Options& options) {
  std::string text;
  for (const auto& [name, value] : options.values()) {
    if (name != "maximum_steps" && name != "certifier") text += name + "=" + to_string(value) + " ";
  }
  if (!text.empty()) text.pop_back();
  return {problem_hash, method, text};
}

/// The contract's default for a problem of that kind.
std::string default_method(const std::string& problem) {
  const std::string kind = kind_of_file(Corpus::standard().problem_path(problem));
  return kind == "constraint_system" ? "sketch_path" : "adaptive";
}

int run(Settings settings) {
  if (settings.method.empty()) settings.method = default_method(settings.problem);
  const SolveMethod& method = solve_method_registry().at(settings.method);
  SolveSettings solve{settings.method,
                      Options(method.options, option_texts(settings.options), settings.method)};
  Problem problem = load_system(settings.problem, solve.options.word("valuation"));
  if (!settings.box.empty())
    problem.system.box = read_box_option(settings.box, problem.system.variables, problem.system.box);
  check_asked(settings, method);
  if (problem.geometry != nullptr && problem.system.equations.size() != problem.system.variables.size())
    fmt::print(stderr, "gcslab: note: {}; {}\n", balance_text(problem.geometry->equations),
               structure_text(problem.geometry->system, structural_diagnosis(problem.geometry->equations)));
  solve.threads = settings.threads;
  if (settings.memory_mb > 0) solve.memory_mb = settings.memory_mb;
  check_outputs(settings);
  Picture picture(settings, problem);
  solve.record = picture.record();
  solve.geometry = problem.geometry.get();
  const std::string hash = problem_content_hash(Corpus::standard().problem_path(settings.problem));
  const SystemFunctions functions(problem.system);
  std::optional<SearchStart> start;
  const PathIdentity identity = path_identity(hash, settings.method, solve.options);
  std::optional<PathState> path_from;
  if (!settings.resume.empty() && method.follows_path) {
    path_from = read_path_state(settings.resume, identity);
    solve.path_from = &*path_from;
  } else if (!settings.resume.empty())
    start = read_pending(settings.resume, hash, problem.system.box);
  ProofFile proof(settings.proof);
  solve.proof = proof.log();
  Interruption interruption(settings.timeout_s);
  SearchProgress progress(isatty(STDERR_FILENO) != 0, settings.memory_mb, interruption);
  PathSession path_session(identity, method.follows_path ? settings.pending : "", isatty(STDERR_FILENO) != 0,
                           settings.memory_mb, interruption);
  if (method.follows_path) solve.path_observer = [&](const PathState& state) { path_session.stepped(state); };
  const Stopwatch watch;
  const SolveOutcome outcome = solve_system(functions, solve, start, interruption.token(), &progress);
  progress.finish();
  path_session.finish(outcome.status != Status::budget_exhausted);
  const Json statistics = statistics_json(outcome, watch);
  proof.close(settings.proof);
  const Json result = result_json(settings, problem, functions, solve.options, outcome, statistics);
  if (!settings.pending.empty() && !method.follows_path)
    write_pending(settings.pending, hash, problem.system.box, outcome.search);
  if (settings.json == "-") {
    fmt::print("{}\n", result.dump(1));
  } else {
    if (!settings.json.empty()) write_file_atomically(settings.json, result.dump(1) + "\n");
    print_summary(settings, functions, result);
  }
  if (!outcome.reason.empty()) fmt::print(stderr, "gcslab: {}\n", outcome.reason);
  picture.write(problem, outcome.search, settings.method);
  return exit_code_of(outcome.status);
}

}  // namespace

void add_solve_command(CLI::App& app, int& exit_code) {
  auto settings = std::make_shared<Settings>();
  CLI::App* command =
      app.add_subcommand("solve", "Find every real solution of a system in its box, with proof");
  command
      ->add_option("problem", settings->problem,
                   "a problem file, or a name that `gcslab list problems` prints")
      ->required();
  command->add_option("--method", settings->method,
                      "see gcslab list methods; by default adaptive, and sketch_path for constraint systems");
  command->add_option("--set", settings->options, "option=value of the method; see gcslab describe METHOD");
  command->add_option("--box", settings->box, "another box, such as \"x=[-3,3],y=[0,1]\"");
  command
      ->add_option("--timeout", settings->timeout_s,
                   "stop after this many seconds; what is left is undecided")
      ->check(positive_number());
  command->add_option("--memory", settings->memory_mb, "stop when more than this many MB are used")
      ->check(positive_number());
  command
      ->add_option("--threads", settings->threads,
                   "threads of the search; the answer does not depend on them")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_option("--seed", settings->seed, "seed of methods that draw random numbers")
      ->capture_default_str();
  command->add_option("--precision", settings->precision, "bits to which each solution is refined")
      ->check(CLI::Range(53, 1'000'000))
      ->capture_default_str();
  command->add_option("--json", settings->json, "write the result here; - is standard output");
  command->add_option(
      "--proof", settings->proof,
      "write the whole search here, so that `gcslab verify` can prove that nothing is missing");
  command->add_option("--pending", settings->pending,
                      "write what is left when the budget ends, for --resume");
  command->add_option("--resume", settings->resume, "go on from a file that --pending wrote");
  command->add_option("--figure", settings->figure,
                      "draw the figures of a constraint system, or all boxes of a search in two or three "
                      "unknowns: FILE.svg or FILE.pdf");
  command->add_option("--figure-variables", settings->figure_variables,
                      "the two unknowns that a figure of boxes shows, such as x,z; by default the first two");
  command->callback([settings, &exit_code] { exit_code = run(*settings); });
}

}  // namespace gcslab
