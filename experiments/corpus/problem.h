#pragma once

// Problems of the corpus that are given by functions over a box: curves, surfaces, space curves, functions,
// systems, and constraint systems, whose equations follow from what is true of a figure.
//
// A problem file is YAML with the keys of the contract; unknown and duplicate keys are refused with file and
// line. The equations are written out or come from a named generator (generated_system.h).

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "enclosure/bound_target.h"
#include "expression/equation_system.h"
#include "geometry/geometric_equations.h"

namespace gcslab {

/// What is known of the set of solutions, by means other than this program's solvers.
struct KnownFacts {
  std::vector<std::vector<Rational>> points;    ///< rational points of the set, exact
  std::vector<std::vector<Rational>> singular;  ///< rational points where the gradients are dependent
  std::optional<std::int64_t> real_solutions;  ///< how many, in the box; of a constraint system, in its frame
  std::optional<std::int64_t> classes{};       ///< of a constraint system: modulo all isometries
  std::map<std::string, std::string> published{};  ///< what the source prints, by the name of the value
  std::string how;
};

/// What the equations of a constraint system came from.
struct GeometricSource {
  ConstraintSystem system;
  Frame frame;
  GeometricEquations equations;
  std::string valuation;
};

struct Problem {
  std::string name;
  std::string kind;
  std::string title;
  EquationSystem system;
  KnownFacts known;
  std::string origin;
  std::string licence;
  std::string notes;
  std::shared_ptr<const GeometricSource> geometry{};  ///< of a constraint system

  /// Functions of this problem, ready to be bounded; by default those that are to vanish.
  std::vector<BoundTarget> targets(const std::vector<Expression>& functions) const;
  std::vector<BoundTarget> targets() const { return targets(system.equations); }
};

/// Kinds that this reader knows: curve (2 variables, 1 equation), surface (3, 1), space_curve (3, 2),
/// function (any, 1), system (any, any), constraint_system (what its constraints give), and
/// polynomial_family, which has no equation: a task makes a member for the degree and dimension that it
/// wants.
const std::vector<std::string>& function_kinds();

/// The value of the key `kind`, for files of every kind.
std::string kind_of_file(const std::filesystem::path& path);

/// A hash of what answers can depend on: variables, equations, inequalities and box, but not names, origin or
/// notes. For kinds without equations, and for constraint systems, it is a hash of the whole file.
std::string problem_content_hash(const std::filesystem::path& path);

/// Throws InputError when a known point does not lie on the set, exactly, or in the box.
void check_known_points(const Problem& problem);

/// Reads a problem of one of the function kinds, or a system in a format of expression/system_formats.h.
/// A constraint system gets the values of that valuation; of the empty name, of its first one; other problems
/// have none. Throws InputError with file and line.
Problem load_problem(const std::filesystem::path& path, const std::string& valuation = {});

}  // namespace gcslab
