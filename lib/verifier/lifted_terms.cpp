#include "verifier/lifted_terms.h"

#include <algorithm>

namespace gcslab::verifier {
namespace {

constexpr int kPieces = 64;

bool is_multiplied_out(Expression e) {
  switch (e.operation()) {
    case Operation::add:
    case Operation::subtract:
    case Operation::negate:
    case Operation::multiply:
    case Operation::sqr:
      return true;
    case Operation::power_integer:
      return e.exponent() >= 0;
    default:
      return false;
  }
}

bool has_exponent(Expression e) {
  return e.operation() == Operation::power_integer || e.operation() == Operation::power_rational;
}

}  // namespace

LiftedTerms::LiftedTerms(JudgedSystem& system) : original_(&system) {}

bool LiftedTerms::add(bool is_equation, std::size_t function, const std::vector<std::size_t>& operands) {
  std::vector<JudgedFunction>& functions = is_equation ? original_->equations() : original_->inequalities();
  if (judged_ || function >= functions.size()) return false;
  Expression e = functions[function].expression;
  for (const std::size_t number : operands) {
    if (number >= static_cast<std::size_t>(info(e.operation()).operands)) return false;
    e = e.operand(static_cast<int>(number));
  }
  const int variable = static_cast<int>(original_->variables() + terms_.size());
  if (!done_.emplace(e.index(), system_.graph->variable(variable)).second) return false;
  terms_.push_back({e, Program(e, original_->variables()), nullptr, std::nullopt, {}, {}});
  make_function(terms_.back());
  return true;
}

void LiftedTerms::make_function(NamedTerm& term) {
  const Expression e = term.expression;
  if (info(e.operation()).operands != 1) return;
  term.graph = std::make_unique<ExpressionGraph>();
  const Expression x = term.graph->variable(0);
  term.function.emplace(
      has_exponent(e) ? term.graph->power(x, e.exponent()) : term.graph->apply(e.operation(), x), 1);
}

JudgedSystem& LiftedTerms::system() {
  if (judged_) return *judged_;
  system_.variables.resize(original_->variables() + terms_.size());
  for (const JudgedFunction& equation : original_->equations())
    system_.equations.push_back(lifted(equation.expression));
  for (const NamedTerm& term : terms_) {
    if (const auto equation = relation(term.expression)) system_.equations.push_back(*equation);
  }
  for (const JudgedFunction& inequality : original_->inequalities())
    system_.inequalities.push_back(lifted(inequality.expression));
  return judged_.emplace(system_);
}

/// The expression with variables in place of terms.
Expression LiftedTerms::lifted(Expression e) {
  const auto found = done_.find(e.index());
  if (found != done_.end()) return found->second;
  return done_.emplace(e.index(), rebuilt(e)).first->second;
}

/// The same, but for the expression itself.
Expression LiftedTerms::rebuilt(Expression e) {
  ExpressionGraph& graph = *system_.graph;
  switch (info(e.operation()).operands) {
    case 1: {
      const Expression inside = lifted(e.operand(0));
      return has_exponent(e) ? graph.power(inside, e.exponent()) : graph.apply(e.operation(), inside);
    }
    case 2:
      return graph.apply(e.operation(), lifted(e.operand(0)), lifted(e.operand(1)));
    default:
      break;
  }
  if (e.operation() == Operation::variable) return graph.variable(e.variable());
  return e.operation() == Operation::pi ? graph.pi() : graph.constant(e.constant());
}

/// What is 0 by what a term is.
std::optional<Expression> LiftedTerms::relation(Expression e) {
  const Expression t = lifted(e);
  if (is_multiplied_out(e)) return t - rebuilt(e);
  if (e.operation() == Operation::divide) return t * lifted(e.operand(1)) - lifted(e.operand(0));
  if (e.operation() == Operation::sqrt) return sqr(t) - lifted(e.operand(0));
  if (e.operation() == Operation::power_integer)
    return t * system_.graph->power(lifted(e.operand(0)), -e.exponent()) - system_.graph->constant(1);
  return std::nullopt;
}

bool LiftedTerms::lie_within(const Box& sides, const Box& box) {
  const RangeBox ranges = ranges_of(box);
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    if (!terms_[t].program.evaluate(ranges).is_within(sides[t])) return false;
  }
  return true;
}

std::optional<std::size_t> LiftedTerms::argument(std::size_t term) const {
  if (!terms_[term].function) return std::nullopt;
  const Expression operand = terms_[term].expression.operand(0);
  if (operand.operation() == Operation::variable) return static_cast<std::size_t>(operand.variable());
  const auto found = std::ranges::find(terms_, operand, &NamedTerm::expression);
  if (found == terms_.end()) return std::nullopt;
  return original_->variables() + static_cast<std::size_t>(found - terms_.begin());
}

Range LiftedTerms::strip(std::size_t term, double slope, const Interval& x) {
  NamedTerm& named = terms_[term];
  if (named.side != x) named.strips.clear();
  named.side = x;
  const auto found = named.strips.find(slope);
  if (found != named.strips.end()) return found->second;
  return named.strips.emplace(slope, strip_over(*named.function, slope, x)).first->second;
}

/// On each of many pieces by the values, and by the slopes from either end of it.
Range LiftedTerms::strip_over(Program& function, double slope, const Interval& x) {
  const Range start(x.lower), whole = Range(x.upper) - start;
  const auto place = [&](int i) { return start + whole * (Range(i) / Range(kPieces)); };
  Range result = Range::empty();
  for (int i = 0; i < kPieces; ++i) {
    const Range left = place(i), right = place(i + 1), piece = intersection(hull(left, right), Range(x));
    const auto value = [&](const Range& at) { return function.evaluate({&at, 1}) - Range(slope) * at; };
    Range range = value(piece);
    if (function.is_defined_everywhere()) {
      const Range rise = function.gradient()[0] - Range(slope);
      for (const Range& end : {left, right}) range = intersection(range, value(end) + rise * (piece - end));
    }
    result = hull(result, range);
  }
  return result;
}

}  // namespace gcslab::verifier
