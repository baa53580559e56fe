#include "verifier/judged_system.h"

namespace gcslab::verifier {
namespace {

JudgedFunction judged(Expression expression, std::size_t variables) {
  JudgedFunction result{expression, Program(expression, variables), polynomial_terms(expression, variables),
                        -1};
  if (result.polynomial) result.degree = total_degree(*result.polynomial);
  return result;
}

}  // namespace

JudgedSystem::JudgedSystem(const EquationSystem& system) : variables_(system.variables.size()) {
  for (const Expression& e : system.equations) equations_.push_back(judged(e, variables_));
  for (const Expression& e : system.inequalities) inequalities_.push_back(judged(e, variables_));
}

bool JudgedSystem::slopes(std::size_t equation, std::span<const Range> box, std::span<const Range> centre,
                          std::vector<Range>& row) {
  const Range half(0.5);
  JudgedFunction& f = equations_[equation];
  const bool is_quadratic = f.degree >= 0 && f.degree <= 2;
  between_.resize(variables_);
  for (const std::size_t i : f.program.variables())
    between_[i] = is_quadratic ? (box[i] + centre[i]) * half : hull(box[i], centre[i]);
  f.program.evaluate(between_);
  if (!f.program.is_defined_everywhere()) return false;
  row = f.program.gradient();
  return true;
}

bool JudgedSystem::slopes(std::span<const Range> box, std::span<const Range> centre, RangeMatrix& rows) {
  rows.resize(equations_.size());
  for (std::size_t k = 0; k < equations_.size(); ++k) {
    if (!slopes(k, box, centre, rows[k])) return false;
  }
  return true;
}

}  // namespace gcslab::verifier
