// PHCpack (Verschelde 1999) as a method: its blackbox solver finds all isolated complex solutions by
// numerical continuation; the real ones in the box are listed.

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "experiments/peers/peer_run.h"
#include "experiments/peers/phc_solutions.h"
#include "expression/phc_writer.h"

namespace gcslab {
namespace {

constexpr const char* kSystem = "system";
constexpr const char* kOutput = "output";

/// The point, where every imaginary part is rounding error.
std::optional<std::vector<double>> real_point(const PhcSolution& solution, double tolerance) {
  std::vector<double> point;
  for (const std::complex<double>& z : solution.point) {
    if (!(std::fabs(z.imag()) <= tolerance * std::max(1.0, std::fabs(z.real())))) return std::nullopt;
    point.push_back(z.real());
  }
  return point;
}

bool is_near(const std::vector<double>& a, const Box& b, double tolerance) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double slack = tolerance * std::max(1.0, std::fabs(a[i]));
    if (a[i] < b[i].lower - slack || a[i] > b[i].upper + slack) return false;
  }
  return true;
}

/// Real points in the box, several copies of a multiple solution as one.
void list(const std::vector<PhcSolution>& solutions, const Box& search_box, double tolerance,
          SearchResult& found) {
  for (const PhcSolution& solution : solutions) {
    if (solution.multiplicity == 0) continue;
    const auto point = real_point(solution, tolerance);
    if (!point || !is_near(*point, search_box, tolerance)) continue;
    const bool is_listed = std::ranges::any_of(
        found.solutions, [&](const Solution& other) { return is_near(*point, other.root.box, tolerance); });
    if (is_listed) continue;
    Solution entry;
    for (const double x : *point) entry.root.box.emplace_back(x);
    entry.inequalities = InequalityState::undecided;
    entry.claim = Claim::none;
    found.solutions.push_back(std::move(entry));
  }
}

void check_taken(const SystemFunctions& functions) {
  if (!functions.is_square())
    throw NotApplicable(fmt::format("phc -b takes as many equations as variables, not {} in {}",
                                    functions.equations().size(), functions.variables()));
}

PeerAnswer solve(const SystemFunctions& functions, const Options& options, const std::string& path,
                 const Limits& limits, const std::stop_token& stop) {
  check_taken(functions);
  const EquationSystem& system = functions.system();
  const TemporaryFolder folder;
  write_file_atomically(folder / kSystem, write_phc(system));
  const std::vector<std::string> arguments = {"-b", fmt::format("-0{}", options.integer("seed")),
                                              fmt::format("-t{}", options.integer("tasks")), kSystem,
                                              kOutput};
  PeerAnswer answer = run_program({path, arguments, folder.text()}, limits, stop, system.box);
  if (answer.status != Status::partial) return answer;
  try {
    // The last words of an output say when phc ran: without them it gave up on the way.
    if (peer_file(folder / kOutput).find("PHC ran from") == std::string::npos)
      throw GarbledAnswer("its output ends early");
    list(read_phc_solutions(peer_file(folder / kSystem), functions.variables()), system.box,
         options.real("real_tolerance"), answer.found);
  } catch (const GarbledAnswer& garbled) {
    return failed_answer("the answer of phc cannot be read: " + std::string(garbled.what()));
  }
  return answer;
}

}  // namespace

Peer phcpack_peer() {
  return {"phcpack",
          "PHCpack's blackbox solver: all isolated complex solutions by continuation, of which the real ones "
          "in the box are listed, without proof (Verschelde 1999)",
          1,
          "phc",
          {real_option("real_tolerance",
                       "a coordinate is real when its imaginary part is below this part of it, or below this",
                       "", 1e-8, 0, 1),
           integer_option("seed", "of PHCpack's random numbers", "", 1, 1, 999'999'999),
           integer_option("tasks", "threads of PHCpack", "", 1, 1, 256)},
          &solve};
}

}  // namespace gcslab
