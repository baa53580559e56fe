#include "experiments/commands/cover_command.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>

#include "base/atomic_file.h"
#include "covering/cover.h"
#include "enclosure/bound_registry.h"
#include "experiments/commands/command_options.h"
#include "experiments/commands/exit_code.h"
#include "experiments/commands/interruption.h"
#include "experiments/corpus/problem.h"
#include "experiments/corpus/problem_loader.h"
#include "experiments/provenance.h"
#include "experiments/reporting/cover_picture.h"
#include "experiments/tasks/bound_methods.h"
#include "experiments/tasks/job_result.h"
#include "experiments/tasks/memory_use.h"
#include "experiments/tasks/stopwatch.h"

namespace gcslab {
namespace {

constexpr int kMaximumDepth = 30;

struct Settings {
  std::string problem;
  std::string method;
  int depth = 8;
  double cell_size = 0;
  std::string split = "all";
  std::string box;
  std::vector<std::string> options;
  double timeout_s = 0;
  std::string json;
  std::string figure;
};

/// bernstein where it takes every function, else a bound that takes them all.
std::string default_method(const Problem& problem) {
  try {
    const Options defaults(bound_registry().at("bernstein").options, {}, "bernstein");
    for (const auto& bound : make_bounds(problem, "bernstein", defaults).equations) {
      static_cast<void>(bound->walk(problem.system.box, 0));
    }
    return "bernstein";
  } catch (const NotApplicable&) {
    return "centred";
  }
}

Json box_json(const Box& box) {
  Json sides = Json::array();
  for (const Interval& side : box) sides.push_back({side.lower, side.upper});
  return sides;
}

/// The result of the contract.
Json result_json(const Settings& settings, const Options& options, const Cover& found, Promise promise,
                 const Json& statistics) {
  Json values = Json::object();
  for (const auto& [name, value] : options.values()) values[name] = to_string(value);
  Status status = promise == Promise::rigorous ? Status::complete : Status::partial;
  if (!found.undecided.empty()) status = Status::budget_exhausted;
  Json result = {{"problem", settings.problem},
                 {"method",
                  {{"name", settings.method},
                   {"options", values},
                   {"version", bound_registry().at(settings.method).version}}},
                 {"depth", found.tree.depth()},
                 {"split", std::string(name_of(found.tree.split()))},
                 {"domain", box_json(found.tree.domain())},
                 {"kept_cells", found.tree.kept_cells()},
                 {"visited_cells", found.tree.visited_cells()},
                 {"visited_per_level", found.tree.visited_per_level()},
                 {"status", std::string(name_of(status))},
                 {"statistics", statistics},
                 {"provenance", provenance(0, utc_now())}};
  if (!found.undecided.empty()) {
    for (const Box& box : found.undecided) result["undecided"].push_back(box_json(box));
  }
  return result;
}

void add_kept_cells(Json& result, const CoverTree& tree) {
  Json kept = Json::array();
  tree.for_each_leaf([&](const CoverLeaf& leaf) {
    if (leaf.kept) kept.push_back(box_json(leaf.box));
  });
  result["kept"] = std::move(kept);
}

void print_summary(const Settings& settings, const Json& result) {
  fmt::print("{} by {}: depth {}, {} cells kept of {} visited, {} ({:.3g} s)\n", settings.problem,
             settings.method, result["depth"].get<int>(), result["kept_cells"].get<std::uint64_t>(),
             result["visited_cells"].get<std::uint64_t>(), result["status"].get<std::string>(),
             result["statistics"]["wall_s"].get<double>());
}

int run(Settings settings) {
  Problem problem = load_problem_of_kind(settings.problem, {"curve", "surface", "space_curve"});
  if (!settings.box.empty()) {
    problem.system.box = read_box_option(settings.box, problem.system.variables, problem.system.box);
  }
  if (settings.method.empty()) settings.method = default_method(problem);
  const BoundVariant& variant = bound_registry().at(settings.method);
  const Options options(variant.options, option_texts(settings.options), settings.method);
  CoverOptions cover_options{settings.depth, split_from_name(settings.split)};
  if (settings.cell_size > 0) {
    cover_options.depth = depth_for_cell_size(problem.system.box, settings.cell_size);
    if (cover_options.depth > kMaximumDepth) {
      throw InputError(fmt::format("--cell-size needs depth {}; at most {} is possible", cover_options.depth,
                                   kMaximumDepth));
    }
  }
  if (!settings.json.empty() && settings.json != "-") check_writable(settings.json);
  if (!settings.figure.empty()) check_cover_picture(problem, settings.figure);
  const auto bounds = make_bounds(problem, settings.method, options);
  Interruption interruption(settings.timeout_s);
  const Stopwatch watch;
  const Cover found = cover(bounds, problem.system.box, cover_options, interruption.token());
  const Json statistics = {
      {"wall_s", watch.wall_s()}, {"cpu_s", watch.cpu_s()}, {"peak_rss_mb", peak_rss_mb()}};
  Json result = result_json(settings, options, found, variant.promise(options), statistics);
  if (!settings.json.empty()) add_kept_cells(result, found.tree);
  if (!settings.json.empty() && settings.json != "-")
    write_file_atomically(settings.json, result.dump(1) + "\n");
  if (!settings.figure.empty()) write_cover_picture(problem, found.tree, settings.method, settings.figure);
  if (settings.json == "-") {
    fmt::print("{}\n", result.dump(1));
  } else {
    print_summary(settings, result);
  }
  return exit_code_of(status_from_name(result["status"].get<std::string>()));
}

}  // namespace

void add_cover_command(CLI::App& app, int& exit_code) {
  auto settings = std::make_shared<Settings>();
  CLI::App* command =
      app.add_subcommand("cover", "Cover an implicit curve or surface by cells that may meet it");
  command
      ->add_option("problem", settings->problem,
                   "a problem file, or a name that `gcslab list problems` prints")
      ->required();
  command->add_option(
      "--method", settings->method,
      "range bound (default: bernstein for polynomials, centred otherwise); see gcslab list methods");
  auto* depth = command->add_option("--depth", settings->depth, "halvings of every variable")
                    ->check(CLI::Range(0, kMaximumDepth))
                    ->capture_default_str();
  command->add_option("--cell-size", settings->cell_size, "largest width of a cell, in place of --depth")
      ->check(positive_number())
      ->excludes(depth);
  command->add_option("--split", settings->split, "halve all variables at once, or one after the other")
      ->check(CLI::IsMember({"all", "alternate"}))
      ->capture_default_str();
  command->add_option("--box", settings->box, "another box, such as \"x=[-3,3],y=[0,1]\"");
  command->add_option("--set", settings->options, "option=value of the method; see gcslab describe METHOD");
  command->add_option("--timeout", settings->timeout_s, "stop after this many seconds")
      ->check(positive_number());
  command->add_option("--json", settings->json, "write the result here; - is standard output");
  command->add_option("--figure", settings->figure,
                      "draw the cover of a plane curve: FILE.svg or FILE.pdf, with its data and gnuplot "
                      "script (.dat, .gp) beside it");
  command->callback([settings, &exit_code] { exit_code = run(*settings); });
}

}  // namespace gcslab
