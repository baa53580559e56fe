#pragma once

// The polytope of (x - a)(x - b) = 0 on [u, v], the smallest one that loses roots to roundoff (Tahari 2011,
// section 5, on x^2 - x = 0), in exact data and in the data that a program which only rounds to nearest would
// write.

#include <limits>
#include <vector>

#include "base/random.h"
#include "interval/fast_interval.h"
#include "linear_program/lp_model.h"

namespace gcslab {

/// Roots a and b, box [u, v]; a is in the box, often at its end.
struct Parabola {
  double a, b, u, v;
};

/// A box of about the given width that has the root a at its lower end, at its upper end, or anywhere inside.
inline Parabola random_parabola(Random& random, double width) {
  Parabola parabola{random.unit(), random.unit(), 0, 0};
  const double share = random.below(2) == 0 ? 0.0 : random.below(2) == 0 ? 1.0 : random.unit();
  parabola.u = share == 0 ? parabola.a : parabola.a - share * width;
  parabola.v = share == 1 ? parabola.a : parabola.u + width;
  return parabola;
}

enum class Data { enclosed, nearest };

/// Columns x in [u, v] and X = x^2: (v - x)^2 >= 0, (x - u)^2 >= 0, (x - u)(v - x) >= 0, X - (a + b) x + a b
/// = 0. Needs 0 <= u.
inline LpModel parabola_polytope(const Parabola& parabola, Data data) {
  const NumberTraits<FastInterval>::Scope scope;
  const auto written = [&](FastInterval value) {
    const Interval enclosure = value.interval();
    return data == Data::enclosed ? enclosure : Interval(midpoint(enclosure));
  };
  const FastInterval u(parabola.u), v(parabola.v), a(parabola.a), b(parabola.b), two(2.0);
  const double infinity = std::numeric_limits<double>::infinity();
  LpModel model;
  model.add_column({parabola.u, parabola.v});
  model.add_column(hull((u * u).interval(), (v * v).interval()));
  const auto add = [&](FastInterval of_x, double of_square, FastInterval side, bool is_equation) {
    const std::vector<LinearTerm> terms{{0, written(of_x)}, {1, of_square}};
    const Interval sides = written(side);
    model.add_row(terms, {sides.lower, is_equation ? sides.upper : infinity});
  };
  add(-(two * v), 1, -(v * v), false);
  add(-(two * u), 1, -(u * u), false);
  add(u + v, -1, u * v, false);
  add(-(a + b), 1, -(a * b), true);
  return model;
}

}  // namespace gcslab
