#include "construction/locus.h"

#include <algorithm>
#include <optional>

#include "polynomial/recognise.h"

namespace gcslab {
namespace {

/// The variables of a point's coordinates.
std::vector<int> numbers_of(const Vector& coordinates) {
  std::vector<int> result;
  for (const Expression& x : coordinates) result.push_back(x.variable());
  return result;
}

/// F, divided by the factor of |X|^2 where it is a sphere; nothing where it is neither that nor a plane.
std::optional<Locus> locus_of(const Expression& equation, const std::vector<int>& x, int variables) {
  const Recognition recognition = recognise_polynomial(equation, variables, {.terms = 1000, .degree = 6});
  if (!recognition.polynomial) return std::nullopt;
  std::vector<Rational> squares(x.size(), 0);
  bool is_linear = false;
  for (const auto& [exponents, coefficient] : recognition.polynomial->terms()) {
    int degree = 0, others = 0;
    for (const int e : exponents) others += e;
    std::optional<std::size_t> squared;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const int e = exponents[static_cast<std::size_t>(x[i])];
      degree += e;
      if (e == 2) squared = i;
    }
    if (degree == 1) is_linear = true;
    if (degree < 2) continue;
    // The factor of |X|^2 is a number.
    if (degree > 2 || !squared || others > 2) return std::nullopt;
    squares[*squared] = coefficient;
  }
  const Rational& factor = squares[0];
  if (std::ranges::any_of(squares, [&](const Rational& s) { return s != factor; })) return std::nullopt;
  if (factor == 0) return is_linear ? std::optional(Locus{equation, false}) : std::nullopt;
  return Locus{equation / equation.graph().constant(factor), true};
}

Vector cross_or_determinant(const Vector& u, const Vector& v) {
  return u.size() == 2 ? Vector{determinant(u, v)} : cross(u, v);
}

/// u x v = 0, where constraints say that v is a multiple of u, by an auxiliary unknown that a plan has not;
/// none for other constraints.
std::vector<Expression> multiple_of(const ConstraintPlace& place, const Constraint& constraint) {
  if (!constraint.kind->is_about_points()) return {};
  if (constraint.kind->name == "collinear")
    return cross_or_determinant(place.vector(0, 1), place.vector(0, 2));
  if (constraint.kind->name == "parallel")
    return cross_or_determinant(place.vector(0, 1), place.vector(2, 3));
  return {};
}

/// How many coordinates, the last ones, are 0 because the other points are those of the frame.
std::size_t absorbed_coordinates(const Constraint& constraint, std::size_t point, const Frame& frame) {
  const bool is_plane = constraint.kind->name == "coplanar" && constraint.kind->is_about_points();
  const bool is_line = constraint.kind->name == "collinear" && constraint.kind->is_about_points();
  const std::size_t first = is_plane ? 3 : 2;
  if (!(is_plane || is_line) || frame.size() < first) return 0;
  for (const std::size_t object : constraint.objects) {
    if (object == point) continue;
    const auto place = std::ranges::find(frame, object);
    if (place - frame.begin() >= static_cast<std::ptrdiff_t>(first)) return 0;
  }
  return is_plane ? 1 : frame.size() - 1;
}

}  // namespace

FigureVariables::FigureVariables(const ConstraintSystem& system)
    : coordinates(coordinate_variables(system, *graph)), count(0) {
  for (const Vector& object : coordinates) count += static_cast<int>(object.size());
  for (std::size_t p = 0; p < system.parameters.size(); ++p) parameters.push_back(graph->variable(count++));
  is_absorbed = framed_coordinates(system, frame_of(system)).is_absorbed;
}

std::vector<Locus> loci_of(const ConstraintSystem& system, const Constraint& constraint, std::size_t point,
                           const Frame& frame, const FigureVariables& variables) {
  const auto number = static_cast<std::size_t>(&constraint - system.constraints.data());
  const std::size_t zeros =
      variables.is_absorbed[number] ? absorbed_coordinates(constraint, point, frame) : 0;
  if (zeros > 0) {
    const Vector& coordinates = variables.coordinates[point];
    std::vector<Locus> result;
    for (std::size_t i = coordinates.size() - zeros; i < coordinates.size(); ++i)
      result.push_back({coordinates[i], false, true});
    return result;
  }
  const std::vector<int> x = numbers_of(variables.coordinates[point]);
  const ConstraintPlace place = system.place(constraint, variables.coordinates);
  std::optional<Expression> parameter;
  if (constraint.parameter) parameter = variables.parameters[*constraint.parameter];
  const auto loci = [&](const std::vector<Expression>& equations) {
    std::vector<Locus> result;
    for (const Expression& equation : equations) {
      const std::optional<Locus> locus = locus_of(equation, x, variables.count);
      if (!locus) return std::vector<Locus>();
      result.push_back(*locus);
    }
    return result;
  };
  if (constraint.kind->auxiliaries(system.universe) > 0 || constraint.kind->name == "collinear")
    return loci(multiple_of(place, constraint));
  for (const Interpretation& interpretation : constraint.kind->interpretations) {
    std::vector<Locus> result = loci(interpretation.equations(place, parameter));
    if (!result.empty()) return result;
  }
  return {};
}

Locus sphere_around(std::size_t point, std::size_t centre, Expression distance,
                    const FigureVariables& variables) {
  const Vector apart = difference(variables.coordinates[point], variables.coordinates[centre]);
  return {squared_norm(apart) - sqr(distance), true};
}

}  // namespace gcslab
