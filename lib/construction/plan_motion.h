#pragma once

// How what a plan constructs from moves along a homotopy: parameters, offsets of the constraints, guides.

#include "construction/plan_run.h"
#include "homotopy/parameter_path.h"

namespace gcslab {

/// Offsets go from their start to 0 as (1 - t) (start + leading t).
struct OffsetMotion {
  std::vector<double> start, leading;  ///< one a constraint
};

class PlanMotion {
 public:
  /// Guides are in units. One thread uses it at a time. The program and the path must outlive it.
  PlanMotion(const PlanProgram& program, const ParameterPath& path, OffsetMotion offsets, double unit)
      : program_(&program),
        path_(&path),
        offsets_(std::move(offsets)),
        unit_(unit),
        parameters_(program.parameters()),
        speeds_(program.parameters()) {}

  const PlanProgram& program() const { return *program_; }
  double unit() const { return unit_; }
  std::size_t guides() const { return program_->plan().guides.size(); }

  /// Those of the constraint system at t; they live as long as it and no other t is asked for.
  const std::vector<double>& parameters(double t) const {
    path_->at(t, parameters_, speeds_);
    return parameters_;
  }

  /// Sets the variables of a run for the guides and t. `seed(value, column, speed)` makes the number that
  /// moves with coordinate number `column` at that speed: guides are coordinates 0, 1, ..., t is `t_column`.
  template <class T, class Seed>
  void set(PlanRun<T>& run, std::span<const double> guides, double t, std::size_t t_column,
           const Seed& seed) const {
    parameters(t);
    std::vector<T>& x = run.variables();
    for (std::size_t p = 0; p < parameters_.size(); ++p)
      x[program_->parameter(p)] = seed(parameters_[p], t_column, speeds_[p]);
    for (std::size_t c = 0; c < offsets_.start.size(); ++c) {
      const double start = offsets_.start[c], leading = offsets_.leading[c];
      x[program_->offset(c)] = seed((1 - t) * (start + leading * t), t_column, leading * (1 - 2 * t) - start);
    }
    for (std::size_t g = 0; g < guides.size(); ++g) x[program_->guide(g)] = seed(unit_ * guides[g], g, unit_);
  }

 private:
  const PlanProgram* program_;
  const ParameterPath* path_;
  OffsetMotion offsets_;
  double unit_;
  mutable std::vector<double> parameters_, speeds_;
};

}  // namespace gcslab
