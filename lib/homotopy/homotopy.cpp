#include "homotopy/homotopy.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "expression/substitute.h"
#include "polynomial/recognise.h"

namespace gcslab {
namespace {

/// With more terms a tape is faster. A volume of four points has 24.
constexpr std::size_t kTerms = 60;

}  // namespace

Homotopy::Homotopy(const GeometricEquations& equations, std::unique_ptr<ParameterPath> path, double unit)
    : m_(equations.unknowns.size()),
      path_(std::move(path)),
      weights_(m_, 1.0),
      x_(m_ + equations.parameters.size()),
      speed_(x_.size(), unit),
      column_(x_.size(), m_) {
  GCSLAB_CHECK(equations.equations.size() == m_);
  for (std::size_t i = 0; i < m_; ++i) column_[i] = i;
  for (std::size_t i = m_ - equations.auxiliaries; i < m_; ++i) speed_[i] = 1;
  for (std::size_t k = 0; k < m_; ++k) add(equations.equations[k], k);
}

void Homotopy::add(const Expression& equation, std::size_t row) {
  const std::vector<bool> reached = reachable_from({&equation, 1});
  std::vector<std::size_t> variables;
  for (std::uint32_t node = 0; node < reached.size(); ++node) {
    const Expression e = equation.graph().node(node);
    if (reached[node] && e.operation() == Operation::variable)
      variables.push_back(static_cast<std::size_t>(e.variable()));
  }
  std::ranges::sort(variables);
  std::vector<std::uint32_t>& columns = pattern_.emplace_back();
  for (const std::size_t variable : variables) {
    if (variable < m_) columns.push_back(static_cast<std::uint32_t>(variable));
  }
  columns.push_back(static_cast<std::uint32_t>(m_));  // of parameters, and where it is perturbed
  auto graph = std::make_unique<ExpressionGraph>();
  const std::size_t all = variables.empty() ? 0 : variables.back() + 1;
  std::vector<Expression> replacements(all, graph->constant(0));
  for (std::size_t i = 0; i < variables.size(); ++i)
    replacements[variables[i]] = graph->variable(static_cast<int>(i));
  const Expression local = substitute(equation, *graph, replacements);
  const int count = static_cast<int>(variables.size());
  const Recognition recognition = recognise_polynomial(local, count, {.terms = kTerms, .degree = 3});
  if (recognition.polynomial) {
    forms_.add(row, *recognition.polynomial, variables);
    return;
  }
  auto tape = std::make_unique<Tape>(local, count);
  auto evaluator = std::make_unique<TapeEvaluator<double>>(*tape);
  std::vector<double> point(variables.size());
  equations_.push_back(
      {row, std::move(graph), std::move(tape), std::move(evaluator), std::move(variables), std::move(point)});
}

std::vector<double> Homotopy::point(std::span<const double> unknowns, double t) const {
  std::vector<double> v;
  for (std::size_t i = 0; i < m_; ++i) v.push_back(unknowns[i] / speed_[i]);
  v.push_back(t);
  return v;
}

std::vector<double> Homotopy::unknowns(std::span<const double> v) const {
  std::vector<double> result;
  for (std::size_t i = 0; i < m_; ++i) result.push_back(speed_[i] * v[i]);
  return result;
}

void Homotopy::move_to(std::span<const double> v) {
  for (std::size_t i = 0; i < m_; ++i) x_[i] = speed_[i] * v[i];
  path_->at(v[m_], std::span(x_).subspan(m_), std::span(speed_).subspan(m_));
}

bool Homotopy::evaluate(Equation& equation) {
  for (std::size_t i = 0; i < equation.variables.size(); ++i) equation.point[i] = x_[equation.variables[i]];
  equation.evaluator->evaluate(equation.point);
  return std::isfinite(equation.evaluator->value());
}

bool Homotopy::values(std::span<const double> v, std::span<double> result) {
  move_to(v);
  forms_.values(x_, result);
  for (Equation& equation : equations_) {
    if (!evaluate(equation)) return false;
    result[equation.row] = weights_[equation.row] * equation.evaluator->value();
  }
  for (const auto& [row, start, leading] : offsets_) result[row] -= (1 - v[m_]) * (start + leading * v[m_]);
  return true;
}

bool Homotopy::jacobian(std::span<const double> v, std::span<double> result, Matrix<double>& derivatives) {
  move_to(v);
  for (std::size_t row = 0; row < m_; ++row) {
    for (const std::uint32_t column : pattern_[row]) derivatives(row, column) = 0;
  }
  forms_.values(x_, result);
  forms_.add_derivatives(x_, speed_, column_, derivatives);
  for (Equation& equation : equations_) {
    if (!evaluate(equation)) return false;
    const double weight = weights_[equation.row];
    result[equation.row] = weight * equation.evaluator->value();
    const std::span<const double> gradient = equation.evaluator->reverse_gradient();
    for (std::size_t i = 0; i < equation.variables.size(); ++i) {
      const std::size_t x = equation.variables[i];
      const double derivative = weight * gradient[i] * speed_[x];
      if (!std::isfinite(derivative)) return false;
      derivatives(equation.row, column_[x]) += derivative;
    }
  }
  const double t = v[m_];
  for (const auto& [row, start, leading] : offsets_) {
    result[row] -= (1 - t) * (start + leading * t);
    derivatives(row, m_) -= leading * (1 - 2 * t) - start;
  }
  return true;
}

void Homotopy::balance(std::span<const double> v) {
  std::vector<double> result(m_);
  Matrix<double> derivatives(m_, m_ + 1);
  if (!jacobian(v, result, derivatives)) return;
  for (std::size_t k = 0; k < m_; ++k) {
    double largest = 0;
    for (const double d : derivatives.row(k)) largest = std::max(largest, std::abs(d));
    if (!(largest > 0)) continue;
    forms_.scale(k, 1 / largest);
    weights_[k] /= largest;
  }
}

void Homotopy::perturb(std::size_t equation, std::span<const double> start, double leading) {
  std::vector<double> result(m_);
  if (values(start, result)) offsets_.push_back({equation, result[equation], leading});
}

double Homotopy::residual(std::span<const double> v) {
  std::vector<double> result(m_);
  if (!values(v, result)) return HUGE_VAL;
  double largest = 0;
  for (std::size_t k = 0; k < m_; ++k) largest = std::max(largest, std::abs(result[k]) / weights_[k]);
  return largest;
}

}  // namespace gcslab
