#include "expression/polynomial_form.h"

#include <span>
#include <string>

#include "base/error.h"

namespace gcslab {
namespace {

/// What keeps a node from being part of a polynomial; empty when nothing does.
std::string obstacle(Expression e, Constants constants) {
  switch (e.operation()) {
    case Operation::constant:
    case Operation::variable:
    case Operation::add:
    case Operation::subtract:
    case Operation::negate:
    case Operation::multiply:
    case Operation::sqr:
      return "";
    case Operation::pi:
      return constants == Constants::rational_and_pi ? "" : "pi, which is no rational number";
    case Operation::divide:
      return e.operand(1).is_constant() ? "" : "a division by what is no rational number";
    case Operation::power_integer:
      return e.exponent() >= 0 ? "" : "the power " + e.exponent().get_str();
    case Operation::power_rational:
      return "the power " + e.exponent().get_str();
    default:
      return std::string(info(e.operation()).name);
  }
}

}  // namespace

void require_polynomial_form(const EquationSystem& system, Constants constants, std::string_view language) {
  for (std::size_t i = 0; i < system.equations.size(); ++i) {
    const std::vector<bool> reached = reachable_from(std::span(&system.equations[i], 1));
    for (std::uint32_t node = 0; node < reached.size(); ++node) {
      if (!reached[node]) continue;
      const std::string reason = obstacle(system.graph->node(node), constants);
      if (reason.empty()) continue;
      throw NotApplicable(std::string(language) + " has polynomials only, but equation " +
                          std::to_string(i + 1) + " contains " + reason);
    }
  }
}

}  // namespace gcslab
