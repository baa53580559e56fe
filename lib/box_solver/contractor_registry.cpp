#include "box_solver/contractor_registry.h"

#include "box_solver/bernstein_contractor.h"
#include "box_solver/box_consistency_contractor.h"
#include "box_solver/disjunction_contractor.h"
#include "box_solver/fixpoint_contractor.h"
#include "box_solver/hull_contractor.h"
#include "box_solver/lp_reduction_contractor.h"
#include "box_solver/mean_value_contractor.h"
#include "box_solver/multiplier_contractor.h"

namespace gcslab {
namespace {

using Made = std::unique_ptr<Contractor>;

Made make_hull(const SystemFunctions& functions, const ContractorSettings& settings) {
  return with_arithmetic(settings.arithmetic, [&]<class T>(std::type_identity<T>) -> Made {
    return make_hull_contractor<T>(functions, settings.propagation_ratio, settings.bits);
  });
}

Made make_multipliers(const SystemFunctions& functions, const ContractorSettings& settings) {
  return with_arithmetic(settings.arithmetic, [&]<class T>(std::type_identity<T>) -> Made {
    return make_multiplier_contractor<T>(functions, {.bits = settings.bits});
  });
}

Made make_lp_reduction(const SystemFunctions& functions, const ContractorSettings& settings) {
  return make_lp_reduction_contractor(functions, {settings.lp, lp_safety_from_name(settings.lp_safety),
                                                  bound_products_from_name(settings.lp_products)});
}

template <MeanValueForm form>
Made make_mean_value(const SystemFunctions& functions, const ContractorSettings& settings) {
  return with_arithmetic(settings.arithmetic, [&]<class T>(std::type_identity<T>) -> Made {
    return make_mean_value_contractor<T>(functions, form, settings.bits);
  });
}

template <bool is_adaptive>
Made make_disjunction(const SystemFunctions& functions, const ContractorSettings& settings) {
  return make_disjunction_contractor(functions, make_hull(functions, settings), {.is_adaptive = is_adaptive});
}

Made make_box_consistency(const SystemFunctions& functions, const ContractorSettings& settings) {
  return with_arithmetic(settings.arithmetic, [&]<class T>(std::type_identity<T>) -> Made {
    return make_box_consistency_contractor<T>(functions, {.bits = settings.bits});
  });
}

template <BernsteinProjection projection>
Made make_bernstein(const SystemFunctions& functions, const ContractorSettings& settings) {
  return with_arithmetic(settings.arithmetic, [&]<class T>(std::type_identity<T>) -> Made {
    return make_bernstein_contractor<T>(functions, projection, settings.bits, settings.maximum_coefficients);
  });
}

std::vector<std::string> split_at_plus(const std::string& text) {
  std::vector<std::string> parts;
  std::size_t start = 0;
  for (std::size_t end = text.find('+'); end != std::string::npos; end = text.find('+', start)) {
    parts.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  parts.push_back(text.substr(start));
  return parts;
}

}  // namespace

// A new contractor is one line here.
const Registry<ContractorVariant>& contractor_registry() {
  static const Registry<ContractorVariant> registry(
      "contractor",
      {
          {"hull",
           "forward-backward propagation through each function as it is written (HC4-revise, Benhamou et al. "
           "1999)",
           &make_hull},
          {"multipliers",
           "for each variable the least-squares combination of the expanded equations, solved for it",
           &make_multipliers},
          {"lp_reduction",
           "least and largest value of each variable over the Bernstein polytope (Tahari 2011, section 5); "
           "terms that "
           "are no polynomials are variables in strips around their graphs",
           &make_lp_reduction},
          {"newton",
           "interval Newton: the mean value form, preconditioned by the midpoint inverse, solved row by row "
           "(Hansen, Sengupta 1981)",
           &make_mean_value<MeanValueForm::gauss_seidel>},
          {"krawczyk", "Krawczyk's operator on the same form (Krawczyk 1969, Moore 1977)",
           &make_mean_value<MeanValueForm::krawczyk>},
          {"constructive_disjunction",
           "slices of each side contracted by hull, and the hull of what is left (Trombettoni, Chabert 2007)",
           &make_disjunction<false>},
          {"adaptive_constructive_disjunction",
           "the same in order of smear, as long as it pays (after Neveu, Trombettoni, Araya 2015)",
           &make_disjunction<true>},
          {"box_consistency",
           "slices cut off both ends of each side where a function cannot vanish (Benhamou et al. 1994)",
           &make_box_consistency},
          {"bernstein_projection",
           "combined equations in the Bernstein basis, projected on each side by convex hulls (Sherbrooke, "
           "Patrikalakis 1993)",
           &make_bernstein<BernsteinProjection::hull>},
          {"mourrain_pavone",
           "the same with the roots of the lower and upper polynomials (Mourrain, Pavone 2009)",
           &make_bernstein<BernsteinProjection::polynomial>},
      });
  return registry;
}

std::unique_ptr<Contractor> make_contractor(const std::string& composition, const SystemFunctions& functions,
                                            const ContractorSettings& settings) {
  constexpr int kMaximumRounds = 50;
  std::vector<CompositionPart> parts;
  for (std::string name : split_at_plus(composition)) {
    const bool is_dear = name.ends_with('?');
    if (is_dear) name.pop_back();
    parts.push_back({contractor_registry().at(name).make(functions, settings), is_dear});
  }
  return make_fixpoint_contractor(std::move(parts), settings.fixpoint_ratio, kMaximumRounds);
}

}  // namespace gcslab
