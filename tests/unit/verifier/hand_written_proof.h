#pragma once

// A system, a result and a proof written by hand, and ways to spoil them.

#include <functional>
#include <string>
#include <vector>

#include "unit/verifier/solved_system.h"

namespace gcslab {

inline Json solution_of(const Box& box, const Box& uniqueness_box) {
  std::vector<double> point;
  for (const Interval& side : box) point.push_back(midpoint(side));
  return {{"point", point},
          {"box", box_json(box)},
          {"kind", "real"},
          {"certificate", {{"claim", "unique"}}},
          {"uniqueness_box", box_json(uniqueness_box)}};
}

inline Json result_of(const EquationSystem& system, const Json& solutions) {
  return {{"problem", "test"},        {"status", "complete"},
          {"completeness", "proved"}, {"variables", system.variables},
          {"solutions", solutions},   {"undecided", Json::array()}};
}

inline std::string text_of(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return with_hash(text);
}

inline std::string bounds(double lower, double upper) {
  return hexadecimal(lower) + " " + hexadecimal(upper);
}

/// A system, a result and the lines of its proof.
struct HandWritten {
  EquationSystem system;
  Json result;
  std::vector<std::string> lines;

  VerificationReport verified() const {
    SolvedSystem run{system, result, text_of(lines)};
    run.sign();
    return run.verified();
  }
  /// The line of the proof, from 1, that is refused; 0 when none is.
  int refused_line() const {
    for (const auto& [where, reason] : verified().refusals) {
      if (where.starts_with("proof:")) return std::stoi(where.substr(6));
    }
    return 0;
  }
  bool proves_completeness() const {
    const VerificationReport report = verified();
    return report.accepted() && report.completeness_proved;
  }
};

struct Spoiled {
  const char* what;
  int refused_line;
  std::function<void(HandWritten&)> spoil;
};

inline void replace(HandWritten& proof, int line, const std::string& text) {
  proof.lines.at(static_cast<std::size_t>(line - 1)) = text;
}
inline void erase(HandWritten& proof, int line) { proof.lines.erase(proof.lines.begin() + line - 1); }

}  // namespace gcslab
