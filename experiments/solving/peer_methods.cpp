// Programs of others as methods of `solve`.

#include "experiments/peers/peer.h"
#include "experiments/solving/solve_method.h"

namespace gcslab {
namespace {

SolveOutcome solved_by(const Peer& peer, const SystemFunctions& functions, const SolveSettings& settings,
                       const std::stop_token& stop) {
  Limits limits;
  limits.wall_s = std::numeric_limits<double>::infinity();  // `stop` comes when the time is over
  limits.memory_mb = settings.memory_mb;
  PeerAnswer answer = solve_by_peer(peer, functions, settings.options, limits, stop);
  SolveOutcome outcome;
  outcome.search = std::move(answer.found);
  outcome.status = answer.status;
  outcome.reason = std::move(answer.reason);
  return outcome;
}

}  // namespace

std::vector<SolveMethod> peer_methods() {
  std::vector<SolveMethod> methods;
  for (const Peer& peer : peer_registry().entries()) {
    const auto solve = [&peer](const SystemFunctions& functions, const SolveSettings& settings,
                               const std::optional<SearchStart>&, const std::stop_token& stop,
                               SearchObserver*) { return solved_by(peer, functions, settings, stop); };
    methods.push_back({peer.name,
                       peer.summary,
                       peer.version,
                       peer.options,
                       solve,
                       Promise::baseline,
                       {},
                       "is a program of others"});
  }
  return methods;
}

}  // namespace gcslab
