#pragma once

// Families of systems in any number of unknowns, for studies of growth. A file of kind `system_family` names
// its generator; a task makes the member for the number of unknowns and the seed that it wants.

#include <filesystem>
#include <string>
#include <vector>

#include "expression/equation_system.h"
#include "interval/rational.h"

namespace gcslab {

/// A member of a family, with the root that was planted in it: a rational point of its box.
struct FamilyMember {
  EquationSystem system;
  std::vector<Rational> root;
};

/// The generator `sparse_quadratic`: n >= 2 equations of degree 2, each with at most seven terms, indices
/// modulo n:
///     x_i + a x_i^2 + b x_i x_(i+1) + c x_i x_(i+2) + d x_(i+1)^2 = the same at the root,
/// a, b, c, d uniform over the multiples of 2^-10 in [-1/2, 1/2], the root over those in [-1/4, 1/4]^n, on
/// the box
/// [-1/2, 1/2]^n. Every variable occurs with degree 2, so that a tensor in the Bernstein basis has 3^n
/// coefficients, while the system has at most 4n monomials.
FamilyMember sparse_quadratic_system(int unknowns, std::uint64_t seed);

inline constexpr const char* kSystemFamilyKind = "system_family";

/// Makes a member of the family that the file describes. Throws InputError with file and line.
FamilyMember load_family_member(const std::filesystem::path& path, int unknowns, std::uint64_t seed);

/// Throws InputError when the file is no family.
void check_system_family(const std::filesystem::path& path);

}  // namespace gcslab
