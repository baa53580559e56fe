#pragma once

// A plan as formulas: for each step a tape that gives the place of its point in the coordinates of the points
// before it.
//
// Where spheres take part, the point is X = Q + h u with u of length 1 and h^2 = r: Q, u and the *radicand* r
// are given, the *height* h is one of the two roots. The plan is defined where no radicand is negative, and
// two branches meet where one is 0. The formulas are made for differences from the centre of one of the
// spheres, so that no digits are lost far from the origin: X = C + Y, where Y lies in the planes n.Y + o = 0,
// that of two spheres being the plane in which they meet.

#include <memory>

#include "construction/plan.h"
#include "expression/tape.h"

namespace gcslab {

enum class StepForm {
  origin,      ///< nothing is computed
  on_axis,     ///< outputs: the radicand; X = (sqrt r, 0, 0)
  two_places,  ///< outputs: Q, u, r
  one_place    ///< outputs: X
};

/// Formulas over the variables of a program that occur in them.
struct Formulas {
  std::unique_ptr<Tape> tape;
  std::vector<std::size_t> inputs;
};

struct StepFormulas {
  StepForm form;
  std::size_t point;
  std::size_t dimensions;  ///< coordinates of the point that are not 0
  std::size_t first;       ///< of its coordinates among the variables
  std::optional<std::size_t> choice;
  Formulas formulas;
  /// The loci themselves, of steps that compute something: outputs: n and o of each plane, then, where
  /// spheres take part, C and the square of the radius of the sphere around C.
  Formulas loci;
  std::size_t planes = 0;
};

/// The variables: all coordinates of the points in order, the parameters of the constraints, the guides, and
/// for each constraint an *offset*, which its equation equals in place of 0.
class PlanProgram {
 public:
  /// Throws NotApplicable where a removed constraint has auxiliary unknowns.
  PlanProgram(const ConstraintSystem& system, Plan plan);

  const Plan& plan() const { return plan_; }
  std::size_t dimension() const { return dimension_; }
  std::size_t points() const { return plan_.steps.size(); }
  std::size_t constraints() const { return constraints_; }
  std::size_t parameters() const { return parameters_; }
  std::size_t variables() const { return offset(constraints_); }
  std::size_t parameter(std::size_t number) const { return points() * dimension_ + number; }
  std::size_t guide(std::size_t number) const { return parameter(parameters_) + number; }
  std::size_t offset(std::size_t constraint) const { return guide(plan_.guides.size()) + constraint; }

  const std::vector<StepFormulas>& steps() const { return steps_; }
  /// What vanishes where the removed constraints hold: an output each, offsets included.
  const Formulas& removed() const { return removed_; }
  /// Of every constraint what its offset is to be for it to hold in a figure; 0 for constraints of several
  /// equations, which have no offset.
  const Formulas& offsets() const { return offsets_; }

 private:
  Plan plan_;
  std::size_t dimension_, parameters_, constraints_;
  std::vector<StepFormulas> steps_;
  Formulas removed_, offsets_;
};

}  // namespace gcslab
