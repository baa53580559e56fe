// What is over- and under-constrained: matchings against Hall's theorem, and figures whose rigidity is known.

#include "geometry/degrees_of_freedom.h"

#include <algorithm>
#include <bit>
#include <gtest/gtest.h>

#include "base/random.h"
#include "geometry/bipartite_matching.h"
#include "geometry/constraint_system_reader.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

/// The size of a maximum matching of some of the rows: the least of |neighbours| + |other rows| over all sets
/// of rows (Koenig, Hall).
std::size_t rank_of(const std::vector<unsigned>& rows) {
  std::size_t rank = rows.size();
  for (unsigned set = 0; set < (1U << rows.size()); ++set) {
    unsigned neighbours = 0;
    for (std::size_t row = 0; row < rows.size(); ++row) neighbours |= (set >> row & 1U) != 0 ? rows[row] : 0;
    const auto others = rows.size() - static_cast<std::size_t>(std::popcount(set));
    rank = std::min(rank, static_cast<std::size_t>(std::popcount(neighbours)) + others);
  }
  return rank;
}

/// A row is over-determined when its removal leaves the rank as it is; a column likewise.
TEST(StructuralParts, AreRowsAndColumnsThatSomeMaximumMatchingLeavesOut) {
  constexpr std::size_t kColumns = 6;
  Random random(fuzz_seed(), "matchings");
  for (std::size_t n = 0; n < fuzz_cases(300); ++n) {
    std::vector<unsigned> sets(1 + random.below(7));
    Incidence rows;
    for (unsigned& set : sets) {
      set = static_cast<unsigned>(random.below(1U << kColumns) & random.below(1U << kColumns));
      rows.emplace_back();
      for (std::size_t column = 0; column < kColumns; ++column) {
        if ((set >> column & 1U) != 0) rows.back().push_back(column);
      }
    }
    const StructuralParts parts = structural_parts(rows, kColumns);
    const std::size_t rank = rank_of(sets);
    ASSERT_EQ(parts.matched, rank);
    std::vector<std::size_t> over, under;
    for (std::size_t row = 0; row < sets.size(); ++row) {
      std::vector<unsigned> others = sets;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(row));
      if (rank_of(others) == rank) over.push_back(row);
    }
    for (std::size_t column = 0; column < kColumns; ++column) {
      std::vector<unsigned> without = sets;
      for (unsigned& set : without) set &= ~(1U << column);
      if (rank_of(without) == rank) under.push_back(column);
    }
    ASSERT_EQ(parts.over_rows, over);
    ASSERT_EQ(parts.under_columns, under);
  }
}

/// A figure of points with distances between some, each with a parameter of its own.
std::string bars(const std::string& universe, const std::string& points,
                 const std::vector<std::string>& pairs, const std::string& more = {}) {
  std::string text = "universe: " + universe + "\npoints: [" + points + "]\nconstraints:\n", values;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const std::string parameter = "h" + std::to_string(k);
    text += "  - {distance: [" + pairs[k] + "], parameter: " + parameter + "}\n";
    values += (k == 0 ? "" : ", ") + parameter + ": 1";
  }
  return text + more + "valuations: {v: {" + values + "}}\n";
}

struct Diagnosed {
  ConstraintSystem system;
  GeometricEquations equations;
  StructuralDiagnosis structure;
  std::optional<WitnessDiagnosis> witness;
};

Diagnosed diagnosed(const std::string& text) {
  Diagnosed result{read_constraint_system(YamlNode::parse(text, "figure.yaml")), {}, {}, {}};
  const Frame frame = frame_of(result.system);
  result.equations = geometric_equations(result.system, frame);
  result.structure = structural_diagnosis(result.equations);
  result.witness = witness_diagnosis(result.system, frame, result.equations);
  return result;
}

using Numbers = std::vector<std::size_t>;

TEST(Diagnosis, OfATriangleFindsNothing) {
  const Diagnosed triangle = diagnosed(bars("2d", "A, B, C", {"A, B", "B, C", "C, A"}));
  EXPECT_EQ(triangle.structure.rank, 3U);
  EXPECT_EQ(structure_text(triangle.system, triangle.structure), "no part is over- or under-constrained");
  ASSERT_TRUE(triangle.witness);
  EXPECT_EQ(triangle.witness->rank, 3U);
  EXPECT_TRUE(triangle.witness->redundant.empty());
  EXPECT_TRUE(triangle.witness->movable.empty());
}

/// A quadrilateral with both diagonals has one bar too many; a triangle beside it has none.
TEST(Diagnosis, NamesTheOverConstrainedPart) {
  const Diagnosed frame = diagnosed(
      bars("2d", "A, B, C, D, E", {"A, B", "B, C", "C, D", "D, A", "A, C", "B, D", "A, E", "B, E"}));
  EXPECT_EQ(frame.structure.over, (Numbers{0, 1, 2, 3, 4, 5}));
  EXPECT_TRUE(frame.structure.under.empty());
  ASSERT_TRUE(frame.witness);
  EXPECT_EQ(frame.witness->rank, 7U);
  EXPECT_EQ(frame.witness->redundant, (Numbers{0, 1, 2, 3, 4, 5}));
  EXPECT_TRUE(frame.witness->movable.empty());
}

TEST(Diagnosis, NamesThePointsThatAMissingDistanceLeavesFree) {
  const Diagnosed open = diagnosed(bars("2d", "A, B, C, D", {"A, B", "B, C", "C, A", "C, D"}));
  EXPECT_EQ(open.structure.under, (Numbers{3}));
  EXPECT_EQ(structure_text(open.system, open.structure), "under-constrained: D");
  ASSERT_TRUE(open.witness);
  EXPECT_EQ(open.witness->movable, (Numbers{3}));
  EXPECT_EQ(witness_text(open.system, open.equations, *open.witness),
            "rank 4 of 4 equations in 5 unknowns at a witness; movable: D");
}

/// Two bipyramids that share their apices A and B: 18 bars as counting asks for, but each bipyramid fixes the
/// distance of A and B, and one turns about the line AB against the other.
TEST(Diagnosis, OfTheDoubleBananaNeedsAWitness) {
  std::vector<std::string> pairs;
  for (const std::string ring : {"CDE", "FGH"}) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string point(1, ring[k]), next(1, ring[(k + 1) % 3]);
      pairs.push_back("A, " + point);
      pairs.push_back("B, " + point);
      pairs.push_back(point + ", " + next);
    }
  }
  const Diagnosed banana = diagnosed(bars("3d", "A, B, C, D, E, F, G, H", pairs) + "frame: [A, C, D]\n");
  EXPECT_EQ(banana.structure.rank, 18U);
  EXPECT_TRUE(banana.structure.over.empty());
  EXPECT_TRUE(banana.structure.under.empty());
  ASSERT_TRUE(banana.witness);
  EXPECT_EQ(banana.witness->rank, 17U);
  EXPECT_EQ(banana.witness->redundant.size(), 18U);  // the stress that both share has no bar without force
  EXPECT_EQ(banana.witness->movable, (Numbers{5, 6, 7}));
}

/// Pappus: of the nine collinearities each follows from the others. Structure cannot know.
TEST(Diagnosis, FindsARedundantCollinearityByPappus) {
  std::string more;
  for (const char* three :
       {"A, B, C", "D, E, F", "A, E, G", "B, D, G", "A, F, H", "C, D, H", "B, F, I", "C, E, I", "G, H, I"})
    more += std::string("  - {collinear: [") + three + "]}\n";
  const std::string sketch =
      "sketch: {A: [0, 0.1], B: [1.2, 0], C: [3, 0.2], D: [0.2, 2], E: [1.4, 2.5], F: [3.5, 3.1], "
      "G: [0.63, 1.02], H: [1.3, 1.24], I: [2.1, 1.5]}\n";
  const Diagnosed pappus = diagnosed(bars("2d", "A, B, C, D, E, F, G, H, I", {"A, B"}, more) + sketch);
  ASSERT_TRUE(pappus.witness);
  EXPECT_EQ(pappus.structure.rank, pappus.equations.equations.size());
  EXPECT_EQ(pappus.witness->rank, pappus.equations.equations.size() - 1);
  EXPECT_EQ(pappus.witness->redundant.size() + (pappus.equations.equations.size() == 10 ? 0U : 1U), 9U);
}

/// The edges of a hexahedron with plane faces are well-constrained; the diagonal of a face is one too many,
/// and so it is, as a distance, in the face alone.
TEST(Diagnosis, OfAHexahedronWithADiagonal) {
  std::string faces;
  for (const char* face :
       {"A, B, C, D", "E, F, G, H", "A, B, F, E", "B, C, G, F", "C, D, H, G", "D, A, E, H"})
    faces += std::string("  - {coplanar: [") + face + "]}\n";
  const std::string sketch =
      "sketch: {A: [0, 0, 0], B: [1, 0, 0], C: [1, 1, 0], D: [0, 1, 0], E: [0, 0, 1], F: [1, 0, 1], G: [1, "
      "1, "
      "1], H: [0, 1, 1]}\nframe: [A, B, D]\n";
  std::vector<std::string> edges = {"A, B", "B, C", "C, D", "D, A", "E, F", "F, G",
                                    "G, H", "H, E", "A, E", "B, F", "C, G", "D, H"};
  const Diagnosed well = diagnosed(bars("3d", "A, B, C, D, E, F, G, H", edges, faces) + sketch);
  EXPECT_EQ(well.structure.rank, well.equations.unknowns.size());
  ASSERT_TRUE(well.witness);
  EXPECT_EQ(well.witness->rank, well.equations.unknowns.size());
  edges.emplace_back("A, C");
  const Diagnosed over = diagnosed(bars("3d", "A, B, C, D, E, F, G, H", edges, faces) + sketch);
  EXPECT_FALSE(over.structure.over.empty());
  ASSERT_TRUE(over.witness);
  EXPECT_EQ(over.witness->rank, over.equations.equations.size() - 1);
  EXPECT_TRUE(std::ranges::binary_search(over.witness->redundant, 12U));
}

/// Lines at the same point: the angles of three lines of the plane add up, so the third one is redundant.
TEST(Diagnosis, FindsThatAnglesOfLinesAddUp) {
  const Diagnosed lines = diagnosed(
      "universe: 2d\npoints: [A, B]\nlines: [l, m, n]\nconstraints:\n"
      "  - {distance: [A, B], parameter: h}\n  - {incidence: [A, l]}\n  - {incidence: [B, l]}\n"
      "  - {incidence: [A, m]}\n  - {incidence: [B, n]}\n  - {angle: [l, m], parameter: a}\n"
      "  - {angle: [m, n], parameter: b}\n  - {angle: [l, n], parameter: c}\n"
      "valuations: {v: {h: 1, a: 60 deg, b: 60 deg, c: 60 deg}}\n");
  EXPECT_FALSE(lines.structure.over.empty());
  ASSERT_TRUE(lines.witness);
  EXPECT_EQ(lines.witness->rank, lines.equations.equations.size() - 1);
  for (const std::size_t angle : {5U, 6U, 7U})
    EXPECT_TRUE(std::ranges::binary_search(lines.witness->redundant, angle));
  EXPECT_FALSE(std::ranges::binary_search(lines.witness->redundant, 0U));
}

/// Constraints that share a parameter agree at the witness: an isosceles triangle with equal angles.
TEST(Diagnosis, MakesSharedParametersAgree) {
  const Diagnosed isosceles = diagnosed(
      "universe: 2d\npoints: [A, B, C]\nconstraints:\n"
      "  - {distance: [A, B], parameter: a}\n  - {distance: [A, C], parameter: b}\n"
      "  - {distance: [B, C], parameter: b}\n  - {equal_lengths: [C, A, C, B]}\n"
      "valuations: {v: {a: 1, b: 1}}\n");
  ASSERT_TRUE(isosceles.witness);
  EXPECT_EQ(isosceles.witness->rank, 3U);
  EXPECT_EQ(isosceles.witness->redundant, (Numbers{1, 2, 3}));
}

}  // namespace
}  // namespace gcslab
