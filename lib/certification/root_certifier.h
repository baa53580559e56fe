#pragma once

// Certified roots by the theorems that a composition names. What it is given, a guess or a small box, decides
// where it looks; the theorems decide what it says.
//
// A composition joins names by '+': registered inclusion tests (inclusion_test.h), and krawczyk_slopes,
// Krawczyk's operator with slopes (krawczyk_certifier.h). A root is certified when one theorem shows that it
// exists in a box and one that it is alone in that box or a larger one: miranda+elber_kim certifies, each of
// the two alone does not.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "certification/newton_iteration.h"
#include "certification/root_certificate.h"
#include "certification/system_functions.h"

namespace gcslab {

/// For square systems. It belongs to one thread.
class RootCertifier {
 public:
  virtual ~RootCertifier() = default;

  /// Tries to certify a root near the guess, in a uniqueness box as large as it finds proof for; `wanted`,
  /// bounded, is what that ought to cover.
  virtual std::optional<CertifiedRoot> certify(const ApproximateRoot& approximate, const Box& wanted) = 0;
  /// The same for a box so small that Newton's iteration in double sees only rounding errors.
  virtual std::optional<CertifiedRoot> certify_box(const Box& box) = 0;
  /// For a small box in which no root could be certified: evidence of tests that show existence alone that
  /// the box, inflated, contains a root, single or not.
  virtual std::optional<Evidence> prove_existence(const Box& box) = 0;
};

/// The names that a composition may join, and what they stand for in one sentence each.
struct CertifierName {
  std::string name;
  std::string summary;
};
std::vector<CertifierName> certifier_names();

/// Throws InputError, with the nearest name, when the composition is none.
void check_certifier(const std::string& composition);

/// `functions` must outlive it; `scales` are the sizes of the variables. The arithmetic is that of doubles
/// for 53 bits, else MPFR intervals. Throws InputError as above, NotApplicable where a test named alone does
/// not take the system; in a composition such a test is left out.
std::unique_ptr<RootCertifier> make_root_certifier(const std::string& composition,
                                                   const SystemFunctions& functions,
                                                   const std::vector<double>& scales, int bits);

}  // namespace gcslab
