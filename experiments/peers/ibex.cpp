// The program ibexsolve of IBEX (Chabert, Jaulin 2009) as a method: interval branch and prune. What it holds
// for proved is listed without a certificate here, since nothing of it was proved again.

#include <algorithm>
#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "experiments/peers/ibex_cover.h"
#include "experiments/peers/peer_run.h"
#include "expression/minibex_writer.h"

namespace gcslab {
namespace {

constexpr const char* kSystem = "system.mbx";
constexpr const char* kCover = "system.cov";

bool meet(const Box& a, const Box& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (disjoint(a[i], b[i])) return false;
  }
  return true;
}

void list(IbexCover cover, const Box& search_box, SearchResult& found) {
  for (const auto* boxes : {&cover.solutions, &cover.others, &cover.pending}) {
    if (!std::ranges::all_of(*boxes, [&](const Box& box) { return meet(box, search_box); }))
      throw GarbledAnswer("its COV file: a box outside of the search box");
  }
  for (Box& box : cover.solutions)
    found.solutions.push_back({{std::move(box), {}, {}}, InequalityState::undecided, Claim::none});
  for (Box& box : cover.others) found.undecided.push_back({std::move(box), "not validated by ibexsolve"});
  found.pending = std::move(cover.pending);
  found.statistics.boxes = cover.cells;
}

/// What the status of a cover says of the search.
void judge(std::uint32_t status, PeerAnswer& answer) {
  constexpr std::uint32_t kTimeOut = 3;
  if (status < kTimeOut) return;
  const char* const reasons[] = {"ibexsolve ran out of time", "ibexsolve holds too many boxes",
                                 "ibexsolve was interrupted"};
  answer.status = Status::budget_exhausted;
  answer.reason = reasons[status - kTimeOut];
}

PeerAnswer solve(const SystemFunctions& functions, const Options& options, const std::string& path,
                 const Limits& limits, const std::stop_token& stop) {
  const EquationSystem& system = functions.system();
  if (system.equations.empty()) throw NotApplicable("there is no equation to solve");
  const TemporaryFolder folder;
  write_file_atomically(folder / kSystem, write_minibex(system));
  const std::vector<std::string> arguments = {fmt::format("--eps-min={}", options.real("eps_min")),
                                              fmt::format("--random-seed={}", options.integer("seed")),
                                              fmt::format("--output={}", kCover), kSystem};
  PeerAnswer answer = run_program({path, arguments, folder.text()}, limits, stop, system.box);
  if (answer.status != Status::partial) return answer;
  try {
    IbexCover cover =
        read_ibex_cover(peer_file(folder / kCover), functions.variables(), functions.equations().size());
    const std::uint32_t status = cover.status;
    list(std::move(cover), system.box, answer.found);
    judge(status, answer);
  } catch (const GarbledAnswer& garbled) {
    return failed_answer("the answer of ibexsolve cannot be read: " + std::string(garbled.what()));
  }
  return answer;
}

}  // namespace

Peer ibex_peer() {
  return {"ibex",
          "ibexsolve: branch and prune by hull consistency, constructive disjunction, interval Newton and "
          "linear relaxations; its boxes are listed without proof (Chabert, Jaulin 2009)",
          1,
          "ibexsolve",
          {real_option("eps_min", "a box narrower than this is not cut", "", 1e-7, 1e-300, 1e300),
           integer_option("seed", "of its random numbers", "", 1, 1, 999'999'999)},
          &solve};
}

}  // namespace gcslab
