#pragma once

// What the drawings of polytopes over (x, x^2) and of their use share.

#include <functional>
#include <string>
#include <vector>

#include "box_solver/monomial_polytope.h"
#include "experiments/tasks/illustration.h"

namespace gcslab {

/// The solver's polytope of a system over a box.
class Lifted {
 public:
  Lifted(const SystemFunctions& functions, const Box& box)
      : plan_(functions), expansion_(made(plan_)), bernstein_(plan_) {
    const NumberTraits<FastInterval>::Scope scope;
    expansion_.expand(box);
    bernstein_.refill(expansion_);
  }

  const BernsteinPolytope& bernstein() const { return bernstein_; }
  const Expansion<FastInterval>& expansion() const { return expansion_; }
  MonomialPolytope in_monomials(PolytopeParts parts) const {
    return monomial_polytope(bernstein_, expansion_, parts);
  }

 private:
  static Expansion<FastInterval> made(const ExpansionPlan& plan) {
    const NumberTraits<FastInterval>::Scope scope;
    return Expansion<FastInterval>(plan);
  }

  ExpansionPlan plan_;
  Expansion<FastInterval> expansion_;
  BernsteinPolytope bernstein_;
};

/// "x", "x²", "x y" for each monomial.
std::vector<std::string> names_of(const std::vector<Exponents>& monomials,
                                  const std::vector<std::string>& variables);

/// The corners of a polygon, in order.
ControlPolygon polygon_of(const ExactPolytope& polytope);

/// Points (x, value(x)) with x in equal steps.
ControlPolygon graph_points(const Rational& lower, const Rational& upper, int steps,
                            const std::function<Rational(const Rational&)>& value);
/// Points (x, x^2).
ControlPolygon parabola_points(const Interval& side);

/// A panel with unequal scales whose limits leave some room around the points.
Json plane_panel(const std::string& title, const ControlPolygon& around, const std::string& xlabel,
                 const std::string& ylabel, Json shapes);

/// The drawing lp_reduction_steps.
Drawn draw_reduction(const std::filesystem::path& path, const Options& options);

}  // namespace gcslab
