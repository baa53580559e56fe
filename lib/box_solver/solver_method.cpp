#include "box_solver/solver_method.h"

#include "certification/root_certifier.h"
#include "linear_program/lp_registry.h"

namespace gcslab {
namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::vector<std::string> names_of_certifiers() {
  std::vector<std::string> names;
  for (const CertifierName& entry : certifier_names()) names.push_back(entry.name);
  return names;
}

}  // namespace

std::vector<OptionSpec> SolverMethod::options() const {
  std::vector<std::string> arithmetics;
  for (const Arithmetic a : kArithmetics) arithmetics.emplace_back(name_of(a));
  return {
      OptionSpec{
          "contractor",
          "what shrinks a box: names joined by + are applied in turn to a fixpoint, one with ? only where it "
          "has paid; of " +
              joined(contractor_registry().names()),
          contractor},
      choice_option("arithmetic", "the interval arithmetic of the contractors", "fast", arithmetics),
      integer_option("bits", "precision of the arithmetic mpfr", "bits", 128, 24, 100'000),
      choice_option("lp", "the solver of linear programs", "simplex", lp_registry().names()),
      choice_option("lp_safety", "what is believed of its answers; tolerance and unprotected are baselines",
                    "dual", {"dual", "exact", "tolerance", "unprotected"}),
      choice_option("lp_products",
                    "products of bound factors in the polytope, from degree 3 on: of pairs of columns, of a "
                    "factor for each variable, or both",
                    "factors", {"pairs", "factors", "both"}),
      choice_option("bisection", "which side of a box is cut", bisection, bisection_registry().names()),
      OptionSpec{"certifier",
                 "what proves roots: names joined by +, which together must show that a root exists and that "
                 "it is alone; of " +
                     joined(names_of_certifiers()),
                 SearchOptions().certifier},
      choice_option("order", "which box is taken next", "depth_first", {"depth_first", "best_first"}),
      real_option("fixpoint_ratio", "contract again while a round shrinks some side by this part of it", "",
                  0.2, 1e-3, 1),
      real_option("propagation_ratio", "a side that shrank by less than this part wakes no other equation",
                  "", 0.1, 0, 1),
      real_option("resolution", "a side narrower than this part of its magnitude is not cut", "", 1e-13,
                  1e-16, 1),
      real_option("cover_resolution",
                  "the same where equations are fewer than variables, as part of the search box", "",
                  1.0 / 64, 1e-12, 1),
      integer_option("cluster_boxes",
                     "boxes spent on a box narrower than 1e-5 of its variables' sizes; what is left stays "
                     "undecided",
                     "boxes", 20'000, 1, 1'000'000'000),
      integer_option("maximum_bits", "precision goes up to this where double cannot decide; 53: never",
                     "bits", 1024, 53, 100'000),
      integer_option("maximum_boxes", "work budget", "boxes", 1'000'000'000, 1, 1'000'000'000'000),
  };
}

Promise SolverMethod::promise(const Options& options) {
  const bool uses_lp = options.word("contractor").find("lp_reduction") != std::string::npos;
  const std::string& safety = options.word("lp_safety");
  if (uses_lp && (safety == "tolerance" || safety == "unprotected")) return Promise::baseline;
  return promise_of(arithmetic_from_name(options.word("arithmetic")));
}

// A new method is one line here.
const Registry<SolverMethod>& solver_method_registry() {
  static const Registry<SolverMethod> registry(
      "method",
      {
          {"adaptive",
           "hull consistency and least-squares multipliers while they gain; constructive disjunction and "
           "linear programs where they have paid",
           4, "hull+multipliers+adaptive_constructive_disjunction?+lp_reduction?", "combined_smear"},
          {"interval_newton",
           "interval Newton with Gauss-Seidel steps, preconditioned by the midpoint inverse", 2, "newton"},
          {"krawczyk", "Krawczyk's operator", 2, "krawczyk"},
          {"hull_newton", "hull consistency, then interval Newton", 2, "hull+newton"},
          {"bernstein_projection",
           "the preconditioned system in the Bernstein basis, projected by convex hulls (Sherbrooke, "
           "Patrikalakis 1993)",
           3, "bernstein_projection"},
          {"mourrain_pavone", "the same, with the roots of control polynomials (Mourrain, Pavone 2009)", 3,
           "mourrain_pavone"},
          {"lp_reduction", "linear programs over the Bernstein polytope of the box", 4, "lp_reduction"},
          {"multiplier_projection", "least-squares multipliers alone", 3, "multipliers"},
      });
  return registry;
}

ContractorMaker contractor_maker(const Options& options) {
  ContractorSettings settings;
  settings.arithmetic = arithmetic_from_name(options.word("arithmetic"));
  settings.bits = static_cast<int>(options.integer("bits"));
  settings.lp = options.word("lp");
  settings.lp_safety = options.word("lp_safety");
  settings.lp_products = options.word("lp_products");
  settings.propagation_ratio = options.real("propagation_ratio");
  settings.fixpoint_ratio = options.real("fixpoint_ratio");
  return [settings, composition = options.word("contractor")](const SystemFunctions& functions, int bits) {
    ContractorSettings wanted = settings;
    if (bits > 53) {
      wanted.arithmetic = Arithmetic::mpfr;
      wanted.bits = bits;
    }
    return make_contractor(composition, functions, wanted);
  };
}

SearchOptions search_options(const Options& options) {
  SearchOptions result;
  result.bisection = options.word("bisection");
  result.certifier = options.word("certifier");
  check_certifier(result.certifier);
  result.order = options.word("order") == "best_first" ? Order::best_first : Order::depth_first;
  result.resolution = options.real("resolution");
  result.cover_resolution = options.real("cover_resolution");
  result.cluster_boxes = static_cast<std::uint64_t>(options.integer("cluster_boxes"));
  result.maximum_bits = static_cast<int>(options.integer("maximum_bits"));
  result.maximum_boxes = static_cast<std::uint64_t>(options.integer("maximum_boxes"));
  return result;
}

}  // namespace gcslab
