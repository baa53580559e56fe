#include "homotopy/homotopy.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/check.h"
#include "expression/substitute.h"

namespace gcslab {

Homotopy::Homotopy(const GeometricEquations& equations, std::unique_ptr<ParameterPath> path)
    : path_(std::move(path)),
      parameters_(equations.parameters.size()),
      derivatives_(equations.parameters.size()) {
  GCSLAB_CHECK(equations.equations.size() == equations.unknowns.size());
  for (const Expression& equation : equations.equations)
    equations_.push_back(localised(equation, equations.unknowns.size()));
}

Homotopy::Equation Homotopy::localised(const Expression& equation, std::size_t unknowns) {
  Equation result;
  result.graph = std::make_unique<ExpressionGraph>();
  const std::vector<bool> reached = reachable_from({&equation, 1});
  std::vector<std::size_t> variables;
  for (std::uint32_t node = 0; node < reached.size(); ++node) {
    const Expression e = equation.graph().node(node);
    if (reached[node] && e.operation() == Operation::variable)
      variables.push_back(static_cast<std::size_t>(e.variable()));
  }
  std::ranges::sort(variables);
  const std::size_t all = variables.empty() ? 0 : variables.back() + 1;
  std::vector<Expression> replacements(all, result.graph->constant(0));
  for (std::size_t i = 0; i < variables.size(); ++i) {
    replacements[variables[i]] = result.graph->variable(static_cast<int>(i));
    if (variables[i] < unknowns) {
      result.unknowns.push_back(variables[i]);
    } else {
      result.parameters.push_back(variables[i] - unknowns);
    }
  }
  result.tape = std::make_unique<Tape>(substitute(equation, *result.graph, replacements),
                                       static_cast<int>(variables.size()));
  result.evaluator = std::make_unique<TapeEvaluator<double>>(*result.tape);
  result.point.resize(variables.size());
  return result;
}

bool Homotopy::evaluate(Equation& equation, std::span<const double> v) {
  double* place = equation.point.data();
  for (const std::size_t i : equation.unknowns) *place++ = v[i];
  for (const std::size_t p : equation.parameters) *place++ = parameters_[p];
  equation.evaluator->evaluate(equation.point);
  return std::isfinite(equation.evaluator->value());
}

bool Homotopy::values(std::span<const double> v, std::span<double> result) {
  path_->at(v[size()], parameters_, derivatives_);
  for (std::size_t k = 0; k < size(); ++k) {
    if (!evaluate(equations_[k], v)) return false;
    result[k] = equations_[k].evaluator->value();
  }
  return true;
}

bool Homotopy::jacobian(std::span<const double> v, std::span<double> result, Matrix<double>& derivatives) {
  path_->at(v[size()], parameters_, derivatives_);
  for (std::size_t k = 0; k < size(); ++k) {
    Equation& equation = equations_[k];
    if (!evaluate(equation, v)) return false;
    result[k] = equation.evaluator->value();
    const std::span<const double> gradient = equation.evaluator->reverse_gradient();
    for (std::size_t j = 0; j <= size(); ++j) derivatives(k, j) = 0;
    std::size_t place = 0;
    for (const std::size_t i : equation.unknowns) derivatives(k, i) = gradient[place++];
    for (const std::size_t p : equation.parameters)
      derivatives(k, size()) += gradient[place++] * derivatives_[p];
    if (!std::isfinite(derivatives(k, size()))) return false;
  }
  return true;
}

}  // namespace gcslab
