// The range itself, to a tolerance: branch and bound on Bernstein coefficients, whose corners are values of f
// (Garloff 1986; Smith 2009).

#include <algorithm>
#include <vector>

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

/// The hull of the differences of neighbouring coefficients along the variable; degree times it encloses the
/// partial derivative. An upward scope must be open.
Interval steps(const Coefficients& tensor, int variable) {
  const AxisShape shape = tensor.shape(variable);
  const FastInterval* from = tensor.coefficients().data();
  Interval hull(0);
  for (std::size_t block = 0, i = 0; block < shape.blocks; ++block, i += shape.row) {
    for (const std::size_t last = i + (shape.count - 1) * shape.row; i < last; ++i) {
      const FastInterval step = from[i + shape.row] - from[i];
      hull = {std::min(hull.lower, step.lower()), std::max(hull.upper, step.upper())};
    }
  }
  return hull;
}

/// What is left to be searched for the least value, and the variable to split there.
struct Part {
  Coefficients tensor;
  int widest = 0;
  double lower = 0;
};

/// Moves to the face where f is least in each variable in which it is monotone. An upward scope must be open.
Part part_of(Coefficients tensor) {
  Part part{std::move(tensor)};
  double most = -1;
  for (int variable = 0; variable < part.tensor.variables();) {
    const Interval change = steps(part.tensor, variable);
    if (change.lower >= 0 || change.upper <= 0) {
      part.tensor = part.tensor.face(variable, change.lower >= 0 ? Side::lower : Side::upper);
      variable = 0;
      most = -1;
      continue;
    }
    const double size = part.tensor.degree(variable) * (change.upper - change.lower);
    if (size > most) {
      most = size;
      part.widest = variable;
    }
    ++variable;
  }
  part.lower = part.tensor.range().lower;
  return part;
}

/// A lower bound of f, raised by splitting the part with the least bound until f is known to come near it. An
/// upward scope must be open.
double refined_lower_bound(const Coefficients& root, const Effort& effort) {
  const Interval whole = root.range();
  const double tolerance = effort.tolerance * (whole.upper - whole.lower);
  const auto later = [](const Part& a, const Part& b) { return a.lower > b.lower; };
  std::vector<Part> parts;  // a heap, the least bound first
  parts.push_back(part_of(root));
  double attained = least_corner(parts.front().tensor);
  for (std::int64_t split = 0; split < effort.splits; ++split) {
    if (attained - parts.front().lower <= tolerance || parts.front().tensor.variables() == 0) break;
    std::pop_heap(parts.begin(), parts.end(), later);
    const Part part = std::move(parts.back());
    parts.pop_back();
    Coefficients lower, upper;
    part.tensor.halve(part.widest, lower, upper);
    for (Coefficients* tensor : {&lower, &upper}) {
      Part half = part_of(std::move(*tensor));
      half.lower = std::max(part.lower, half.lower);
      attained = std::min(attained, least_corner(half.tensor));
      parts.push_back(std::move(half));
      std::push_heap(parts.begin(), parts.end(), later);
    }
  }
  return parts.front().lower;
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
