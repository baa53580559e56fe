#pragma once

// Certificates of roots that a method in plain doubles, such as a path tracker, has found.

#include <optional>
#include <span>
#include <string>

#include "certification/root_certifier.h"

namespace gcslab {

class PointCertifier {
 public:
  /// For square systems. `functions` must outlive it; `certifier` joins names of theorems and throws as
  /// make_root_certifier does.
  PointCertifier(const SystemFunctions& functions, const std::string& certifier);

  /// The root that Newton's iteration finds within a millionth of the point's size, certified; nothing where
  /// it finds none or no theorem applies, as where the Jacobian is singular.
  std::optional<CertifiedRoot> certify(std::span<const double> point);

 private:
  NewtonIteration newton_;
  std::unique_ptr<RootCertifier> certifier_;
};

}  // namespace gcslab
