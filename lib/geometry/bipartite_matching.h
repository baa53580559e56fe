#pragma once

// Maximum matchings of equations with unknowns, and what they say of the structure (Dulmage, Mendelsohn
// 1958).

#include <cstddef>
#include <vector>

namespace gcslab {

/// For each row the columns that it has, ascending.
using Incidence = std::vector<std::vector<std::size_t>>;

/// What is the same for every maximum matching. By the theorem of Koenig and Hall, rows that alternating
/// paths reach from an unmatched row have fewer columns than they are: they are over-determined. Columns that
/// such paths reach from an unmatched column are under-determined.
struct StructuralParts {
  std::size_t matched = 0;             ///< the structural rank
  std::vector<std::size_t> over_rows;  ///< ascending; none when every row is matched
  std::vector<std::size_t> under_columns;
};

StructuralParts structural_parts(const Incidence& rows, std::size_t columns);

}  // namespace gcslab
