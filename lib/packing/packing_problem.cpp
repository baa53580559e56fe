#include "packing/packing_problem.h"

#include <algorithm>
#include <fmt/format.h>

#include "base/error.h"

namespace gcslab {
namespace {

constexpr int kOuterDisc = -1;

/// factor * (|c_first - c|^2 - (r_first + r)^2), where c, r are those of inner disc `second` or of a fixed
/// disc.
struct Relation {
  int first = 0;            ///< number of an inner disc, from 0
  int second = kOuterDisc;  ///< number of another one, larger, or kOuterDisc
  RationalDisc fixed{};     ///< the disc that kOuterDisc stands for
  Rational factor{};
};

/// Coefficients of a polynomial by variables; monomials are given as one variable or two.
class Coefficients {
 public:
  explicit Coefficients(const Polynomial& polynomial) : polynomial_(&polynomial) {}

  Rational linear(int variable) const { return at({variable}); }
  Rational product(int a, int b) const { return at({a, b}); }
  Rational constant() const { return at({}); }

 private:
  Rational at(std::initializer_list<int> variables) const {
    Exponents exponents(static_cast<std::size_t>(polynomial_->variables()), 0);
    for (const int variable : variables) ++exponents[static_cast<std::size_t>(variable)];
    return polynomial_->coefficient(exponents);
  }
  const Polynomial* polynomial_;
};

/// The polynomial that a relation stands for.
Polynomial polynomial_of(const Relation& relation, int variables) {
  const auto inner = [&](int disc, int part) { return Polynomial::variable(variables, 3 * disc + part); };
  const auto other = [&](int part) {
    if (relation.second != kOuterDisc) return inner(relation.second, part);
    const std::array<Rational, 3> fixed = {relation.fixed.x, relation.fixed.y, relation.fixed.radius};
    return Polynomial::constant(variables, fixed[static_cast<std::size_t>(part)]);
  };
  return (pow(inner(relation.first, 0) - other(0), 2) + pow(inner(relation.first, 1) - other(1), 2) -
          pow(inner(relation.first, 2) + other(2), 2)) *
         relation.factor;
}

/// The discs of the variables that occur; empty unless they occur in whole discs.
std::vector<int> discs_in(const std::vector<std::size_t>& variables) {
  std::vector<int> discs;
  if (variables.size() % 3 != 0) return {};
  for (std::size_t i = 0; i < variables.size(); i += 3) {
    const std::size_t first = variables[i];
    if (first % 3 != 0 || variables[i + 1] != first + 1 || variables[i + 2] != first + 2) return {};
    discs.push_back(static_cast<int>(first / 3));
  }
  return discs;
}

std::optional<Relation> relation_of(const SystemFunction& function, int variables) {
  if (!function.polynomial || function.degree != 2) return std::nullopt;
  const std::vector<int> discs = discs_in(function.variables);
  if (discs.empty() || discs.size() > 2) return std::nullopt;
  const Coefficients coefficients(*function.polynomial);
  Relation relation{.first = discs[0]};
  const int x = 3 * relation.first;
  relation.factor = coefficients.product(x, x);
  if (relation.factor == 0) return std::nullopt;
  if (discs.size() == 2) {
    relation.second = discs[1];
  } else {
    const Rational scale = -2 * relation.factor;
    relation.fixed = {coefficients.linear(x) / scale, coefficients.linear(x + 1) / scale,
                      coefficients.linear(x + 2) / scale};
  }
  if (polynomial_of(relation, variables) != *function.polynomial) return std::nullopt;
  return relation;
}

[[noreturn]] void refuse(const std::string& reason) {
  throw NotApplicable("the system is no circle packing with three fixed outer discs: " + reason);
}

/// Twice the signed area of the triangle of the centres.
Rational orientation(const OuterDiscs& outer) {
  return (outer[1].x - outer[0].x) * (outer[2].y - outer[0].y) -
         (outer[1].y - outer[0].y) * (outer[2].x - outer[0].x);
}

OuterDiscs outer_discs(const std::vector<Relation>& tangencies) {
  std::vector<RationalDisc> found;
  for (const Relation& relation : tangencies) {
    if (relation.second == kOuterDisc && std::ranges::find(found, relation.fixed) == found.end())
      found.push_back(relation.fixed);
  }
  if (found.size() != 3) refuse(fmt::format("its equations have {} fixed discs", found.size()));
  OuterDiscs outer = {found[0], found[1], found[2]};
  if (!are_mutually_tangent(outer)) refuse("the fixed discs do not touch each other");
  if (orientation(outer) < 0) std::swap(outer[1], outer[2]);
  return outer;
}

/// The vertices of a relation; nothing when its fixed disc is no outer one.
std::optional<Edge> edge_of(const Relation& relation, const OuterDiscs& outer) {
  if (relation.second != kOuterDisc) return Edge{relation.first + 3, relation.second + 3};
  const auto disc = std::ranges::find(outer, relation.fixed);
  if (disc == outer.end()) return std::nullopt;
  return Edge{static_cast<int>(disc - outer.begin()), relation.first + 3};
}

std::vector<Relation> tangencies(const SystemFunctions& functions) {
  const int n = static_cast<int>(functions.variables());
  std::vector<Relation> result;
  for (std::size_t k = 0; k < functions.equations().size(); ++k) {
    const auto relation = relation_of(functions.equations()[k], n);
    if (!relation) refuse(fmt::format("equation {} does not say that two discs (x, y, r) touch", k + 1));
    result.push_back(*relation);
  }
  return result;
}

/// Pairs that inequalities keep apart; others are no part of the packing and only exclude more.
std::vector<Edge> pairs_kept_apart(const SystemFunctions& functions, const OuterDiscs& outer) {
  std::vector<Edge> result;
  for (const SystemFunction& inequality : functions.inequalities()) {
    const auto relation = relation_of(inequality, static_cast<int>(functions.variables()));
    if (!relation || relation->factor > 0) continue;
    if (const auto edge = edge_of(*relation, outer)) result.push_back(*edge);
  }
  std::ranges::sort(result);
  return result;
}

std::string names(const Edge& edge) { return fmt::format("{} and {}", edge.first, edge.second); }

}  // namespace

PackingProblem recognise_packing(const SystemFunctions& functions) {
  if (functions.variables() % 3 != 0 || !functions.is_square())
    refuse("it has not as many equations as variables, three a disc");
  const std::vector<Relation> relations = tangencies(functions);
  const OuterDiscs outer = outer_discs(relations);
  std::vector<Edge> edges = {{0, 1}, {0, 2}, {1, 2}};
  for (const Relation& relation : relations) edges.push_back(*edge_of(relation, outer));
  std::ranges::sort(edges);
  if (const auto twice = std::ranges::adjacent_find(edges); twice != edges.end())
    refuse("it has two equations for discs " + names(*twice));
  auto graph = Triangulation::of_graph(static_cast<int>(functions.variables() / 3) + 3, edges);
  if (!graph) refuse("the graph of the tangencies does not triangulate the triangle of the fixed discs");
  return {std::move(*graph), outer, pairs_kept_apart(functions, outer)};
}

namespace {

bool is_below(double end, const Rational& value) {
  return std::isfinite(end) ? rational_from_double(end) < value : end < 0;
}

bool is_above(double end, const Rational& value) {
  return std::isfinite(end) ? rational_from_double(end) > value : end > 0;
}

/// Whether a coordinate of an outer centre (0: x, 1: y) lies in the interior of the range that outer centres
/// and the box allow: something lies below it and something above.
bool is_inner_coordinate(const Rational& value, Rational RationalDisc::*coordinate, std::size_t part,
                         const OuterDiscs& outer, const Box& box) {
  bool below = false, above = false;
  for (const RationalDisc& disc : outer) {
    below = below || disc.*coordinate < value;
    above = above || disc.*coordinate > value;
  }
  for (std::size_t i = part; i < box.size(); i += 3) {
    below = below || is_below(box[i].lower, value);
    above = above || is_above(box[i].upper, value);
  }
  return below && above;
}

}  // namespace

std::optional<std::string> uniqueness_gap(const PackingProblem& problem, const Box& box) {
  for (std::size_t i = 2; i < box.size(); i += 3) {
    if (!(box[i].lower > 0)) return "the box allows radii that are not positive";
  }
  for (const RationalDisc& disc : problem.outer) {
    if (is_inner_coordinate(disc.x, &RationalDisc::x, 0, problem.outer, box) &&
        is_inner_coordinate(disc.y, &RationalDisc::y, 1, problem.outer, box))
      return "the box allows discs outside of the gap between the fixed discs";
  }
  for (int v = 3; v < problem.graph.vertices(); ++v) {
    for (int u = 0; u < v; ++u) {
      if (problem.graph.has_edge(u, v) || std::ranges::binary_search(problem.kept_apart, Edge{u, v}))
        continue;
      return "no inequality keeps discs " + names({u, v}) + " apart";
    }
  }
  return std::nullopt;
}

}  // namespace gcslab
