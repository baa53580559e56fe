// Krawczyk's test on a given box X: with J the slopes between points of X and c in X,
//   K(X) = c - C f(c) + (I - C J) (X - c) in the interior of X
// proves exactly one root in X. Existence: x - C f(x) maps X into K(X) (Krawczyk 1969, Moore 1977).
// Uniqueness: side i of K(X) is at least sum_j |I - C S|_ij w_j wide for every S in J, w the widths of X, so
// that
// ||I - C S|| < 1 in the norm weighted by w; hence C and every S are nonsingular.

#include "certification/inclusion_maker.h"
#include "certification/preconditioned_form.h"

namespace gcslab {
namespace {

template <class T>
class KrawczykInclusion final : public InclusionTest {
 public:
  KrawczykInclusion(const SystemFunctions& functions, int bits) : bits_(bits), form_(functions) {}

  std::optional<Evidence> prove(const Box& box, const ApproximateRoot& approximate) override {
    const typename NumberTraits<T>::Scope scope(bits_);
    if (!form_.evaluate(box, centre_in(box, approximate))) return std::nullopt;
    form_.precondition(approximate.inverse);
    for (std::size_t i = 0; i < box.size(); ++i) {
      if (!is_strictly_inside(NumberTraits<T>::enclosure(image(i)), box[i])) return std::nullopt;
    }
    return Evidence{"krawczyk", Claim::unique, box, bits_};
  }

 private:
  T image(std::size_t i) const {
    T sum = form_.centre()[i] - form_.values()[i];
    for (std::size_t j = 0; j < form_.size(); ++j) {
      const T identity = NumberTraits<T>::from_interval(Interval(i == j ? 1 : 0));
      sum = sum + (identity - form_.matrix()(i, j)) * form_.offsets()[j];
    }
    return sum;
  }

  int bits_;
  PreconditionedForm<T> form_;
};

}  // namespace

InclusionTestVariant krawczyk_inclusion() {
  return {"krawczyk", "Krawczyk's operator maps the box into its interior (Krawczyk 1969, Moore 1977)",
          Claim::unique, &make_inclusion_test<KrawczykInclusion>};
}

}  // namespace gcslab
