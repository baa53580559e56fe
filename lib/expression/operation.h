#pragma once

// The operations of the expression language, each declared once: name, number of operands, where it is
// defined.

#include <cstdint>
#include <optional>
#include <string_view>

namespace gcslab {

enum class Operation : std::uint8_t {
  // leaves
  constant,
  pi,
  variable,
  // arithmetic
  add,
  subtract,
  negate,
  multiply,
  divide,
  power_integer,   ///< x^n, n an integer
  power_rational,  ///< x^(p/q), q > 1
  sqr,
  // functions of one argument
  sqrt,
  cbrt,
  exp,
  log,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  abs,
  // functions of two arguments
  min,
  max
};

struct OperationInfo {
  Operation operation;
  std::string_view name;  ///< as a user writes it; empty for leaves and operators
  std::string_view latex;
  int operands;
  bool total;  ///< defined and continuous for every real argument
};

const OperationInfo& info(Operation operation);

/// The function of that name ("sqrt", "min", ...).
std::optional<Operation> function_named(std::string_view name);

}  // namespace gcslab
