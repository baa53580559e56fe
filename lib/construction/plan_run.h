#pragma once

// A plan carried out over a number type: doubles, jets, intervals.

#include <span>
#include <vector>

#include "construction/plan_program.h"
#include "expression/tape_registers.h"

namespace gcslab {

template <class T>
class PlanRun {
 public:
  /// The program must outlive it.
  explicit PlanRun(const PlanProgram& program)
      : program_(&program), x_(program.variables(), NumberTraits<T>::from_rational(0)) {
    for (const StepFormulas& step : program.steps()) steps_.emplace_back(step.formulas);
    removed_.emplace_back(program.removed());
  }

  /// The variables of the program, to be set before the steps are taken: parameters, guides, offsets.
  std::vector<T>& variables() { return x_; }
  const std::vector<T>& variables() const { return x_; }

  /// Computes the formulas of a step, when the points before it have their places.
  void prepare(std::size_t step) { steps_[step].run(x_); }
  /// h^2, of a prepared step that involves spheres.
  const T& radicand(std::size_t step) const { return steps_[step].last(); }
  /// Q and u of a prepared step with two places.
  const T& base(std::size_t step, std::size_t axis) const { return steps_[step].output(axis); }
  const T& direction(std::size_t step, std::size_t axis) const {
    return steps_[step].output(program_->steps()[step].dimensions + axis);
  }

  /// Gives the point of a prepared step its place; the height is that of two places.
  void place(std::size_t step, const T& height) {
    const StepFormulas& formulas = program_->steps()[step];
    for (std::size_t i = 0; i < formulas.dimensions; ++i) {
      T& x = x_[formulas.first + i];
      if (formulas.form == StepForm::two_places) {
        x = base(step, i) + height * direction(step, i);
      } else {
        x = formulas.form == StepForm::on_axis ? sqrt(radicand(step)) : steps_[step].output(i);
      }
    }
  }

  /// What vanishes where the removed constraints hold, when all points have their places.
  void compute_removed() { removed_.front().run(x_); }
  const T& removed(std::size_t number) const { return removed_.front().output(number); }

 private:
  class Registers {
   public:
    explicit Registers(const Formulas& formulas) : formulas_(&formulas) {
      if (formulas.tape) registers_.emplace_back(*formulas.tape);
    }
    void run(const std::vector<T>& x) {
      if (registers_.empty()) return;
      TapeRegisters<T>& registers = registers_.front();
      for (std::size_t i = 0; i < formulas_->inputs.size(); ++i) registers[i] = x[formulas_->inputs[i]];
      registers.run();
    }
    const T& output(std::size_t k) const { return registers_.front()[formulas_->tape->outputs()[k]]; }
    const T& last() const { return registers_.front()[formulas_->tape->outputs().back()]; }

   private:
    const Formulas* formulas_;
    std::vector<TapeRegisters<T>> registers_;  ///< one, or none where nothing is computed
  };

  const PlanProgram* program_;
  std::vector<T> x_;
  std::vector<Registers> steps_, removed_;
};

}  // namespace gcslab
