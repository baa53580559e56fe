#include "box_solver/bisection.h"

#include <algorithm>
#include <cmath>

#include "box_solver/combined_smear.h"
#include "interval/fast_interval.h"

namespace gcslab {
namespace {

template <class Value>
std::size_t with_largest(const std::vector<std::size_t>& open, Value value) {
  return *std::ranges::max_element(open, {}, value);
}

class LongestSide final : public Bisection {
 public:
  std::size_t choose(const Box& box, const std::vector<std::size_t>& open, const BisectionHistory&) override {
    return with_largest(open, [&](std::size_t i) { return width(box[i]); });
  }
};

class LeastReducedSide final : public Bisection {
 public:
  std::size_t choose(const Box& box, const std::vector<std::size_t>& open,
                     const BisectionHistory& history) override {
    return with_largest(open, [&](std::size_t i) {
      const double before = width(history.parent[i]);
      const double kept = std::isinf(before) || before == 0 ? 1 : width(box[i]) / before;
      return std::pair(kept, width(box[i]));
    });
  }
};

class RoundRobin final : public Bisection {
 public:
  std::size_t choose(const Box&, const std::vector<std::size_t>& open,
                     const BisectionHistory& history) override {
    const auto next = std::ranges::upper_bound(open, history.last_variable);
    return next == open.end() ? open.front() : *next;
  }
};

/// The smear of a variable in an equation is |df/dx_i| w_i (Kearfott 1987; the relative form is Trombettoni,
/// Araya, Neveu, Chabert 2011: each equation's smears are divided by their sum).
enum class Smear { maximum, sum, relative_sum };

template <Smear kind>
class SmearBisection final : public ScoredBisection {
 public:
  explicit SmearBisection(const SystemFunctions& functions)
      : functions_(&functions), evaluators_(made(functions)), smears_(functions.variables()) {}

  const std::vector<double>& scores(const Box& box) override {
    compute(box);
    return smears_;
  }

 private:
  static std::vector<TapeEvaluator<FastInterval>> made(const SystemFunctions& functions) {
    const NumberTraits<FastInterval>::Scope scope;
    std::vector<TapeEvaluator<FastInterval>> result;
    for (const SystemFunction& f : functions.equations()) result.emplace_back(f.tape);
    return result;
  }

  void compute(const Box& box) {
    const NumberTraits<FastInterval>::Scope scope;
    point_.clear();
    for (const Interval& side : box) point_.emplace_back(side);
    std::ranges::fill(smears_, 0);
    for (std::size_t k = 0; k < evaluators_.size(); ++k) add_equation(k, box);
  }

  void add_equation(std::size_t k, const Box& box) {
    const std::vector<std::size_t>& variables = functions_->equations()[k].variables;
    evaluators_[k].evaluate(point_);
    const std::span<const FastInterval> gradient = evaluators_[k].reverse_gradient();
    const auto smear = [&](std::size_t i) {
      const double size = magnitude(gradient[i].interval()) * width(box[i]);
      return std::isfinite(size) ? size : std::numeric_limits<double>::max() / 1e3;
    };
    double total = 1;
    if (kind == Smear::relative_sum) {
      total = 0;
      for (const std::size_t i : variables) total += smear(i);
      if (!(total > 0)) return;
    }
    for (const std::size_t i : variables) {
      const double value = smear(i) / total;
      smears_[i] = kind == Smear::maximum ? std::max(smears_[i], value) : smears_[i] + value;
    }
  }

  const SystemFunctions* functions_;
  std::vector<TapeEvaluator<FastInterval>> evaluators_;
  std::vector<FastInterval> point_;
  std::vector<double> smears_;
};

template <class Strategy>
std::unique_ptr<Bisection> plain(const SystemFunctions&) {
  return std::make_unique<Strategy>();
}

template <Smear kind>
std::unique_ptr<Bisection> smear(const SystemFunctions& functions) {
  return std::make_unique<SmearBisection<kind>>(functions);
}

}  // namespace

std::size_t ScoredBisection::choose(const Box& box, const std::vector<std::size_t>& open,
                                    const BisectionHistory&) {
  const std::vector<double>& score = scores(box);
  const std::size_t best = with_largest(open, [&](std::size_t i) { return score[i]; });
  if (score[best] > 0 && std::isfinite(score[best])) return best;
  return with_largest(open, [&](std::size_t i) { return width(box[i]); });
}

std::unique_ptr<ScoredBisection> make_relative_smear_sum(const SystemFunctions& functions) {
  return std::make_unique<SmearBisection<Smear::relative_sum>>(functions);
}

// A new strategy is one line here.
const Registry<BisectionVariant>& bisection_registry() {
  static const Registry<BisectionVariant> registry(
      "bisection",
      {
          {"longest_side", "the widest side", &plain<LongestSide>},
          {"least_reduced_side", "the side that the last contraction shrank least", &plain<LeastReducedSide>},
          {"round_robin", "one side after the other", &plain<RoundRobin>},
          {"smear_max", "the largest |df/dx_i| w_i of any equation (Kearfott 1987)", &smear<Smear::maximum>},
          {"smear_sum", "the largest sum of |df/dx_i| w_i over the equations", &smear<Smear::sum>},
          {"relative_smear_sum",
           "as smear_sum, each equation's smears divided by their sum (Trombettoni et al. 2011)",
           &smear<Smear::relative_sum>},
          {"combined_smear",
           "relative_smear_sum, and the same for what least-squares multipliers leave over, in equal parts",
           &make_combined_smear},
      });
  return registry;
}

bool cut_point(const Interval& side, double& point) {
  const double infinity = std::numeric_limits<double>::infinity();
  if (side.lower == -infinity && side.upper == infinity) {
    point = 0;
  } else if (side.upper == infinity) {
    point = side.lower < 1 ? 2 : 16 * side.lower;
  } else if (side.lower == -infinity) {
    point = side.upper > -1 ? -2 : 16 * side.upper;
  } else {
    point = midpoint(side);
  }
  return side.lower < point && point < side.upper && std::isfinite(point);
}

}  // namespace gcslab
