// Bernstein coefficients keep the fewest cells of all bounds on every algebraic plane curve of the corpus;
// only the bound `exact`, which goes on splitting until the sign is decided, may keep fewer.

#include <gtest/gtest.h>

#include "covering/cover.h"
#include "enclosure/bound_registry.h"
#include "experiments/corpus/corpus.h"
#include "experiments/corpus/problem.h"

namespace gcslab {
namespace {

std::uint64_t kept_cells(const Problem& problem, const std::string& name,
                         const std::map<std::string, std::string>& options = {}) {
  const BoundVariant& variant = bound_registry().at(name);
  SetBounds bounds;
  bounds.equations.push_back(
      variant.make(problem.targets().front(), Options(variant.options, options, name)));
  constexpr int kDepth = 6;
  return cover(bounds, problem.system.box, {kDepth, Split::all}).tree.kept_cells();
}

TEST(FewestCells, BernsteinKeepsTheFewestOnEveryAlgebraicCurve) {
  for (const CorpusEntry& entry : Corpus::standard().problems()) {
    if (kind_of_file(entry.path) != "curve") continue;
    const Problem problem = load_problem(entry.path);
    if (!problem.targets().front().is_polynomial()) continue;
    const std::uint64_t of_bernstein = kept_cells(problem, "bernstein");
    EXPECT_LE(kept_cells(problem, "exact"), of_bernstein) << entry.name;
    for (const BoundVariant& variant : bound_registry().entries()) {
      if (variant.name == "exact") continue;
      EXPECT_LE(of_bernstein, kept_cells(problem, variant.name)) << entry.name << " " << variant.name;
    }
    EXPECT_LE(of_bernstein, kept_cells(problem, "natural", {{"form", "tightest"}})) << entry.name;
    EXPECT_LE(of_bernstein, kept_cells(problem, "centred", {{"centre", "bicentred"}})) << entry.name;
  }
}

}  // namespace
}  // namespace gcslab
