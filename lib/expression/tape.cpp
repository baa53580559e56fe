#include "expression/tape.h"

#include "base/check.h"

namespace gcslab {
namespace {

constexpr std::uint32_t kUnassigned = ~0u;

}  // namespace

Tape::Tape(std::span<const Expression> outputs, int variables)
    : variables_(static_cast<std::size_t>(variables)) {
  GCSLAB_CHECK(!outputs.empty());
  ExpressionGraph& graph = outputs.front().graph();
  const std::vector<bool> needed = reachable_from(outputs);
  std::vector<std::uint32_t> register_of(needed.size(), kUnassigned);
  for (std::uint32_t i = 0; i < needed.size(); ++i) {  // leaves first
    if (!needed[i]) continue;
    const Expression e = graph.node(i);
    if (e.operation() == Operation::variable) {
      GCSLAB_CHECK(e.variable() < variables);
      register_of[i] = static_cast<std::uint32_t>(e.variable());
    } else if (e.operation() == Operation::constant || e.operation() == Operation::pi) {
      if (e.operation() == Operation::pi) pi_constant_ = static_cast<std::ptrdiff_t>(constants_.size());
      register_of[i] = static_cast<std::uint32_t>(variables_ + constants_.size());
      constants_.push_back(e.is_constant() ? e.constant() : Rational(0));
    }
  }
  for (std::uint32_t i = 0; i < needed.size(); ++i) {
    if (!needed[i] || register_of[i] != kUnassigned) continue;
    const Expression e = graph.node(i);
    Instruction instruction{e.operation(), register_of[e.operand(0).index()], 0};
    if (info(e.operation()).operands == 2) instruction.b = register_of[e.operand(1).index()];
    if (e.operation() == Operation::power_integer || e.operation() == Operation::power_rational) {
      instruction.b = static_cast<std::uint32_t>(exponents_.size());
      exponents_.push_back(e.exponent());
    }
    register_of[i] = static_cast<std::uint32_t>(registers());
    instructions_.push_back(instruction);
  }
  for (const Expression& output : outputs) outputs_.push_back(register_of[output.index()]);
}

}  // namespace gcslab
