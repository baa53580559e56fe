// One suite for every certifier, and for compositions, through the whole search: no root is lost, and what is
// said of a box is true of systems all of whose roots are known, with clusters, double roots, systems nearly
// without roots, and roots on borders and in corners of the search box. A new inclusion test is tested
// without an edit here.

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "base/error.h"
#include "box_solver/solver_method.h"
#include "certification/root_certifier.h"
#include "support/counted_system.h"
#include "support/fuzz.h"

namespace gcslab {
namespace {

using planted::CountedGenerator;
using planted::CountedSystem;
using planted::PlantedGenerator;
using planted::PlantedSystem;
using planted::Point;

std::vector<std::string> choices() {
  std::vector<std::string> names;
  for (const CertifierName& entry : certifier_names()) names.push_back(entry.name);
  names.insert(names.end(), {"miranda+elber_kim", "krawczyk_slopes+miranda"});
  return names;
}

class CertifierContract : public testing::TestWithParam<std::string> {
 protected:
  /// By one thread and by two in turn.
  static SearchResult solved(const EquationSystem& system, const Box& box, std::size_t turn,
                             std::uint64_t maximum_boxes) {
    const SystemFunctions functions(system);
    SearchOptions options;
    options.certifier = GetParam();
    options.maximum_boxes = maximum_boxes;
    options.threads = turn % 2 == 0 ? 1 : 2;
    const ContractorMaker maker = [](const SystemFunctions& f, int bits) {
      ContractorSettings settings;
      settings.bits = bits;
      if (bits > 53) settings.arithmetic = Arithmetic::mpfr;
      return make_contractor("hull+multipliers", f, settings);
    };
    return search(functions, box, {{box}}, maker, options);
  }

  static bool is_found(const SearchResult& result, const Point& root) {
    const auto has = [&](const Box& box) { return planted::contains(box, root); };
    return std::ranges::any_of(result.solutions, [&](const Solution& s) { return has(s.root.box); }) ||
           std::ranges::any_of(result.undecided, has, &UndecidedBox::box) ||
           std::ranges::any_of(result.pending, has);
  }

  static std::int64_t roots_in(const Box& box, const std::vector<Point>& roots) {
    return std::ranges::count_if(roots, [&](const Point& root) { return planted::contains(box, root); });
  }
};

TEST_P(CertifierContract, LosesNoRootAndSaysWhatIsTrue) {
  Random random(fuzz_seed(), "certifier_contract");
  CountedGenerator systems(random);
  PlantedGenerator boxes(random);
  std::size_t unique = 0, existing = 0;
  for (std::size_t i = 0; i < fuzz_cases(1000); ++i) {
    const CountedSystem counted = systems.system(static_cast<int>(random.integer(1, 2)));
    const Box box = boxes.box_around(counted.centres[random.below(counted.centres.size())]);
    const SearchResult result = solved(counted.system, box, i, 300);
    const auto where = [&] { return planted::to_text(counted.system) + "in " + planted::to_text(box); };
    for (const Point& root : counted.roots) {
      if (!planted::contains(box, root)) continue;
      ASSERT_TRUE(is_found(result, root)) << where();
    }
    for (const Solution& solution : result.solutions) {
      const std::int64_t roots = roots_in(solution.root.box, counted.roots);
      if (solution.claim == Claim::exists) {
        ++existing;
        ASSERT_GE(roots, 1) << where() << planted::to_text(solution.root.box);
        continue;
      }
      ++unique;
      ASSERT_EQ(solution.claim, Claim::unique);
      ASSERT_EQ(roots, 1) << where() << planted::to_text(solution.root.box);
      ASSERT_EQ(roots_in(solution.root.uniqueness_box, counted.roots), 1)
          << where() << planted::to_text(solution.root.uniqueness_box);
    }
  }
  // A certifier that never proves anything would pass all that.
  const bool is_unique = GetParam() != "miranda" && GetParam() != "elber_kim";
  if (is_unique) {
    EXPECT_GT(unique, fuzz_cases(1000) / 10);
  } else {
    EXPECT_EQ(unique, 0U);
  }
  if (GetParam() == "miranda") {
    EXPECT_GT(existing, fuzz_cases(1000) / 10);
  }
}

TEST_P(CertifierContract, LosesNoPlantedRootOfAnyKindOfSystem) {
  Random random(fuzz_seed(), "certifier_planted");
  PlantedGenerator generator(random);
  for (std::size_t i = 0; i < fuzz_cases(1000); ++i) {
    PlantedSystem planted = generator.system(generator.random_kind());
    const Box box = generator.box_around(planted.roots[random.below(planted.roots.size())]);
    try {
      const SearchResult result = solved(planted.system, box, i, 50);
      for (const Point& root : planted.roots) {
        if (!planted::contains(box, root)) continue;
        ASSERT_TRUE(is_found(result, root)) << planted::to_text(planted.system) << planted::to_text(box);
      }
    } catch (const NotApplicable& refusal) {  // abs has no second derivative
      EXPECT_EQ(GetParam(), "kantorovich") << refusal.what();
    }
  }
}

std::string name_of_choice(const testing::TestParamInfo<std::string>& choice) {
  std::string name = choice.param;
  std::ranges::replace(name, '+', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Every, CertifierContract, testing::ValuesIn(choices()), name_of_choice);

TEST(CertifierNames, AreCheckedWithTheNearestName) {
  EXPECT_NO_THROW(check_certifier("miranda+elber_kim"));
  for (const char* text : {"", "mirand", "miranda+", "miranda+miranda", "miranda elber_kim"})
    EXPECT_THROW(check_certifier(text), InputError) << text;
}

}  // namespace
}  // namespace gcslab
