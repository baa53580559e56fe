// The range itself, to a tolerance: branch and bound on Bernstein coefficients, whose corners are values of f
// (Garloff 1986; Smith 2009).

#include <algorithm>
#include <queue>

#include "enclosure/bound_registry.h"
#include "enclosure/dyadic_slack.h"
#include "enclosure/tensor_walk.h"
#include "interval/fast_interval.h"
#include "polynomial/bernstein.h"

namespace gcslab {
namespace {

using Coefficients = BernsteinTensor<FastInterval>;

struct Effort {
  double tolerance;     ///< of an end, relative to the width of the values met
  std::int64_t splits;  ///< at most, for one end of a range or one decision
};

std::size_t corners(const Coefficients& tensor) { return std::size_t{1} << tensor.variables(); }

/// The least upper end of a corner's value: f takes a value that is no larger.
double least_corner(const Coefficients& tensor) {
  double least = Interval::entire().upper;
  for (std::size_t i = 0; i < corners(tensor); ++i) least = std::min(least, tensor.corner(i).upper());
  return least;
}

/// A lower bound of f, raised by splitting the part with the least bound until f is known to come near it. An
/// upward scope must be open.
double refined_lower_bound(const Coefficients& root, const Effort& effort) {
  struct Part {
    double lower;
    std::shared_ptr<const Coefficients> tensor;
    int next_variable;
  };
  const auto later = [](const Part& a, const Part& b) { return a.lower > b.lower; };
  std::priority_queue<Part, std::vector<Part>, decltype(later)> parts(later);
  const Interval whole = root.range();
  parts.push({whole.lower, std::make_shared<Coefficients>(root), 0});
  double attained = least_corner(root);
  const double tolerance = effort.tolerance * (whole.upper - whole.lower);
  for (std::int64_t split = 0; split < effort.splits; ++split) {
    const Part part = parts.top();
    if (attained - part.lower <= tolerance) break;
    parts.pop();
    Coefficients lower, upper;
    part.tensor->halve(part.next_variable, lower, upper);
    for (Coefficients* half : {&lower, &upper}) {
      attained = std::min(attained, least_corner(*half));
      const double bound = std::max(part.lower, half->range().lower);
      parts.push({bound, std::make_shared<Coefficients>(std::move(*half)),
                  (part.next_variable + 1) % root.variables()});
    }
  }
  return parts.top().lower;
}

Coefficients negated(Coefficients tensor) {
  for (FastInterval& coefficient : tensor.coefficients()) coefficient = -coefficient;
  return tensor;
}

Interval refined_range(const Coefficients& tensor, const Effort& effort) {
  const double lower = refined_lower_bound(tensor, effort);
  const double upper = -refined_lower_bound(negated(tensor), effort);
  return {lower, upper};
}

/// Decides whether f vanishes on a box, as far as the effort goes.
class ZeroDecision {
 public:
  explicit ZeroDecision(std::int64_t splits) : splits_left_(splits) {}

  /// True only when f has no zero on the part. An upward scope must be open. Parts below kDeepest halvings of
  /// each variable decide nothing more in double.
  bool excludes(const Coefficients& part, int variable, int depth = 0) {
    const Interval range = part.range();
    if (!contains(range, 0)) {
      (range.lower > 0 ? positive_ : negative_) = true;
      return !(positive_ && negative_);
    }
    for (std::size_t i = 0; i < corners(part); ++i) {
      positive_ = positive_ || part.corner(i).lower() >= 0;
      negative_ = negative_ || part.corner(i).upper() <= 0;
    }
    if (positive_ && negative_) return false;  // f has both signs: it vanishes in between
    if (splits_left_-- <= 0 || depth > kDeepest * part.variables()) return false;
    Coefficients lower, upper;
    part.halve(variable, lower, upper);
    const int next = (variable + 1) % part.variables();
    return excludes(lower, next, depth + 1) && excludes(upper, next, depth + 1);
  }

 private:
  static constexpr int kDeepest = 60;

  std::int64_t splits_left_;
  bool positive_ = false;
  bool negative_ = false;
};

class ExactWalk final : public BoundWalk {
 public:
  ExactWalk(Coefficients root, const Effort& effort) : path_(std::move(root)), effort_(effort) {}

  void enter(std::size_t variable, Half half) override {
    const UpwardRounding scope;
    path_.enter(variable, half);
  }
  void leave() override { path_.leave(); }
  Interval bound(const Box&) override {
    const UpwardRounding scope;
    return refined_range(path_.current(), effort_);
  }
  bool excludes_zero(const Box&) override {
    const UpwardRounding scope;
    return ZeroDecision(effort_.splits).excludes(path_.current(), 0);
  }

 private:
  TensorPath<Coefficients> path_;
  Effort effort_;
};

class ExactBound final : public RangeBound {
 public:
  ExactBound(const Polynomial& polynomial, const Effort& effort) : polynomial_(polynomial), effort_(effort) {}

  Interval over(const Box& box) override {
    const UpwardRounding scope;
    return refined_range(bernstein_from_polynomial<FastInterval>(polynomial_, rational_box(box)), effort_);
  }

  std::unique_ptr<BoundWalk> walk(const Box& domain, int depth) override {
    const UpwardRounding scope;
    auto root = bernstein_from_polynomial<FastInterval>(polynomial_, rational_box(domain));
    const Rational slack = dyadic_slack(polynomial_, domain, depth);
    if (slack > 0) {
      for (FastInterval& coefficient : root.coefficients()) coefficient = widened(coefficient, slack);
    }
    return std::make_unique<ExactWalk>(std::move(root), effort_);
  }

 private:
  Polynomial polynomial_;
  Effort effort_;
};

std::unique_ptr<RangeBound> make(const BoundTarget& target, const Options& options) {
  return std::make_unique<ExactBound>(target.polynomial(),
                                      Effort{options.real("tolerance"), options.integer("splits")});
}

}  // namespace

BoundVariant exact_bound() {
  return {"exact",
          "the range to a tolerance, by branch and bound on Bernstein coefficients (Garloff 1986)",
          "polynomials whose tensor has at most 2^24 coefficients",
          1,
          {real_option("tolerance", "of an end, relative to the width of the first bound", "", 1e-9, 0, 1),
           integer_option("splits", "largest number of splits for one end of a range or one decision", "",
                          4096, 0, 1'000'000)},
          make};
}

}  // namespace gcslab
