#pragma once

// Existence and uniqueness of roots by Krawczyk's operator.
//
// Existence: with C nonsingular and S(X, c) the slopes of f from c to the points of X, the operator
//   K(X) = c - C f(c) + (I - C S(X, c)) (X - c)
// contains x - C f(x) for every x in X, so that K(X) in the interior of X proves a root in K(X) (Krawczyk
// 1969, Moore 1977; with slopes: Neumaier 1990, section 5.2). Uniqueness: when the slopes S(U, R) from a box
// R that contains a root to the points of U satisfy ||I - C S|| < 1 in a weighted maximum norm, f(x) = S (x -
// root) vanishes in U at that root alone. The second needs no inclusion, so that U can be far larger than X.

#include <optional>
#include <span>
#include <vector>

#include "certification/newton_iteration.h"
#include "certification/root_certificate.h"
#include "certification/system_functions.h"

namespace gcslab {

template <class T>
class KrawczykCertifier {
 public:
  /// For square systems. `functions` must outlive it. `scales` are the sizes of the variables.
  KrawczykCertifier(const SystemFunctions& functions, std::vector<double> scales, int bits);

  /// Tries to prove that a small box around the approximate root contains exactly one root.
  std::optional<CertifiedRoot> certify(const ApproximateRoot& approximate);

  /// Tries to prove that the box, a little inflated, contains exactly one root; `approximate` is then where
  /// the proof was centred. For boxes so small that Newton's iteration in double sees only rounding errors.
  std::optional<CertifiedRoot> certify_box(const Box& box, ApproximateRoot& approximate);

  /// Makes the uniqueness box of a certified root as large as it finds proof for. `wanted` is the box that it
  /// ought to cover; the scales give the shape beyond that.
  void enlarge_uniqueness(CertifiedRoot& root, const ApproximateRoot& approximate, const Box& wanted);

  /// An upper bound of ||I - C S(candidate, root)|| in the maximum norm weighted by the candidate's sides:
  /// below 1, `candidate` holds no root beside the one in `root`, which it must contain. Infinite when the
  /// equations may be undefined.
  double contraction_norm(const Box& candidate, const Box& root, const Matrix<double>& inverse);

 private:
  std::vector<T> numbers(const Box& box) const;
  /// K(X) as a box; nothing when f may be undefined on X.
  std::optional<Box> image(const Box& x, const ApproximateRoot& approximate);
  std::optional<CertifiedRoot> settled(const Box& x, const Box& k, const ApproximateRoot& approximate);
  /// I - C S for the slopes in slopes_.
  void compute_residual(const Matrix<double>& inverse);

  /// The side with a part of its width and of its variable's size added at both ends.
  Interval inflated(std::size_t variable, const Interval& side, double part) const;

  const SystemFunctions* functions_;
  std::vector<double> scales_;
  int bits_;
  SystemEvaluator<T> evaluator_;
  Matrix<T> slopes_;
  Matrix<T> residual_;
};

}  // namespace gcslab
