#include "homotopy/predictor.h"

#include <array>
#include <utility>

namespace gcslab {
namespace {

void go(const std::vector<double>& from, const std::vector<double>& direction, double length,
        std::vector<double>& result) {
  result.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) result[i] = from[i] + length * direction[i];
}

/// The tangent.
class Euler final : public Predictor {
 public:
  explicit Euler(Curve&) {}
  bool predict(const CurvePoint& here, const CurvePoint*, double step, std::vector<double>& result) override {
    go(here.v, here.tangent, step, result);
    return true;
  }
  int order() const override { return 2; }
};

/// The line through the last two points.
class Secant final : public Predictor {
 public:
  explicit Secant(Curve&) {}
  bool predict(const CurvePoint& here, const CurvePoint* before, double step,
               std::vector<double>& result) override {
    go(here.v, here.tangent, step, result);
    if (before == nullptr) return true;
    const double span = distance(before->v, here.v);
    for (std::size_t i = 0; i < here.v.size(); ++i)
      result[i] = here.v[i] + step / span * (here.v[i] - before->v[i]);
    return true;
  }
  int order() const override { return 2; }
};

/// The cubic through the last two points with their tangents.
class Hermite final : public Predictor {
 public:
  explicit Hermite(Curve&) {}
  bool predict(const CurvePoint& here, const CurvePoint* before, double step,
               std::vector<double>& result) override {
    go(here.v, here.tangent, step, result);
    if (before == nullptr) return true;
    const double span = distance(before->v, here.v);
    for (std::size_t i = 0; i < here.v.size(); ++i)
      result[i] = cubic_between(*before, here, span, i).at(1 + step / span);
    return true;
  }
  int order() const override { return 4; }
};

/// The mean of the tangents here and at Euler's point.
class Heun final : public Predictor {
 public:
  explicit Heun(Curve& curve) : tangents_(curve) {}
  bool predict(const CurvePoint& here, const CurvePoint*, double step, std::vector<double>& result) override {
    go(here.v, here.tangent, step, stage_.v);
    if (!tangents_.find(stage_, here.tangent)) return false;
    go(here.v, here.tangent, step / 2, result);
    go(std::vector(result), stage_.tangent, step / 2, result);
    return true;
  }
  int order() const override { return 3; }

 private:
  TangentSolver tangents_;
  CurvePoint stage_;
};

/// The classical method of four slopes.
class RungeKutta final : public Predictor {
 public:
  explicit RungeKutta(Curve& curve) : tangents_(curve) {}
  bool predict(const CurvePoint& here, const CurvePoint*, double step, std::vector<double>& result) override {
    go(here.v, here.tangent, step / 6, result);
    CurvePoint stage{{}, here.tangent};
    for (const auto& [part, weight] : kStages) {
      go(here.v, stage.tangent, part * step, stage.v);
      if (!tangents_.find(stage, here.tangent)) return false;
      for (std::size_t i = 0; i < result.size(); ++i) result[i] += weight * step * stage.tangent[i];
    }
    return true;
  }
  int order() const override { return 5; }

 private:
  static constexpr std::array<std::pair<double, double>, 3> kStages = {
      {{0.5, 1.0 / 3}, {0.5, 1.0 / 3}, {1.0, 1.0 / 6}}};
  TangentSolver tangents_;
};

template <class P>
std::unique_ptr<Predictor> make(Curve& curve) {
  return std::make_unique<P>(curve);
}

}  // namespace

const Registry<PredictorKind>& predictor_registry() {
  static const Registry<PredictorKind> registry(
      "predictor", {{"hermite", "the cubic through the last two points with their tangents", make<Hermite>},
                    {"secant", "the line through the last two points", make<Secant>},
                    {"euler", "the tangent", make<Euler>},
                    {"heun", "the mean of two tangents", make<Heun>},
                    {"runge_kutta", "the classical method of four tangents", make<RungeKutta>}});
  return registry;
}

}  // namespace gcslab
