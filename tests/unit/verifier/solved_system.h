#pragma once

// Systems written as texts, solved by the engine, with result and proof as `solve` writes them.

#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "base/content_hash.h"
#include "box_solver/solver_method.h"
#include "expression/parser.h"
#include "interval/point_numbers.h"
#include "verifier/verifier.h"

namespace gcslab {

using Json = nlohmann::json;

inline EquationSystem system_of(const std::vector<std::string>& variables,
                                const std::vector<std::string>& equations, const Box& box,
                                const std::vector<std::string>& inequalities = {}) {
  EquationSystem system;
  system.variables = variables;
  for (const std::string& text : equations)
    system.equations.push_back(parse_equation(*system.graph, text, variables));
  for (const std::string& text : inequalities)
    system.inequalities.push_back(parse_inequality(*system.graph, text, variables));
  system.box = box;
  return system;
}

/// The number in hexadecimal digits.
inline std::string hexadecimal(double value) {
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  std::array<char, 64> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), std::fabs(value), std::chars_format::hex);
  return (value < 0 ? "-0x" : "0x") + std::string(text.data(), end.ptr);
}

inline Json box_json(const Box& box) {
  Json result = Json::array();
  for (const Interval& side : box) result.push_back({hexadecimal(side.lower), hexadecimal(side.upper)});
  return result;
}

inline double residual_at(const EquationSystem& system, const std::vector<double>& point) {
  const SystemFunctions functions(system);
  SystemEvaluator<double> evaluator(functions);
  std::vector<double> values(functions.equations().size());
  evaluator.values(point, values);
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::fabs(value));
  return largest;
}

inline Json solution_json(const EquationSystem& system, const Solution& solution) {
  std::vector<double> point;
  for (const Interval& side : solution.root.box) point.push_back(midpoint(side));
  Json evidence = Json::array();
  for (const Evidence& e : solution.root.evidence) {
    evidence.push_back(
        {{"type", e.type}, {"claim", name_of(e.claim)}, {"box", box_json(e.box)}, {"bits", e.bits}});
  }
  Json entry = {{"point", point},
                {"box", box_json(solution.root.box)},
                {"kind", "real"},
                {"residual", residual_at(system, point)},
                {"certificate", {{"claim", name_of(solution.claim)}, {"evidence", evidence}}},
                {"isolated", "unknown"},
                {"inequalities", solution.inequalities == InequalityState::proved ? "proved" : "undecided"}};
  if (solution.claim != Claim::unique) return entry;
  entry["uniqueness_box"] = box_json(solution.root.uniqueness_box);
  entry["multiplicity"] = solution.root.multiplicity;
  entry["isolated"] = "proved";
  return entry;
}

/// The proof with the content hash that belongs to its lines.
inline std::string with_hash(std::string proof) {
  const std::size_t old = proof.rfind("\nhash ");
  if (old != std::string::npos) proof.erase(old + 1);
  return proof + "hash " + content_hash(proof) + "\n";
}

struct SolvedSystem {
  EquationSystem system;
  Json result;
  std::string proof;

  /// After a change of the result.
  void sign() { result["content_hash"] = result_hash(result); }
  VerificationReport verified() const {
    std::istringstream stream(proof);
    return verify(system, system.box, result, ProofText{&stream, "proof"});
  }
  VerificationReport verified_without_proof() const { return verify(system, system.box, result); }
};

/// Solves the system in its box by the contractors named.
inline SolvedSystem solved(const EquationSystem& system, const std::string& contractor = "hull+multipliers",
                           std::uint64_t maximum_boxes = ~std::uint64_t{0},
                           const std::string& certifier = SearchOptions().certifier) {
  const SystemFunctions functions(system);
  std::ostringstream text;
  ProofLog log(text);
  SearchOptions options;
  options.proof = &log;
  options.maximum_boxes = maximum_boxes;
  options.certifier = certifier;
  const ContractorMaker maker = [&](const SystemFunctions& f, int bits) {
    ContractorSettings settings;
    if (bits > 53) {
      settings.arithmetic = Arithmetic::mpfr;
      settings.bits = bits;
    }
    return make_contractor(contractor, f, settings);
  };
  const SearchResult found = search(functions, system.box, {{system.box}}, maker, options);
  Json solutions = Json::array();
  for (const Solution& solution : found.solutions) solutions.push_back(solution_json(system, solution));
  Json undecided = Json::array();
  for (const UndecidedBox& box : found.undecided)
    undecided.push_back({{"box", box_json(box.box)}, {"reason", box.reason}});
  for (const Box& box : found.pending)
    undecided.push_back({{"box", box_json(box)}, {"reason", "not searched"}});
  const std::string status =
      !found.pending.empty() ? "budget_exhausted" : (undecided.empty() ? "complete" : "partial");
  SolvedSystem result{system,
                      {{"problem", "test"},
                       {"status", status},
                       {"completeness", "proved"},
                       {"variables", system.variables},
                       {"solutions", solutions},
                       {"undecided", undecided}},
                      text.str()};
  result.sign();
  return result;
}

/// All refusals, for messages of tests.
inline std::string refusals_of(const VerificationReport& report) {
  std::string text;
  for (const auto& [where, reason] : report.refusals)
    text.append(where).append(": ").append(reason).append("\n");
  return text;
}

}  // namespace gcslab
