#include "construction/plan_program.h"

#include <algorithm>

#include "base/error.h"
#include "expression/differentiate.h"
#include "expression/substitute.h"

namespace gcslab {
namespace {

/// With the variables that occur numbered anew.
Formulas formulas_over(const std::vector<Expression>& outputs) {
  Formulas result;
  const std::vector<bool> reached = reachable_from(outputs);
  ExpressionGraph& graph = outputs.front().graph();
  for (std::uint32_t node = 0; node < reached.size(); ++node) {
    const Expression e = graph.node(node);
    if (reached[node] && e.operation() == Operation::variable)
      result.inputs.push_back(static_cast<std::size_t>(e.variable()));
  }
  std::ranges::sort(result.inputs);
  ExpressionGraph local;
  const std::size_t all = result.inputs.empty() ? 0 : result.inputs.back() + 1;
  std::vector<Expression> replacements(all, local.constant(0));
  for (std::size_t i = 0; i < result.inputs.size(); ++i)
    replacements[result.inputs[i]] = local.variable(static_cast<int>(i));
  std::vector<Expression> renumbered;
  for (const Expression& output : outputs) renumbered.push_back(substitute(output, local, replacements));
  result.tape = std::make_unique<Tape>(renumbered, static_cast<int>(result.inputs.size()));
  return result;
}

Vector scaled(const Expression& factor, const Vector& v) {
  Vector result;
  for (const Expression& x : v) result.push_back(factor * x);
  return result;
}

Vector sum(const Vector& a, const Vector& b) {
  Vector result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] + b[i]);
  return result;
}

/// n.Y + o = 0.
struct Plane {
  Vector normal;
  Expression offset;
};

/// -(o1 (n2 x n3) + ...) / det: where three planes, two lines meet, or a number.
Vector meeting_point(const std::vector<Plane>& planes) {
  if (planes.size() == 1) return {-planes[0].offset / planes[0].normal[0]};
  if (planes.size() == 2) {
    const Vector &a = planes[0].normal, &b = planes[1].normal;
    const Expression &p = planes[0].offset, &q = planes[1].offset;
    const Expression det = determinant(a, b);
    return {(q * a[1] - p * b[1]) / det, (p * b[0] - q * a[0]) / det};
  }
  const Vector &a = planes[0].normal, &b = planes[1].normal, &c = planes[2].normal;
  const Vector numerator =
      sum(sum(scaled(planes[0].offset, cross(b, c)), scaled(planes[1].offset, cross(c, a))),
          scaled(planes[2].offset, cross(a, b)));
  const Expression det = determinant(a, b, c);
  Vector result;
  for (const Expression& x : numerator) result.push_back(-x / det);
  return result;
}

/// The line in which planes meet (none: the line itself): its point nearest to the origin, and its direction,
/// of length 1.
struct Line {
  Vector nearest, direction;
};

Line meeting_line(const std::vector<Plane>& planes, ExpressionGraph& graph) {
  if (planes.empty()) return {{graph.constant(0)}, {graph.constant(1)}};
  const Expression one = graph.constant(1);
  if (planes.size() == 1) {
    const Vector& n = planes[0].normal;
    const Expression square = squared_norm(n);
    return {scaled(-planes[0].offset / square, n),
            scaled(one / graph.apply(Operation::sqrt, square), Vector{-n[1], n[0]})};
  }
  const Vector &a = planes[0].normal, &b = planes[1].normal;
  const Vector w = cross(a, b);
  const Expression square = squared_norm(w);
  const Vector numerator = sum(scaled(planes[0].offset, cross(b, w)), scaled(planes[1].offset, cross(w, a)));
  return {scaled(-one / square, numerator), scaled(one / graph.apply(Operation::sqrt, square), w)};
}

class FormulaMaker {
 public:
  FormulaMaker(const ConstraintSystem& system, const PlanProgram& program)
      : system_(&system),
        program_(&program),
        frame_(program.plan().frame(system.universe)),
        variables_(system),
        graph_(variables_.graph.get()) {
    for (std::size_t i = 0; i < program.variables(); ++i)
      identity_.push_back(graph_->variable(static_cast<int>(i)));
  }

  StepFormulas step(const PlanStep& step, std::size_t freedom) {
    StepFormulas result{StepForm::origin, step.point, freedom, step.point * program_->dimension(),
                        step.choice,      {},         {}};
    if (freedom == 0) return result;
    std::vector<Locus> loci;
    for (const LocusSource& source : step.loci) loci.push_back(locus(source, step.point));
    const auto sphere = std::ranges::find_if(loci, &Locus::is_sphere);
    if (sphere == loci.end()) {
      std::vector<Plane> planes;
      const Vector origin(freedom, graph_->constant(0));
      for (const Locus& plane : loci) planes.push_back(plane_at(plane, step.point, origin));
      result.form = StepForm::one_place;
      result.formulas = formulas_over(meeting_point(planes));
      result.loci = formulas_over(outputs_of(planes));
      result.planes = planes.size();
      return result;
    }
    std::iter_swap(loci.begin(), sphere);
    const Vector centre = centre_of(loci[0], step.point, freedom);
    const Expression at_centre = at(loci[0].equation, step.point, centre);
    std::vector<Plane> planes;
    for (std::size_t k = 1; k < loci.size(); ++k) {
      planes.push_back(plane_at(loci[k], step.point, centre));
      if (loci[k].is_sphere) planes.back().offset = planes.back().offset - at_centre;
    }
    const Line line = meeting_line(planes, *graph_);
    std::vector<Expression> outputs = sum(centre, line.nearest);
    outputs.insert(outputs.end(), line.direction.begin(), line.direction.end());
    outputs.push_back(-at_centre - squared_norm(line.nearest));
    result.form = freedom == 1 ? StepForm::on_axis : StepForm::two_places;
    if (freedom == 1) outputs = {outputs.back()};
    result.formulas = formulas_over(outputs);
    outputs = outputs_of(planes);
    outputs.insert(outputs.end(), centre.begin(), centre.end());
    outputs.push_back(-at_centre);
    result.loci = formulas_over(outputs);
    result.planes = planes.size();
    return result;
  }

  Formulas removed() {
    std::vector<Expression> outputs;
    for (const std::size_t c : program_->plan().removed) outputs.push_back(equation(c) - offset(c));
    return outputs.empty() ? Formulas{} : formulas_over(outputs);
  }

  Formulas offsets() {
    std::vector<Expression> outputs(program_->constraints(), graph_->constant(0));
    for (const std::size_t c : program_->plan().removed) outputs[c] = equation(c);
    for (const PlanStep& step : program_->plan().steps) {
      for (const LocusSource& source : step.loci) {
        if (source.constraint && has_offset(*source.constraint) &&
            !given_locus(source, step.point).is_absorbed)
          outputs[*source.constraint] = given_locus(source, step.point).equation;
      }
    }
    return formulas_over(outputs);
  }

 private:
  static std::vector<Expression> outputs_of(const std::vector<Plane>& planes) {
    std::vector<Expression> outputs;
    for (const Plane& plane : planes) {
      outputs.insert(outputs.end(), plane.normal.begin(), plane.normal.end());
      outputs.push_back(plane.offset);
    }
    return outputs;
  }

  bool has_offset(std::size_t constraint) const {
    return system_->constraints[constraint].kind->restriction(system_->universe) == 1;
  }

  Expression offset(std::size_t constraint) const { return identity_[program_->offset(constraint)]; }

  Locus locus(const LocusSource& source, std::size_t point) {
    if (source.guide)
      return sphere_around(point, program_->plan().guides[*source.guide].centre,
                           identity_[program_->guide(*source.guide)], variables_);
    Locus result = given_locus(source, point);
    if (has_offset(*source.constraint) && !result.is_absorbed)
      result.equation = result.equation - offset(*source.constraint);
    return result;
  }

  /// Without offset.
  Locus given_locus(const LocusSource& source, std::size_t point) {
    return loci_of(*system_, system_->constraints[*source.constraint], point, frame_,
                   variables_)[source.part];
  }

  Expression equation(std::size_t constraint) {
    const Constraint& removed = system_->constraints[constraint];
    if (!has_offset(constraint) || removed.kind->auxiliaries(system_->universe) > 0)
      throw NotApplicable("the construction plan does not use " + system_->describe(removed) +
                          ", which is more than one equation: take another kind of plan");
    std::optional<Expression> parameter;
    if (removed.parameter) parameter = variables_.parameters[*removed.parameter];
    const ConstraintPlace place = system_->place(removed, variables_.coordinates);
    return removed.kind->interpretations[removed.interpretation].equations(place, parameter).front();
  }

  /// With these coordinates of the point, and 0 for the others.
  Expression at(const Expression& expression, std::size_t point, const Vector& x) {
    std::vector<Expression> replacements = identity_;
    for (std::size_t i = 0; i < program_->dimension(); ++i)
      replacements[point * program_->dimension() + i] = i < x.size() ? x[i] : graph_->constant(0);
    return substitute(expression, *graph_, replacements);
  }

  Vector slopes(const Locus& locus, std::size_t point, const Vector& x) {
    Vector result;
    for (std::size_t i = 0; i < x.size(); ++i)
      result.push_back(
          at(differentiate(locus.equation, static_cast<int>(point * program_->dimension() + i)), point, x));
    return result;
  }

  Plane plane_at(const Locus& locus, std::size_t point, const Vector& x) {
    return {slopes(locus, point, x), at(locus.equation, point, x)};
  }

  Vector centre_of(const Locus& sphere, std::size_t point, std::size_t freedom) {
    return scaled(graph_->constant(Rational(-1, 2)),
                  slopes(sphere, point, Vector(freedom, graph_->constant(0))));
  }

  const ConstraintSystem* system_;
  const PlanProgram* program_;
  Frame frame_;
  FigureVariables variables_;
  ExpressionGraph* graph_;
  Vector identity_;
};

}  // namespace

PlanProgram::PlanProgram(const ConstraintSystem& system, Plan plan)
    : plan_(std::move(plan)),
      dimension_(gcslab::dimension(system.universe)),
      parameters_(system.parameters.size()),
      constraints_(system.constraints.size()) {
  FormulaMaker maker(system, *this);
  for (std::size_t k = 0; k < plan_.steps.size(); ++k)
    steps_.push_back(maker.step(plan_.steps[k], std::min(k, dimension_)));
  removed_ = maker.removed();
  offsets_ = maker.offsets();
}

}  // namespace gcslab
