#include "certification/point_certifier.h"

#include <algorithm>
#include <cmath>

namespace gcslab {
namespace {

constexpr int kBits = 53;
constexpr double kRadius = 1e-6;

std::vector<double> unit_scales(const SystemFunctions& functions) {
  return std::vector<double>(functions.variables(), 1.0);
}

}  // namespace

PointCertifier::PointCertifier(const SystemFunctions& functions, const std::string& certifier)
    : newton_(functions, unit_scales(functions)),
      certifier_(make_root_certifier(certifier, functions, unit_scales(functions), kBits)) {}

std::optional<CertifiedRoot> PointCertifier::certify(std::span<const double> point) {
  Box around;
  for (const double x : point) {
    const double reach = kRadius * std::max(std::abs(x), 1.0);
    around.emplace_back(x - reach, x + reach);
  }
  const std::optional<ApproximateRoot> approximate = newton_.run(around);
  return approximate ? certifier_->certify(*approximate, around) : std::nullopt;
}

}  // namespace gcslab
