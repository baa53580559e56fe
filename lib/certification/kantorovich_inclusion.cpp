// The theorem of Newton and Kantorovich in its affine invariant form (Kantorovich 1948; Ortega and Rheinboldt
// 1970, theorem 12.6.2; Deuflhard and Heindl 1979). In the maximum norm weighted by w, with J(x0) nonsingular
// and on a convex set D
//   ||J(x0)^-1 f(x0)|| <= eta,   ||J(x0)^-1 (J(x) - J(y))|| <= K ||x - y||,   h = K eta <= 1/2,
// f has a zero within t* = 2 eta / (1 + sqrt(1 - 2h)) of x0 if that ball lies in D, and no other one in D
// within less than t** = (1 + sqrt(1 - 2h)) / K. Here w reaches from x0 to the ends of the box, so that the
// box lies in the unit ball, which D contains; t* < 1 < t** is shown by eta - 1 + K / 2 < 0. C stands for the
// inverse: with
// ||I - C J(x0)|| <= delta < 1, bounds of C f and C (J(x) - J(y)) are divided by 1 - delta. K comes from the
// second derivatives over D; it is the exact Lipschitz constant of C J when f is quadratic.

#include <cmath>

#include "certification/inclusion_maker.h"
#include "certification/preconditioned_form.h"
#include "expression/differentiate.h"
#include "expression/substitute.h"
#include "interval/scaled.h"

namespace gcslab {
namespace {

/// First derivatives of all equations, then their second ones by j <= l, equation by equation.
Tape derivatives_of(const SystemFunctions& functions) {
  ExpressionGraph graph;
  const int n = static_cast<int>(functions.variables());
  std::vector<Expression> variables, first, second;
  for (int i = 0; i < n; ++i) variables.push_back(graph.variable(i));
  for (const SystemFunction& equation : functions.equations()) {
    const Expression f = equation.polynomial ? equation.polynomial->to_expression(graph)
                                             : substitute(equation.expression, graph, variables);
    const std::vector<Expression> slopes = gradient(f, n);
    for (int j = 0; j < n; ++j) {
      for (int l = j; l < n; ++l) second.push_back(differentiate(slopes[static_cast<std::size_t>(j)], l));
    }
    first.insert(first.end(), slopes.begin(), slopes.end());
  }
  first.insert(first.end(), second.begin(), second.end());
  return Tape(first, n);
}

template <class T>
class KantorovichInclusion final : public InclusionTest {
 public:
  KantorovichInclusion(const SystemFunctions& functions, int bits)
      : bits_(bits),
        n_(functions.variables()),
        form_(functions),
        derivatives_(derivatives_of(functions)),
        evaluator_(derivatives_) {}

  std::optional<Evidence> prove(const Box& box, const ApproximateRoot& approximate) override {
    const typename NumberTraits<T>::Scope scope(bits_);
    const std::vector<double> centre = centre_in(box, approximate);
    Box point;
    for (const double c : centre) point.emplace_back(c);
    if (!measure(box, centre) || !form_.evaluate(domain_, centre) || !form_.evaluate(point, centre))
      return std::nullopt;
    evaluator_.evaluate(domain_numbers());
    if (!evaluator_.defined_everywhere()) return std::nullopt;
    form_.precondition(approximate.inverse);
    const std::optional<double> radius = root_radius(approximate.inverse);
    if (!radius || !contains_ball(box, centre, *radius)) return std::nullopt;
    return Evidence{"kantorovich", Claim::unique, box, bits_};
  }

 private:
  /// The weights w, and the domain D = x0 + [-w, w]. False when a side has no width.
  bool measure(const Box& box, std::span<const double> centre) {
    const UpwardRounding upward;
    weights_.clear();
    domain_.clear();
    for (std::size_t i = 0; i < box.size(); ++i) {
      weights_.push_back(
          std::max(rounded_subtract(box[i].upper, centre[i]), rounded_subtract(centre[i], box[i].lower)));
      if (!(weights_[i] > 0) || !std::isfinite(weights_[i])) return false;
      const FastInterval reach(-weights_[i], weights_[i]);
      domain_.push_back((FastInterval(centre[i]) + reach).interval());
      if (!is_bounded(domain_[i])) return false;
    }
    return true;
  }

  std::vector<T> domain_numbers() const {
    std::vector<T> result;
    for (const Interval& side : domain_) result.push_back(NumberTraits<T>::from_interval(side));
    return result;
  }

  /// An upper bound of |x| / w_i.
  double in_units(std::size_t i, const T& x) const {
    const T unit = NumberTraits<T>::from_interval(Interval(weights_[i]));
    const Interval size = NumberTraits<T>::enclosure(abs(x) / unit);
    return is_empty(size) ? std::numeric_limits<double>::infinity() : size.upper;
  }

  /// Number of d^2 f_k / dx_j dx_l, j <= l, among the outputs of the tape.
  std::size_t second_derivative(std::size_t k, std::size_t j, std::size_t l) const {
    const std::size_t before = j * n_ - j * (j + 1) / 2 + l;  // pairs (a, b), a <= b, that come before (j, l)
    return n_ * n_ + k * (n_ * (n_ + 1) / 2) + before;
  }

  /// Encloses sum_k C_ik d^2 f_k / dx_j dx_l over D.
  T combined_second_derivative(std::span<const double> multipliers, std::size_t j, std::size_t l) const {
    T sum = NumberTraits<T>::from_interval(Interval(0));
    for (std::size_t k = 0; k < n_; ++k) {
      const std::size_t output = second_derivative(k, std::min(j, l), std::max(j, l));
      if (multipliers[k] != 0) sum = sum + scaled(multipliers[k], evaluator_.value(output));
    }
    return sum;
  }

  /// Upper bounds for row i: of |C f(x0)|, of I - C J(x0), and of the Lipschitz constant of C J.
  struct RowBounds {
    double value, residual, lipschitz;
  };
  RowBounds bounds_of_row(std::size_t i, const Matrix<double>& multipliers) const {
    T residual = NumberTraits<T>::from_interval(Interval(0));
    T lipschitz = residual;
    for (std::size_t j = 0; j < n_; ++j) {
      const T identity = NumberTraits<T>::from_interval(Interval(i == j ? 1 : 0));
      residual = residual + scaled(weights_[j], abs(identity - form_.matrix()(i, j)));
      for (std::size_t l = 0; l < n_; ++l) {
        const T curvature = abs(combined_second_derivative(multipliers.row(i), j, l));
        lipschitz = lipschitz + scaled(weights_[j], scaled(weights_[l], curvature));
      }
    }
    return {in_units(i, form_.values()[i]), in_units(i, residual), in_units(i, lipschitz)};
  }

  /// An upper bound of t*, when t* < 1 < t**.
  std::optional<double> root_radius(const Matrix<double>& multipliers) const {
    double eta = 0, delta = 0, constant = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      const RowBounds row = bounds_of_row(i, multipliers);
      eta = std::max(eta, row.value);
      delta = std::max(delta, row.residual);
      constant = std::max(constant, row.lipschitz);
    }
    if (!(delta < 1) || !std::isfinite(eta) || !std::isfinite(constant)) return std::nullopt;
    const UpwardRounding upward;
    const FastInterval one(1.0), two(2.0);
    const FastInterval slack = one - FastInterval(delta);
    const FastInterval step = FastInterval(eta) / slack;
    const FastInterval lipschitz = FastInterval(constant) / slack;
    if (!((step - one + lipschitz / two).upper() < 0)) return std::nullopt;
    return (two * step / (one + sqrt(one - two * lipschitz * step))).upper();
  }

  /// Whether the ball of that radius lies in the box.
  bool contains_ball(const Box& box, std::span<const double> centre, double radius) const {
    const UpwardRounding upward;
    for (std::size_t i = 0; i < n_; ++i) {
      const FastInterval reach = FastInterval(-radius, radius) * FastInterval(weights_[i]);
      if (!subset((FastInterval(centre[i]) + reach).interval(), box[i])) return false;
    }
    return true;
  }

  int bits_;
  std::size_t n_;
  PreconditionedForm<T> form_;
  Tape derivatives_;
  TapeEvaluator<T> evaluator_;
  std::vector<double> weights_;
  Box domain_;
};

}  // namespace

InclusionTestVariant kantorovich_inclusion() {
  return {"kantorovich",
          "Newton's iteration converges from a point of the box, by a bound of second derivatives "
          "(Kantorovich 1948)",
          Claim::unique, &make_inclusion_test<KantorovichInclusion>};
}

}  // namespace gcslab
