#include "expression/operation.h"

#include <array>

#include "base/check.h"

namespace gcslab {
namespace {

using enum Operation;

constexpr std::array<OperationInfo, 24> kOperations = {{
    {constant, "", "", 0, true},
    {pi, "", "\\pi", 0, true},
    {variable, "", "", 0, true},
    {add, "", "", 2, true},
    {subtract, "", "", 2, true},
    {negate, "", "", 1, true},
    {multiply, "", "", 2, true},
    {divide, "", "", 2, false},
    {power_integer, "", "", 1, false},
    {power_rational, "", "", 1, false},
    {sqr, "sqr", "", 1, true},
    {sqrt, "sqrt", "\\sqrt", 1, false},
    {cbrt, "cbrt", "\\sqrt[3]", 1, true},
    {exp, "exp", "\\exp", 1, true},
    {log, "log", "\\log", 1, false},
    {sin, "sin", "\\sin", 1, true},
    {cos, "cos", "\\cos", 1, true},
    {tan, "tan", "\\tan", 1, false},
    {asin, "asin", "\\arcsin", 1, false},
    {acos, "acos", "\\arccos", 1, false},
    {atan, "atan", "\\arctan", 1, true},
    {abs, "abs", "\\left|", 1, true},
    {min, "min", "\\min", 2, true},
    {max, "max", "\\max", 2, true},
}};

}  // namespace

const OperationInfo& info(Operation operation) {
  const OperationInfo& entry = kOperations.at(static_cast<std::size_t>(operation));
  GCSLAB_CHECK(entry.operation == operation);
  return entry;
}

std::optional<Operation> function_named(std::string_view name) {
  if (name.empty()) return std::nullopt;
  for (const OperationInfo& entry : kOperations) {
    if (entry.name == name) return entry.operation;
  }
  return std::nullopt;
}

}  // namespace gcslab
