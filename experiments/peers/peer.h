#pragma once

// Solvers of others, run as methods: the system is written in their format, their program is started in a
// folder of its own under limits, and what it answers is read.
//
// Promise: nothing that a peer says is believed. Its roots are listed without a certificate, its boxes as
// undecided or as roots without a certificate; completeness is never claimed. An answer that is not as the
// peer's format says is an outcome (`failed`) with its reason, never a root.

#include <stop_token>
#include <string>
#include <vector>

#include "base/option.h"
#include "base/outcome.h"
#include "base/registry.h"
#include "box_solver/search.h"
#include "experiments/process/limits.h"

namespace gcslab {

/// What became of a run of a peer. Solutions have the claim `none`; what was not searched is pending.
struct PeerAnswer {
  Status status = Status::failed;  ///< partial, budget_exhausted, not_applicable or failed
  std::string reason;              ///< of the last three
  SearchResult found;
};

struct Peer {
  std::string name;
  std::string summary;
  int version;          ///< raised when what is asked of the peer or read from its answer changes
  std::string program;  ///< looked for on the PATH
  std::vector<OptionSpec> options;
  /// Runs the program at `path` on a system in its box. Throws NotApplicable, with the reason, for a system
  /// that the peer does not take.
  PeerAnswer (*solve)(const SystemFunctions& functions, const Options& options, const std::string& path,
                      const Limits& limits, const std::stop_token& stop);
};

/// A new peer is one source file and one line in peer.cpp.
const Registry<Peer>& peer_registry();

/// Runs a peer, or says that its program is not installed.
PeerAnswer solve_by_peer(const Peer& peer, const SystemFunctions& functions, const Options& options,
                         const Limits& limits, const std::stop_token& stop);

/// The file of that name in a folder of the PATH that may be executed; empty when there is none.
std::string program_on_path(const std::string& name);

}  // namespace gcslab
