#include "box_solver/bernstein_contractor.h"

#include <algorithm>

#include "base/error.h"
#include "box_solver/least_squares.h"
#include "certification/preconditioned_form.h"
#include "interval/arithmetic.h"
#include "interval/point_numbers.h"
#include "interval/scaled.h"
#include "polynomial/bernstein.h"
#include "polynomial/control_polygon.h"
#include "polynomial/recognise.h"

namespace gcslab {
namespace {

/// The largest degree of each variable in any equation.
Exponents common_degrees(const SystemFunctions& functions) {
  Exponents result(functions.variables(), 0);
  for (const SystemFunction& equation : functions.equations()) {
    const Exponents degrees = equation.polynomial->degrees();
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = std::max(result[i], degrees[i]);
  }
  return result;
}

void refuse_unless_polynomial(const SystemFunctions& functions) {
  for (std::size_t k = 0; k < functions.equations().size(); ++k) {
    const SystemFunction& equation = functions.equations()[k];
    if (equation.polynomial) continue;
    const Recognition recognition =
        recognise_polynomial(equation.expression, static_cast<int>(functions.variables()),
                             {.terms = 2000, .products = 200'000, .degree = 200, .bits = 20'000});
    throw NotApplicable("Bernstein forms need polynomials; equation " + std::to_string(k + 1) + " " +
                        recognition.reason);
  }
}

/// Their number has many digits for many variables: counted exactly, so that the reason is true.
void refuse_too_large(const SystemFunctions& functions, const Exponents& degrees, std::size_t most) {
  mpz_class size = static_cast<unsigned long>(functions.equations().size());
  for (const int degree : degrees) size *= degree + 1;
  if (size <= static_cast<unsigned long>(most)) return;
  throw NotApplicable("the Bernstein tensors of the equations have " + size.get_str() +
                      " coefficients, more than " + std::to_string(most));
}

template <class T>
class BernsteinContractor final : public Contractor {
 public:
  BernsteinContractor(const SystemFunctions& functions, BernsteinProjection projection, int bits,
                      std::size_t maximum_coefficients)
      : functions_(&functions),
        projection_(projection),
        bits_(bits),
        slopes_(made(functions)),
        converter_(converter_for(functions, bits, maximum_coefficients)),
        jacobian_(functions.equations().size(), functions.variables()) {}

  bool contract(Box& box, ProofTrace& trace) override {
    if (!std::ranges::all_of(box, is_bounded) || functions_->equations().empty()) return true;
    const typename NumberTraits<T>::Scope scope(bits_);
    trace.add({Argument::expansion});
    if (!convert(box, trace)) return false;
    compute_multipliers(box);
    const Box whole = box;
    for (std::size_t i = 0; i < box.size(); ++i) {
      if (!project(i, whole, box, trace)) return false;
    }
    return true;
  }

 private:
  static SystemEvaluator<double> made(const SystemFunctions& functions) {
    const NumberTraits<double>::Scope scope;
    return SystemEvaluator<double>(functions);
  }

  static BernsteinConverter<T> converter_for(const SystemFunctions& functions, int bits,
                                             std::size_t maximum_coefficients) {
    refuse_unless_polynomial(functions);
    const Exponents degrees = common_degrees(functions);
    refuse_too_large(functions, degrees, maximum_coefficients);
    std::vector<Polynomial> polynomials;
    for (const SystemFunction& equation : functions.equations()) polynomials.push_back(*equation.polynomial);
    const typename NumberTraits<T>::Scope scope(bits);
    return BernsteinConverter<T>(polynomials, degrees);
  }

  /// The tensors of all equations, in equal degrees. False: one of them shows that the box has no root.
  bool convert(const Box& box, ProofTrace& trace) {
    std::vector<T> starts, widths;
    for (const Interval& side : box) {
      starts.push_back(NumberTraits<T>::from_interval(Interval(side.lower)));
      widths.push_back(NumberTraits<T>::from_interval(Interval(side.upper)) - starts.back());
    }
    tensors_ = converter_.convert(starts, widths);
    for (std::size_t k = 0; k < tensors_.size(); ++k) {
      if (contains(tensors_[k].range(), 0)) continue;
      multipliers_.assign(functions_->equations().size(), 0);
      multipliers_[k] = 1;
      trace.add({Argument::bernstein_row, 0, 0, Interval::empty(), multipliers_});
      return false;
    }
    return true;
  }

  void compute_multipliers(const Box& box) {
    const NumberTraits<double>::Scope scope;
    std::vector<double> centre;
    for (const Interval& side : box) centre.push_back(midpoint(side));
    static_cast<void>(slopes_.jacobian(centre, jacobian_));
    system_.reset(jacobian_.rows(), jacobian_.columns(), jacobian_.columns());
    for (std::size_t k = 0; k < jacobian_.rows(); ++k) {
      for (std::size_t j = 0; j < jacobian_.columns(); ++j)
        system_.set(k, j, jacobian_(k, j) * radius(box[j]));
    }
    has_multipliers_ = system_.solve();
  }

  /// Multipliers of the combination for a variable: one equation after the other when no better are known.
  void choose_multipliers(std::size_t i) {
    multipliers_.assign(tensors_.size(), 0);
    if (has_multipliers_) std::ranges::copy(system_.multipliers(i), multipliers_.begin());
    if (std::ranges::all_of(multipliers_, [](double c) { return c == 0; }))
      multipliers_[i % tensors_.size()] = 1;
  }

  /// The hulls of the layers of coefficients along a variable.
  void see_along(std::size_t i) {
    const AxisShape shape = tensors_.front().shape(static_cast<int>(i));
    layers_.assign(shape.count, Interval::empty());
    std::vector<T> values(tensors_.size());
    for (std::size_t place = 0; place < tensors_.front().coefficients().size(); ++place) {
      for (std::size_t k = 0; k < tensors_.size(); ++k) values[k] = tensors_[k].coefficients()[place];
      const Interval value = NumberTraits<T>::enclosure(combination<T>(multipliers_, values));
      Interval& layer = layers_[place / shape.row % shape.count];
      layer = hull(layer, value);
    }
  }

  bool project(std::size_t i, const Box& whole, Box& box, ProofTrace& trace) {
    choose_multipliers(i);
    see_along(i);
    const Interval t =
        projection_ == BernsteinProjection::hull ? hull_crossings(layers_) : polynomial_crossings(layers_);
    const Interval side = intersection(box[i], on_side(whole[i], t));
    if (side == box[i]) return true;
    trace.add({Argument::bernstein_row, 0, static_cast<std::uint32_t>(i), side, multipliers_});
    box[i] = side;
    return !is_empty(side);
  }

  /// Encloses {lower + (upper - lower) s : s in t}.
  static Interval on_side(const Interval& side, const Interval& t) {
    if (is_empty(t)) return t;
    const UpwardRounding upward;
    const FastInterval lower(side.lower);
    return (lower + (FastInterval(side.upper) - lower) * FastInterval(t)).interval();
  }

  const SystemFunctions* functions_;
  BernsteinProjection projection_;
  int bits_;
  SystemEvaluator<double> slopes_;
  BernsteinConverter<T> converter_;
  Matrix<double> jacobian_;
  LeastSquaresMultipliers system_;
  bool has_multipliers_ = false;
  std::vector<BernsteinTensor<T>> tensors_;
  std::vector<double> multipliers_;
  std::vector<Interval> layers_;
};

}  // namespace

template <class T>
std::unique_ptr<Contractor> make_bernstein_contractor(const SystemFunctions& functions,
                                                      BernsteinProjection projection, int bits,
                                                      std::size_t maximum_coefficients) {
  return std::make_unique<BernsteinContractor<T>>(functions, projection, bits, maximum_coefficients);
}

template std::unique_ptr<Contractor> make_bernstein_contractor<FastInterval>(const SystemFunctions&,
                                                                             BernsteinProjection, int,
                                                                             std::size_t);
template std::unique_ptr<Contractor> make_bernstein_contractor<BoostInterval>(const SystemFunctions&,
                                                                              BernsteinProjection, int,
                                                                              std::size_t);
template std::unique_ptr<Contractor> make_bernstein_contractor<MpfrInterval>(const SystemFunctions&,
                                                                             BernsteinProjection, int,
                                                                             std::size_t);
template std::unique_ptr<Contractor> make_bernstein_contractor<UnroundedInterval>(const SystemFunctions&,
                                                                                  BernsteinProjection, int,
                                                                                  std::size_t);

}  // namespace gcslab
