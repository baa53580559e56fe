#pragma once

// Random linear programs of the kind that the solver meets: Bernstein polytopes of quadratic systems with a
// planted root.
//
// The system has n unknowns and n equations. Equation k joins three unknowns a, b, c, among them x_k, as the
// distance equations of a polyhedron do: random coefficients in [-1, 1] of a^2, b^2, c^2, ab, ac, bc, a, b,
// c, and the constant that makes a random point p of [-1, 1]^n a root. The box is p + [-radius, radius]^n
// moved by a random part of the radius, and its unknowns are scaled to z in [-1, 1]. Columns: z_j, every
// square Z_jj, and Z_ij for every pair that occurs. Rows: (1 - z_j)^2, (1 + z_j)^2 >= 0, with Z_jj in [0, 1]
// as column bounds; for each pair the four products (1 +- z_i)(1 +- z_j) >= 0 and the complements (z_i +-
// z_j)^2 >= 0; and the equations over the box, their coefficients rounded outward to intervals and divided by
// the largest.

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "base/random.h"
#include "interval/fast_interval.h"
#include "linear_program/lp_model.h"

namespace gcslab {

class RandomBernsteinPolytope {
 public:
  RandomBernsteinPolytope(int unknowns, double radius, std::uint64_t seed)
      : unknowns_(unknowns), random_(seed, "bernstein polytope"), radius_(radius) {
    for (int j = 0; j < unknowns; ++j) root_.push_back(random_.uniform(-1, 1));
    for (int j = 0; j < unknowns; ++j) {
      centre_.push_back(root_[at(j)] + radius * random_.uniform(-0.9, 0.9));
      equations_.push_back(random_equation(j));
    }
    build();
  }

  const LpModel& model() const { return model_; }
  int unknowns() const { return unknowns_; }

  /// The same system over another box around the root: same structure, other numbers.
  void move_box(double radius) {
    radius_ = radius;
    for (int j = 0; j < unknowns_; ++j) {
      centre_[at(j)] = root_[at(j)] + radius * random_.uniform(-0.9, 0.9);
    }
    write_equations();
  }
  /// The same system over a box of the same size that need not contain a root.
  void leave_root(double distance) {
    for (int j = 0; j < unknowns_; ++j) centre_[at(j)] += distance * random_.uniform(-1, 1);
    write_equations();
  }
  /// The planted root in every column of the model, up to rounding.
  std::vector<double> planted_point() const {
    std::vector<double> z;
    for (int j = 0; j < unknowns_; ++j) z.push_back((root_[at(j)] - centre_[at(j)]) / radius_);
    std::vector<double> point(at(model_.columns()));
    for (int j = 0; j < unknowns_; ++j) point[at(j)] = z[at(j)];
    for (const auto& [pair, column] : product_) {
      point[at(column)] = z[at(pair.first)] * z[at(pair.second)];
    }
    return point;
  }

 private:
  struct Equation {
    std::array<int, 3> unknown;
    std::array<double, 6> quadratic;  // aa bb cc ab ac bc
    std::array<double, 3> linear;
  };
  static constexpr std::array<std::pair<int, int>, 6> kPairs = {
      {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }

  Equation random_equation(int first) {
    Equation equation{};
    equation.unknown = {first, (first + 1 + static_cast<int>(random_.below(2))) % unknowns_,
                        (first + 3 + static_cast<int>(random_.below(3))) % unknowns_};
    while (equation.unknown[2] == first || equation.unknown[2] == equation.unknown[1]) {
      equation.unknown[2] = (equation.unknown[2] + 1) % unknowns_;
    }
    for (double& coefficient : equation.quadratic) coefficient = random_.uniform(-1, 1);
    for (double& coefficient : equation.linear) coefficient = random_.uniform(-1, 1);
    return equation;
  }

  int product(int i, int j) {
    const auto pair = std::minmax(i, j);
    const auto found = product_.find(pair);
    if (found != product_.end()) return found->second;
    const int column = model_.add_column(i == j ? Interval(0, 1) : Interval(-1, 1));
    product_[pair] = column;
    return column;
  }

  void build() {
    for (int j = 0; j < unknowns_; ++j) model_.add_column({-1, 1});
    for (int j = 0; j < unknowns_; ++j) product(j, j);
    for (const Equation& equation : equations_) {
      for (const auto& [s, t] : kPairs) product(equation.unknown[at(s)], equation.unknown[at(t)]);
    }
    for (const auto& [pair, column] : product_) {
      if (pair.first == pair.second) {
        add_square(pair.first, column);
      } else {
        add_pair(pair.first, pair.second, column);
      }
    }
    first_equation_ = model_.rows();
    for (const Equation& equation : equations_) add_equation(equation);
    write_equations();
  }

  void add_at_least(const std::vector<LinearTerm>& terms, double lower) {
    model_.add_row(terms, {lower, std::numeric_limits<double>::infinity()});
  }

  void add_square(int j, int column) {
    for (const double sign : {-2.0, 2.0}) add_at_least({{j, sign}, {column, 1.0}}, -1);
  }

  void add_pair(int i, int j, int column) {
    for (const double s : {-1.0, 1.0}) {
      for (const double t : {-1.0, 1.0}) add_at_least({{i, s}, {j, t}, {column, s * t}}, -1);
      add_at_least({{product(i, i), 1.0}, {product(j, j), 1.0}, {column, 2 * s}}, 0);
    }
  }

  void write_equations() {
    for (std::size_t k = 0; k < equations_.size(); ++k) {
      write_equation(k, first_equation_ + static_cast<int>(k));
    }
  }

  void add_equation(const Equation& equation) {
    std::vector<LinearTerm> terms;
    for (const auto& [s, t] : kPairs) {
      terms.push_back({product(equation.unknown[at(s)], equation.unknown[at(t)]), 0.0});
    }
    for (const int unknown : equation.unknown) terms.push_back({unknown, 0.0});
    model_.add_row(terms, {0, 0});
  }

  /// q_st x_s x_t = q_st (m_s + r z_s)(m_t + r z_t), term by term; the constant goes to the sides.
  void write_equation(std::size_t index, int row) {
    const NumberTraits<FastInterval>::Scope scope;
    const Equation& equation = equations_[index];
    const FastInterval r(radius_);
    std::array<FastInterval, 9> terms;
    terms.fill(FastInterval(0.0));
    FastInterval constant(0.0);
    std::array<FastInterval, 3> m, p;
    for (int s = 0; s < 3; ++s) {
      m[at(s)] = FastInterval(centre_[at(equation.unknown[at(s)])]);
      p[at(s)] = FastInterval(root_[at(equation.unknown[at(s)])]);
      const FastInterval slope(equation.linear[at(s)]);
      terms[6 + at(s)] = terms[6 + at(s)] + slope * r;
      constant = constant + slope * (m[at(s)] - p[at(s)]);
    }
    for (std::size_t k = 0; k < 6; ++k) {
      const auto s = at(kPairs[k].first), t = at(kPairs[k].second);
      const FastInterval q(equation.quadratic[k]);
      terms[k] = q * r * r;
      terms[6 + s] = terms[6 + s] + q * r * m[t];
      terms[6 + t] = terms[6 + t] + q * r * m[s];
      constant = constant + q * (m[s] * m[t] - p[s] * p[t]);
    }
    double largest = 0;
    for (const FastInterval& term : terms) largest = std::max(largest, magnitude(term.interval()));
    const FastInterval scale(largest);
    std::vector<Interval> coefficients;
    for (const FastInterval& term : terms) coefficients.push_back((term / scale).interval());
    model_.set_coefficients(row, coefficients);
    model_.set_sides(row, (-(constant / scale)).interval());
  }

  int unknowns_;
  Random random_;
  double radius_;
  std::vector<double> root_;
  std::vector<double> centre_;
  std::vector<Equation> equations_;
  std::map<std::pair<int, int>, int> product_;
  LpModel model_;
  int first_equation_ = 0;
};

}  // namespace gcslab
