#include "experiments/solving/system_methods.h"

#include "box_solver/solver_method.h"
#include "experiments/peers/peer.h"

namespace gcslab {
namespace {

std::vector<SystemMethod> all_methods() {
  std::vector<SystemMethod> methods;
  for (const SolverMethod& method : solver_method_registry().entries()) {
    methods.push_back(
        {method.name, method.summary, Promise::rigorous, method.version, method.options(), false});
  }
  for (const Peer& peer : peer_registry().entries())
    methods.push_back({peer.name, peer.summary, Promise::baseline, peer.version, peer.options, true});
  return methods;
}

}  // namespace

const Registry<SystemMethod>& system_method_registry() {
  static const Registry<SystemMethod> registry("method", all_methods());
  return registry;
}

}  // namespace gcslab
