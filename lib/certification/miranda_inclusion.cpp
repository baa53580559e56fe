// Miranda's theorem (Miranda 1940; equivalent to Brouwer's): continuous g_1 .. g_n on a box have a common
// zero there when each g_i is <= 0 on one of the two faces across variable i and >= 0 on the other. It is
// applied to g = C f, whose zeros are those of f because C is proved nonsingular. On a face g_i is enclosed
// by its mean value form about the middle of the face and by the combination of the natural extensions.

#include "certification/inclusion_maker.h"
#include "certification/preconditioned_form.h"
#include "interval/reverse_operations.h"

namespace gcslab {
namespace {

template <class T>
class MirandaInclusion final : public InclusionTest {
 public:
  MirandaInclusion(const SystemFunctions& functions, int bits)
      : bits_(bits), form_(functions), values_(functions.variables(), NumberTraits<T>::from_interval(0)) {}

  std::optional<Evidence> prove(const Box& box, const ApproximateRoot& approximate) override {
    if (!is_proved_nonsingular(approximate.inverse)) return std::nullopt;
    const typename NumberTraits<T>::Scope scope(bits_);
    if (!form_.evaluate(box, centre_in(box, approximate))) return std::nullopt;
    form_.precondition(approximate.inverse);
    box_.clear();
    for (const Interval& side : box) box_.push_back(NumberTraits<T>::from_interval(side));
    for (std::size_t i = 0; i < box.size(); ++i) {
      const Interval below = on_face(i, box[i].lower, approximate.inverse.row(i));
      const Interval above = on_face(i, box[i].upper, approximate.inverse.row(i));
      const bool changes = (below.upper <= 0 && above.lower >= 0) || (below.lower >= 0 && above.upper <= 0);
      if (!changes) return std::nullopt;
    }
    return Evidence{"miranda", Claim::exists, box, bits_};
  }

 private:
  /// Encloses g_i where x_i = end.
  Interval on_face(std::size_t i, double end, std::span<const double> multipliers) {
    std::vector<T> face = box_;
    std::vector<T> middle = form_.centre();
    face[i] = middle[i] = NumberTraits<T>::from_interval(Interval(end));
    form_.evaluator().values(face, values_);
    const T natural = combination<T>(multipliers, values_);
    form_.evaluator().values(middle, values_);
    T centred = combination<T>(multipliers, values_);
    for (std::size_t j = 0; j < form_.size(); ++j) {
      if (j != i) centred = centred + form_.matrix()(i, j) * form_.offsets()[j];
    }
    return NumberTraits<T>::enclosure(intersection(natural, centred));
  }

  int bits_;
  PreconditionedForm<T> form_;
  std::vector<T> box_, values_;
};

}  // namespace

InclusionTestVariant miranda_inclusion() {
  return {"miranda", "preconditioned equations change sign between opposite faces (Miranda 1940)",
          Claim::exists, &make_inclusion_test<MirandaInclusion>};
}

}  // namespace gcslab
