#include "box_solver/lifted_system.h"

#include <algorithm>
#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>

namespace gcslab {
namespace {

bool is_polynomial_step(Expression e) {
  switch (e.operation()) {
    case Operation::add:
    case Operation::subtract:
    case Operation::negate:
    case Operation::multiply:
    case Operation::sqr:
      return true;
    case Operation::divide:
      return e.operand(1).is_constant();
    case Operation::power_integer:
      return e.exponent() >= 0;
    default:
      return false;
  }
}

bool is_leaf(Expression e) {
  return e.operation() == Operation::constant || e.operation() == Operation::variable;
}

/// A step that a polynomial in its result and operands describes.
bool is_algebraic(Expression e) {
  return e.operation() == Operation::divide || e.operation() == Operation::sqrt ||
         e.operation() == Operation::power_integer;
}

bool has_variables(Expression e) {
  const std::vector<bool> reached = reachable_from({&e, 1});
  for (std::uint32_t i = 0; i < reached.size(); ++i) {
    if (reached[i] && e.graph().node(i).operation() == Operation::variable) return true;
  }
  return false;
}

class TermFinder {
 public:
  explicit TermFinder(std::size_t variables) : variables_(variables) {}

  void search(const std::vector<SystemFunction>& functions, bool is_equation) {
    for (std::size_t k = 0; k < functions.size(); ++k) {
      place_ = {is_equation, k, {}};
      visit(functions[k].expression);
    }
  }

  std::vector<Term> take() { return std::move(terms_); }

 private:
  void visit(Expression e) {
    if (is_leaf(e) || !visited_.insert(e.index()).second) return;
    if (is_polynomial_step(e) || is_algebraic(e)) {
      visit_operands(e);
      if (is_algebraic(e) && !is_polynomial_step(e)) add(e, std::nullopt);
    } else if (e.operation() == Operation::pi || info(e.operation()).operands != 1 || !has_variables(e)) {
      add(e, std::nullopt);
    } else {
      visit_operands(e);
      add(e, argument_of(e));
    }
  }

  void visit_operands(Expression e) {
    for (int i = 0; i < info(e.operation()).operands; ++i) {
      place_.operands.push_back(i);
      visit(e.operand(i));
      place_.operands.pop_back();
    }
  }

  /// The variable that stands for the operand; a new term when there is none.
  std::size_t argument_of(Expression e) {
    const Expression operand = e.operand(0);
    if (operand.operation() == Operation::variable) return static_cast<std::size_t>(operand.variable());
    const auto found = std::ranges::find(terms_, operand, &Term::expression);
    const auto number = static_cast<std::size_t>(found - terms_.begin());
    if (found == terms_.end()) {
      place_.operands.push_back(0);
      add(operand, std::nullopt);
      place_.operands.pop_back();
    }
    return variables_ + number;
  }

  void add(Expression e, std::optional<std::size_t> argument) { terms_.push_back({e, place_, argument}); }

  std::size_t variables_;
  ExpressionPlace place_{};
  std::vector<Term> terms_;
  std::unordered_set<std::uint32_t> visited_;
};

class Lifter {
 public:
  Lifter(const EquationSystem& system, const std::vector<Term>& terms) : system_(system), terms_(terms) {
    int number = static_cast<int>(system.variables.size());
    for (const Term& term : terms) done_.emplace(term.expression.index(), graph().variable(number++));
  }

  EquationSystem run() {
    lifted_.variables = system_.variables;
    for (std::size_t t = 0; t < terms_.size(); ++t) lifted_.variables.push_back("term " + std::to_string(t));
    for (const Expression& e : system_.equations) lifted_.equations.push_back(lift(e));
    for (const Term& term : terms_) add_relation(term.expression);
    for (const Expression& e : system_.inequalities) lifted_.inequalities.push_back(lift(e));
    return std::move(lifted_);
  }

 private:
  ExpressionGraph& graph() { return *lifted_.graph; }

  /// The expression with variables in place of terms.
  Expression lift(Expression e) {
    if (const auto found = done_.find(e.index()); found != done_.end()) return found->second;
    return done_.emplace(e.index(), lift_inside(e)).first->second;
  }

  /// The same, but for the expression itself.
  Expression lift_inside(Expression e) {
    switch (e.operation()) {
      case Operation::constant:
        return graph().constant(e.constant());
      case Operation::variable:
        return graph().variable(e.variable());
      case Operation::power_integer:
        return graph().power(lift(e.operand(0)), e.exponent());
      default:
        break;
    }
    if (info(e.operation()).operands == 1) return graph().apply(e.operation(), lift(e.operand(0)));
    return graph().apply(e.operation(), lift(e.operand(0)), lift(e.operand(1)));
  }

  void add_relation(Expression e) {
    const Expression t = done_.at(e.index());
    if (is_polynomial_step(e)) {
      lifted_.equations.push_back(t - lift_inside(e));
    } else if (e.operation() == Operation::divide) {
      lifted_.equations.push_back(t * lift(e.operand(1)) - lift(e.operand(0)));
    } else if (e.operation() == Operation::sqrt) {
      lifted_.equations.push_back(sqr(t) - lift(e.operand(0)));
    } else if (e.operation() == Operation::power_integer) {
      lifted_.equations.push_back(t * graph().power(lift(e.operand(0)), -e.exponent()) - graph().constant(1));
    }
  }

  const EquationSystem& system_;
  const std::vector<Term>& terms_;
  EquationSystem lifted_;
  std::unordered_map<std::uint32_t, Expression> done_;  ///< by number of the node
};

}  // namespace

std::vector<Term> terms_of(const SystemFunctions& functions) {
  TermFinder finder(functions.variables());
  finder.search(functions.equations(), true);
  finder.search(functions.inequalities(), false);
  return finder.take();
}

LiftedSystem::LiftedSystem(const SystemFunctions& functions)
    : original_(&functions), terms_(terms_of(functions)) {
  if (!terms_.empty()) lifted_.emplace(Lifter(functions.system(), terms_).run());
}

}  // namespace gcslab
