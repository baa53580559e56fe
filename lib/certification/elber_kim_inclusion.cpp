// At most one root, by cones of tangents (Elber and Kim 2001, "Geometric constraint solver using multivariate
// rational spline functions"). Two roots x, y of f in the box give v = x - y with n_i . v = 0 for slopes n_i
// of each equation g_i of C f: v is tangent to every hypersurface g_i = 0 in the wide sense. The normals n_i
// lie in a cone about an axis a_i with half-angle alpha_i, hence v / |v| lies in the slab |a_i . v| <= sin
// alpha_i. When the parallelotope in which the slabs meet lies inside the unit ball, no v is left.
//
// Here the axes are the coordinate axes, to which C turns the normals: the parallelotope is the box with half
// sides sin alpha_i, which is inside the ball when sum sin^2 alpha_i < 1. Variables are scaled to the box. A
// side of width 0 leaves no difference in its variable.

#include <cmath>

#include "certification/inclusion_maker.h"
#include "certification/preconditioned_form.h"

namespace gcslab {
namespace {

template <class T>
class ElberKimInclusion final : public InclusionTest {
 public:
  ElberKimInclusion(const SystemFunctions& functions, int bits) : bits_(bits), form_(functions) {}

  std::optional<Evidence> prove(const Box& box, const ApproximateRoot& approximate) override {
    {
      const typename NumberTraits<T>::Scope scope(bits_);
      if (!form_.evaluate(box, centre_in(box, approximate))) return std::nullopt;
      form_.precondition(approximate.inverse);
    }
    const UpwardRounding upward;
    FastInterval sum(0.0);
    for (std::size_t i = 0; i < box.size(); ++i) {
      if (radius(box[i]) > 0) sum = sum + squared_sine(i, box);
    }
    if (!(sum.upper() < 1)) return std::nullopt;
    return Evidence{"elber_kim", Claim::at_most_one, box, bits_};
  }

 private:
  /// An upper bound of sin^2 of the angle between axis i and the normals of equation i; 1 when that is all it
  /// knows.
  FastInterval squared_sine(std::size_t i, const Box& box) const {
    FastInterval across(0.0);
    for (std::size_t j = 0; j < box.size(); ++j) {
      const Interval entry = NumberTraits<T>::enclosure(form_.matrix()(i, j));
      if (!is_bounded(entry)) return FastInterval(1.0);
      if (j != i) across = across + sqr(FastInterval(magnitude(entry)) * FastInterval(radius(box[j])));
    }
    const double least = mignitude(NumberTraits<T>::enclosure(form_.matrix()(i, i)));
    const double largest = across.upper();
    if (!(least > 0) || !std::isfinite(largest)) return FastInterval(1.0);
    const FastInterval along = sqr(FastInterval(least) * FastInterval(radius(box[i])));
    return FastInterval(largest) / (FastInterval(largest) + along);
  }

  int bits_;
  PreconditionedForm<T> form_;
};

}  // namespace

InclusionTestVariant elber_kim_inclusion() {
  return {"elber_kim",
          "cones of tangents of the preconditioned equations have no common direction "
          "(Elber, Kim 2001)",
          Claim::at_most_one, &make_inclusion_test<ElberKimInclusion>};
}

}  // namespace gcslab
