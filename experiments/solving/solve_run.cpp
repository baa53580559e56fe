#include "experiments/solving/solve_run.h"

#include "experiments/peers/peer.h"

namespace gcslab {
namespace {

Status status_of(const SearchResult& found, Promise promise) {
  if (!found.pending.empty()) return Status::budget_exhausted;
  if (promise == Promise::baseline || !found.undecided.empty()) return Status::partial;
  return Status::complete;
}

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

SolveOutcome solve_system(const SystemFunctions& functions, const SolveSettings& settings,
                          const std::optional<SearchStart>& start, const std::stop_token& stop,
                          SearchObserver* observer) {
  if (const Peer* peer = peer_registry().find(settings.method))
    return solved_by(*peer, functions, settings, stop);
  SearchOptions options = search_options(settings.options);
  options.threads = settings.threads;
  options.proof = settings.proof;
  const Box& box = functions.system().box;
  SolveOutcome outcome;
  outcome.search = search(functions, box, start ? *start : SearchStart{{box}},
                          contractor_maker(settings.options), options, stop, observer);
  const Promise promise = SolverMethod::promise(settings.options);
  outcome.status = status_of(outcome.search, promise);
  outcome.completeness = promise == Promise::rigorous ? "proved" : "none";
  return outcome;
}

}  // namespace gcslab
