#include "certification/system_functions.h"

#include <algorithm>

#include "base/check.h"
#include "interval/arithmetic.h"
#include "interval/point_numbers.h"
#include "interval/reverse_operations.h"
#include "polynomial/recognise.h"

namespace gcslab {
namespace {

/// Polynomials of more terms are handled as general functions: expanding them would only loosen them.
constexpr RecognitionLimits kLimits{.terms = 2000, .products = 200'000, .degree = 200, .bits = 20'000};

std::vector<std::size_t> variables_of(Expression expression) {
  const std::vector<bool> reached = reachable_from({&expression, 1});
  std::vector<std::size_t> result;
  for (std::uint32_t i = 0; i < reached.size(); ++i) {
    const Expression node = expression.graph().node(i);
    if (reached[i] && node.operation() == Operation::variable)
      result.push_back(static_cast<std::size_t>(node.variable()));
  }
  std::sort(result.begin(), result.end());
  return result;
}

SystemFunction compiled(Expression expression, std::size_t variables) {
  const int n = static_cast<int>(variables);
  SystemFunction result{expression, Tape(expression, n), variables_of(expression),
                        recognise_polynomial(expression, n, kLimits).polynomial, -1};
  if (result.polynomial) result.degree = result.polynomial->total_degree();
  return result;
}

}  // namespace

SystemFunctions::SystemFunctions(EquationSystem system) : system_(std::move(system)) {
  for (const Expression& e : system_.equations) equations_.push_back(compiled(e, variables()));
  for (const Expression& e : system_.inequalities) inequalities_.push_back(compiled(e, variables()));
}

std::size_t SystemFunctions::constraints() const {
  return static_cast<std::size_t>(std::ranges::count_if(equations_, [](const SystemFunction& equation) {
    return !equation.polynomial || !equation.polynomial->is_zero();
  }));
}

template <class T>
SystemEvaluator<T>::SystemEvaluator(const SystemFunctions& functions)
    : functions_(&functions),
      zero_(NumberTraits<T>::from_rational(0)),
      half_(NumberTraits<T>::from_rational(Rational(1, 2))) {
  for (const SystemFunction& equation : functions.equations()) evaluators_.emplace_back(equation.tape);
}

template <class T>
void SystemEvaluator<T>::values(std::span<const T> box, std::span<T> result) {
  for (std::size_t k = 0; k < evaluators_.size(); ++k) {
    evaluators_[k].evaluate(box);
    result[k] = evaluators_[k].value();
  }
}

template <class T>
bool SystemEvaluator<T>::gradient(std::size_t equation, std::span<const T> box, std::span<T> row) {
  TapeEvaluator<T>& evaluator = evaluators_[equation];
  evaluator.evaluate(box);
  if (!evaluator.defined_everywhere()) return false;
  std::ranges::copy(evaluator.reverse_gradient(), row.begin());
  return true;
}

template <class T>
bool SystemEvaluator<T>::jacobian(std::span<const T> box, Matrix<T>& result) {
  for (std::size_t k = 0; k < evaluators_.size(); ++k) {
    if (!gradient(k, box, result.row(k))) return false;
  }
  return true;
}

template <class T>
bool SystemEvaluator<T>::slopes(std::span<const T> box, std::span<const T> centre, Matrix<T>& result) {
  between_.assign(box.begin(), box.end());
  around_.assign(box.begin(), box.end());
  for (std::size_t i = 0; i < box.size(); ++i) {
    between_[i] = (box[i] + centre[i]) * half_;
    if constexpr (SetNumber<T>) around_[i] = hull(box[i], centre[i]);
  }
  for (std::size_t k = 0; k < evaluators_.size(); ++k) {
    const int degree = functions_->equations()[k].degree;
    const bool quadratic = degree >= 0 && degree <= 2;
    if (!gradient(k, quadratic ? between_ : around_, result.row(k))) return false;
  }
  return true;
}

template class SystemEvaluator<FastInterval>;
template class SystemEvaluator<BoostInterval>;
template class SystemEvaluator<MpfrInterval>;
template class SystemEvaluator<UnroundedInterval>;
template class SystemEvaluator<double>;

}  // namespace gcslab
