#pragma once

// Proof that a path stays on one curve: a chain of tubes, each of which holds one arc.
//
// A tube around c + s u, s in an interval S, is the set of c + s u + y with y in a box Y and u.y = 0.
// Krawczyk's operator in y, with s as a parameter, maps Y into its interior: then for each s there is exactly
// one y with H(c + s u + y) = 0, and it depends smoothly on s (Kearfott, Xing 1994; van der Hoeven 2015;
// Guillemot, Lairez 2024). Tubes are linked by boxes that hold one point of the curve and lie in both. All of
// it in outward rounded arithmetic.

#include <cstdint>
#include <optional>

#include "homotopy/corrector.h"
#include "homotopy/interval_curve.h"

namespace gcslab {

class PathCertifier {
 public:
  /// Both are the same curve and must outlive it.
  PathCertifier(Curve& curve, IntervalCurve& enclosure);

  /// Takes `point` for the place to begin, and encloses the curve's point there. False where that fails, as
  /// where the Jacobian has no full rank.
  bool begin(const CurvePoint& point);
  /// Goes on from another point, with nothing proved of what lies between.
  bool go_on_from(const CurvePoint& point);

  /// What is proved of an arc.
  struct Arc {
    std::uint64_t crossings = 0;    ///< of t = 1, exactly
    bool passes_beginning = false;  ///< the point of `begin` is on it
  };
  /// Proves that the curve leads from the last point to the one near `next`, which is the last one from then
  /// on. Nothing, and no change, where the tubes become too
  /// short or the arc longer than twice the distance.
  std::optional<Arc> follow(const CurvePoint& next);

  std::uint64_t tubes() const { return tubes_; }  ///< so far

 private:
  using Number = FastInterval;
  using Vector = std::vector<FastInterval>;

  /// Around a point, as the class says.
  struct Tube {
    Number s;
    Vector y;
    Number t;        ///< all values of t in it
    Number t_speed;  ///< of t by s along the arc; everything where that is not known
  };

  bool improve(CurvePoint& point);
  bool prepare(const CurvePoint& at);
  bool compute_residual(const Vector& box, const std::vector<double>& u);
  bool maps_inside(const Vector& shift, const Vector& y, Vector& image) const;
  Vector preconditioned(const Vector& values, const Number& last) const;
  std::optional<Tube> tube(const CurvePoint& at, double length);
  Number speed_of_t(const std::vector<double>& u) const;
  std::optional<Vector> enclosed(const CurvePoint& at, const std::vector<double>& guess, double s);
  Number height(const CurvePoint& at, const Vector& box) const;
  bool contains(const Tube& tube, const CurvePoint& at, const Vector& box) const;
  std::optional<std::uint64_t> crossings(const Tube& tube, const Vector& from, const Vector& to) const;

  Curve* curve_;
  IntervalCurve* enclosure_;
  std::size_t n_;
  Corrector corrector_;
  TangentSolver tangents_;
  CurvePoint at_;            ///< near the last point
  Vector last_, beginning_;  ///< each encloses one point of the curve
  double length_ = 0.1;      ///< of the last tube
  Matrix<double> inverse_;   ///< about that of (J; u) at the centre of the tube
  Matrix<Number> jacobian_;  ///< over the last box
  Matrix<Number> residual_;  ///< I - inverse (jacobian; u)
  Vector values_;
  std::uint64_t tubes_ = 0;
};

}  // namespace gcslab
