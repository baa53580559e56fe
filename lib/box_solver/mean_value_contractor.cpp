#include "box_solver/mean_value_contractor.h"

#include <algorithm>

#include "base/error.h"
#include "certification/preconditioned_form.h"
#include "interval/arithmetic.h"
#include "interval/reverse_operations.h"

namespace gcslab {
namespace {

template <class T>
class MeanValueContractor final : public Contractor {
 public:
  MeanValueContractor(const SystemFunctions& functions, MeanValueForm form, int bits)
      : form_(form), bits_(bits), system_(made(functions, bits)) {}

  bool contract(Box& box, ProofTrace& trace) override {
    if (!std::ranges::all_of(box, is_bounded)) return true;
    const typename NumberTraits<T>::Scope scope(bits_);
    midpoints_.clear();
    for (const Interval& side : box) midpoints_.push_back(midpoint(side));
    if (!system_.evaluate(box, midpoints_)) return true;
    multipliers_ = system_.midpoint_inverse();
    if (!multipliers_) return true;
    system_.precondition(*multipliers_);
    offsets_.assign(system_.offsets().begin(), system_.offsets().end());
    trace.add({Argument::expansion});
    for (std::size_t i = 0; i < box.size(); ++i) {
      if (!solve_for(i, box, trace)) return false;
    }
    return true;
  }

 private:
  static PreconditionedForm<T> made(const SystemFunctions& functions, int bits) {
    if (!functions.is_square()) {
      throw NotApplicable("interval Newton methods need as many equations as variables, not " +
                          std::to_string(functions.equations().size()) + " in " +
                          std::to_string(functions.variables()));
    }
    const typename NumberTraits<T>::Scope scope(bits);
    return PreconditionedForm<T>(functions);
  }

  /// Encloses the x_i - m_i of the roots.
  T solved_offset(std::size_t i) const {
    T rest = system_.values()[i];
    for (std::size_t j = 0; j < offsets_.size(); ++j) {
      if (j != i) rest = rest + system_.matrix()(i, j) * offsets_[j];
    }
    const T& diagonal = system_.matrix()(i, i);
    if (form_ == MeanValueForm::gauss_seidel) return reverse_multiply<T>(-rest, diagonal, offsets_[i]);
    const T one = NumberTraits<T>::from_interval(Interval(1));
    return intersection(offsets_[i], (one - diagonal) * offsets_[i] - rest);
  }

  bool solve_for(std::size_t i, Box& box, ProofTrace& trace) {
    const T solved = solved_offset(i);
    const Interval side = intersection(box[i], NumberTraits<T>::enclosure(system_.centre()[i] + solved));
    if (side == box[i]) return true;
    tell(i, side, trace);
    if (is_empty(side)) return false;
    box[i] = side;
    offsets_[i] = intersection(solved, NumberTraits<T>::from_interval(side) - system_.centre()[i]);
    return true;
  }

  void tell(std::size_t i, const Interval& side, ProofTrace& trace) const {
    if (!trace.wanted()) return;
    const std::span<const double> row = multipliers_->row(i);
    trace.add({Argument::mean_value_row, 0, static_cast<std::uint32_t>(i), side,
               std::vector<double>(row.begin(), row.end())});
  }

  MeanValueForm form_;
  int bits_;
  PreconditionedForm<T> system_;
  std::optional<Matrix<double>> multipliers_;
  std::vector<double> midpoints_;
  std::vector<T> offsets_;  ///< of what is left of the box
};

}  // namespace

template <class T>
std::unique_ptr<Contractor> make_mean_value_contractor(const SystemFunctions& functions, MeanValueForm form,
                                                       int bits) {
  return std::make_unique<MeanValueContractor<T>>(functions, form, bits);
}

template std::unique_ptr<Contractor> make_mean_value_contractor<FastInterval>(const SystemFunctions&,
                                                                              MeanValueForm, int);
template std::unique_ptr<Contractor> make_mean_value_contractor<BoostInterval>(const SystemFunctions&,
                                                                               MeanValueForm, int);
template std::unique_ptr<Contractor> make_mean_value_contractor<MpfrInterval>(const SystemFunctions&,
                                                                              MeanValueForm, int);
template std::unique_ptr<Contractor> make_mean_value_contractor<UnroundedInterval>(const SystemFunctions&,
                                                                                   MeanValueForm, int);

}  // namespace gcslab
