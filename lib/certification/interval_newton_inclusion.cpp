// The interval Newton test on a given box X: with J the slopes between points of X, c in X, A = C J and
// g = C f, the set N_i = c_i - (g_i(c) + sum_{j != i} A_ij (X_j - c_j)) / A_ii, 0 not in A_ii, in the
// interior of X_i for all i proves exactly one root in X (Hansen and Sengupta 1981, Neumaier 1990
// section 5.1).
//
// Existence: say A_ii > 0. For x with x_i at the upper end of X_i, g_i(x) = g_i(c) + sum_j S_ij (x_j - c_j)
// for some S in A, which is positive because N_i lies below that end; likewise it is negative at the lower
// end, so that Miranda's theorem gives a zero of C f. Uniqueness: N_i is at least sum_{j != i} |S_ij / S_ii|
// w_j wide for every S in A and narrower than w_i, so that S is strictly diagonally dominant in the scale w,
// hence nonsingular, and C with it.

#include "certification/inclusion_maker.h"
#include "certification/preconditioned_form.h"

namespace gcslab {
namespace {

template <class T>
class IntervalNewtonInclusion final : public InclusionTest {
 public:
  IntervalNewtonInclusion(const SystemFunctions& functions, int bits) : bits_(bits), form_(functions) {}

  std::optional<Evidence> prove(const Box& box, const ApproximateRoot& approximate) override {
    const typename NumberTraits<T>::Scope scope(bits_);
    if (!form_.evaluate(box, centre_in(box, approximate))) return std::nullopt;
    form_.precondition(approximate.inverse);
    for (std::size_t i = 0; i < box.size(); ++i) {
      if (contains(NumberTraits<T>::enclosure(form_.matrix()(i, i)), 0)) return std::nullopt;
      if (!is_strictly_inside(NumberTraits<T>::enclosure(image(i)), box[i])) return std::nullopt;
    }
    return Evidence{"interval_newton", Claim::unique, box, bits_};
  }

 private:
  T image(std::size_t i) const {
    T sum = form_.values()[i];
    for (std::size_t j = 0; j < form_.size(); ++j) {
      if (j != i) sum = sum + form_.matrix()(i, j) * form_.offsets()[j];
    }
    return form_.centre()[i] - sum / form_.matrix()(i, i);
  }

  int bits_;
  PreconditionedForm<T> form_;
};

}  // namespace

InclusionTestVariant interval_newton_inclusion() {
  return {"interval_newton",
          "the interval Newton operator maps the box into its interior (Hansen, Sengupta 1981)",
          Claim::unique, &make_inclusion_test<IntervalNewtonInclusion>};
}

}  // namespace gcslab
