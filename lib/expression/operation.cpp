#include "expression/operation.h"

#include <array>

#include "base/check.h"

namespace gcslab {
namespace {

using enum Operation;

constexpr std::array<OperationInfo, 24> kOperations = {{
    {constant, "", "", 0, true, true},
    {pi, "", "\\pi", 0, false, true},
    {variable, "", "", 0, true, true},
    {add, "", "", 2, true, true},
    {subtract, "", "", 2, true, true},
    {negate, "", "", 1, true, true},
    {multiply, "", "", 2, true, true},
    {divide, "", "", 2, false, false},
    {power_integer, "", "", 1, true, false},
    {power_rational, "", "", 1, false, false},
    {sqr, "sqr", "", 1, true, true},
    {sqrt, "sqrt", "\\sqrt", 1, false, false},
    {cbrt, "cbrt", "\\sqrt[3]", 1, false, true},
    {exp, "exp", "\\exp", 1, false, true},
    {log, "log", "\\log", 1, false, false},
    {sin, "sin", "\\sin", 1, false, true},
    {cos, "cos", "\\cos", 1, false, true},
    {tan, "tan", "\\tan", 1, false, false},
    {asin, "asin", "\\arcsin", 1, false, false},
    {acos, "acos", "\\arccos", 1, false, false},
    {atan, "atan", "\\arctan", 1, false, true},
    {abs, "abs", "\\left|", 1, false, true},
    {min, "min", "\\min", 2, false, true},
    {max, "max", "\\max", 2, false, true},
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
