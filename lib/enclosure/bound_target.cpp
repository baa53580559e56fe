#include "enclosure/bound_target.h"

#include "base/error.h"
#include "polynomial/recognise.h"

namespace gcslab {

BoundTarget::BoundTarget(std::shared_ptr<ExpressionGraph> graph, Expression function, int variables)
    : graph_(std::move(graph)), function_(function), variables_(variables) {
  Recognition recognition = recognise_polynomial(function, variables);
  if (recognition.polynomial) {
    polynomial_ = std::make_shared<const Polynomial>(std::move(*recognition.polynomial));
  }
  why_no_polynomial_ = recognition.reason;
}

const Polynomial& BoundTarget::polynomial() const {
  if (!polynomial_) throw NotApplicable("takes polynomials only: the function " + why_no_polynomial_);
  return *polynomial_;
}

}  // namespace gcslab
