#include "box_solver/univariate_search.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "box_solver/inequality_check.h"
#include "polynomial/recognise.h"
#include "univariate/real_roots.h"

namespace gcslab {
namespace {

constexpr int kLargestDegree = 200;

Polynomial polynomial_of(const SystemFunctions& functions) {
  if (functions.variables() != 1 || functions.equations().size() != 1) {
    throw NotApplicable("univariate_bernstein takes one equation in one variable; here are " +
                        std::to_string(functions.equations().size()) + " in " +
                        std::to_string(functions.variables()));
  }
  Recognition recognition =
      recognise_polynomial(functions.equations()[0].expression, 1, {.degree = kLargestDegree});
  if (!recognition.polynomial)
    throw NotApplicable("univariate_bernstein takes polynomials: the equation " + recognition.reason);
  return *std::move(recognition.polynomial);
}

RealLinePart exact_part(const Interval& side) {
  RealLinePart part;
  if (std::isfinite(side.lower)) part.lower = rational_from_double(side.lower);
  if (std::isfinite(side.upper)) part.upper = rational_from_double(side.upper);
  return part;
}

Interval outward(const Rational& lower, const Rational& upper) {
  const NumberTraits<FastInterval>::Scope scope;
  return hull(NumberTraits<FastInterval>::from_rational(lower).interval(),
              NumberTraits<FastInterval>::from_rational(upper).interval());
}

/// The root's interval in doubles, as narrow as they allow.
Interval double_interval(RealRoots& found, std::size_t root) {
  constexpr int kBits = 55;
  found.refine_relative(root, kBits);
  const RealRoot& wanted = found.roots()[root];
  const Rational centre = (wanted.lower + wanted.upper) / 2;
  const Interval middle = outward(centre, centre);
  for (const double end : {middle.lower, middle.upper})
    if (std::isfinite(end)) found.try_exact(root, rational_from_double(end));
  return outward(wanted.lower, wanted.upper);
}

/// Roots whose double intervals touch.
struct Cluster {
  Interval interval;
  std::size_t first;  ///< of the roots
  std::size_t count;
};

std::vector<Cluster> clusters(RealRoots& found) {
  std::vector<Cluster> result;
  for (std::size_t i = 0; i < found.roots().size(); ++i) {
    const Interval interval = double_interval(found, i);
    if (!result.empty() && result.back().interval.upper >= interval.lower) {
      result.back().interval = hull(result.back().interval, interval);
      ++result.back().count;
    } else {
      result.push_back({interval, i, 1});
    }
  }
  return result;
}

/// The end, towards the left neighbour, of what belongs to the right one.
double lower_border(const Interval& left, const Interval& right) {
  const double middle = midpoint({left.upper, right.lower});
  return left.upper < middle && middle < right.lower ? middle : right.lower;
}
double upper_border(const Interval& left, const Interval& right) {
  const double middle = midpoint({left.upper, right.lower});
  return left.upper < middle && middle < right.lower ? middle : left.upper;
}

class UnivariateSearch {
 public:
  UnivariateSearch(const SystemFunctions& functions, const Box& search_box)
      : side_(search_box[0]), inequalities_(functions) {}

  SearchResult run(RealRoots& found) {
    const std::vector<Cluster> all = clusters(found);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double lower = i == 0 ? side_.lower : lower_border(all[i - 1].interval, all[i].interval);
      const double upper =
          i + 1 == all.size() ? side_.upper : upper_border(all[i].interval, all[i + 1].interval);
      // What was not searched may hold roots as near as it likes.
      const Interval alone = found.unsearched().empty() ? Interval(lower, upper) : all[i].interval;
      all[i].count == 1 ? add_root(all[i], alone, found) : add_undecided(all[i]);
    }
    for (const RationalInterval& part : found.unsearched())
      result_.pending.push_back({outward(part.lower, part.upper)});
    result_.statistics.boxes = found.counts().intervals;
    result_.statistics.bisections = found.counts().halvings;
    result_.statistics.explored = 1;
    return std::move(result_);
  }

 private:
  void add_root(const Cluster& cluster, const Interval& alone, const RealRoots& found) {
    const CertifiedRoot root{{cluster.interval},
                             {alone},
                             {{"descartes", Claim::unique, {alone}, 0}},
                             found.roots()[cluster.first].multiplicity};
    result_.roots.push_back(root);
    if (const auto state = inequalities_.at(root.box)) result_.solutions.push_back({root, *state});
  }
  void add_undecided(const Cluster& cluster) {
    result_.undecided.push_back(
        {{cluster.interval},
         "contains " + std::to_string(cluster.count) + " distinct roots that no doubles tell apart"});
  }

  Interval side_;
  InequalityCheck inequalities_;
  SearchResult result_;
};

SearchResult everything(const Box& box) {
  SearchResult result;
  result.undecided.push_back({box, "every point is a root: the equation is 0 = 0"});
  result.statistics.explored = 1;
  return result;
}

SearchResult roots(const SystemFunctions& functions, const Polynomial& polynomial, const Box& search_box,
                   const std::stop_token& stop) {
  RealRoots found(primitive_polynomial(polynomial), exact_part(search_box[0]), stop);
  return UnivariateSearch(functions, search_box).run(found);
}

/// Where the roots lie at which an inequality fails.
std::vector<Interval> excluded(const SearchResult& result) {
  std::vector<Interval> intervals;
  for (const CertifiedRoot& root : result.roots) {
    const auto is_root = [&](const Solution& solution) { return solution.root.box == root.box; };
    if (std::ranges::none_of(result.solutions, is_root)) intervals.push_back(root.box[0]);
  }
  return intervals;
}

}  // namespace

SearchResult univariate_search(const SystemFunctions& functions, const Box& search_box, ProofLog* proof,
                               const std::stop_token& stop) {
  const Polynomial polynomial = polynomial_of(functions);
  if (proof != nullptr) {
    proof->begin(search_box);
    proof->start(0, search_box);
    proof->node(0, ProofTrace());
  }
  SearchResult result =
      polynomial.is_zero() ? everything(search_box) : roots(functions, polynomial, search_box, stop);
  if (proof != nullptr) {
    polynomial.is_zero() ? proof->end_undecided() : proof->end_counted(excluded(result));
    proof->finish();
  }
  return result;
}

}  // namespace gcslab
