#pragma once

// The independent judge: proves again what a result of `solve` claims, without searching and without any code
// of the solvers.
//
// Promise: a report without refusals says which claims hold (`checked`, with numbers) and which were not
// looked at (`not_checked`); whatever of the result is not in the second list is proved by the theorems of
// root_prover.h, root_counter.h, step_judge.h and proof_replay.h, in 256-bit intervals of the verifier's own.
// What it cannot prove it refuses, with the place: a JSON pointer, or file and line of the proof. A refusal
// says that the claim is unproven, not that it is false.

#include <cstdint>
#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "expression/equation_system.h"

namespace gcslab {

/// A text with its name for messages.
struct ProofText {
  std::istream* stream;
  std::string name;
};

struct VerificationReport {
  struct Checked {
    std::string claim;  ///< such as "solutions: the box contains exactly one root"
    std::uint64_t count;
  };
  struct Refusal {
    std::string where;  ///< "/solutions/3/box" or "run.proof:17"
    std::string reason;
  };
  std::vector<Checked> checked;
  std::vector<std::string> not_checked;
  std::vector<Refusal> refusals;
  /// Every solution in the search box lies in the box of a listed solution or of an undecided entry: by the
  /// proof file or, when there is none, for one polynomial in one variable by counting its roots.
  bool completeness_proved = false;

  bool accepted() const { return refusals.empty(); }
};

/// Judges a result (the JSON of `solve`) on a system and, when given, the proof that nothing is missing.
/// `search_box` is the box that was searched. Texts that are not as the format says are refused, never
/// thrown.
VerificationReport verify(const EquationSystem& system, const Box& search_box, const nlohmann::json& result,
                          const std::optional<ProofText>& proof = std::nullopt);

/// Whether `box` is proved to contain exactly one root of the equations, and `uniqueness_box`, which must
/// contain it, no other. For square systems; false for others.
bool verify_root(const EquationSystem& system, const Box& box, const Box& uniqueness_box);

/// The hash that a result carries under the key "content_hash": of its compact text without that key.
std::string result_hash(const nlohmann::json& result);

}  // namespace gcslab
