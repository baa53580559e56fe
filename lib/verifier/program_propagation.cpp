// Forward-backward propagation through a program.

#include "base/check.h"
#include "verifier/program.h"
#include "verifier/projection.h"

namespace gcslab::verifier {

bool Program::propagate(std::span<const Range> box, const Range& target) {
  forward(box);
  const Range value = intersection(values_.back(), target);
  if (!replace(static_cast<std::uint32_t>(nodes_.size() - 1), value)) return false;
  for (std::size_t place = nodes_.size(); place-- > 0;) {
    const Range z = values_[place];
    if (!narrow_operands(nodes_[place], z)) return false;
  }
  return true;
}

/// Stores a narrowed operand; false when nothing is left of it. Constants keep their enclosure for the next
/// box.
bool Program::replace(std::uint32_t place, const Range& value) {
  if (!is_constant(place)) values_[place] = value;
  return !value.is_empty();
}

/// Cuts the operands of z = op(a, b) down to what z leaves of them. The second operand's projection uses the
/// first one as just narrowed.
bool Program::narrow_operands(const Node& node, const Range& z) {
  switch (info(node.operation).operands) {
    case 0:
      return true;
    case 1:
      return replace(node.a, narrowed_operand(node, z));
    default:
      return replace(node.a, narrowed_first(node, z)) && replace(node.b, narrowed_second(node, z));
  }
}

Range Program::narrowed_first(const Node& node, const Range& z) const {
  const Range& a = values_[node.a];
  const Range& b = values_[node.b];
  switch (node.operation) {
    case Operation::add:
      return intersection(a, z - b);
    case Operation::subtract:
      return intersection(a, z + b);
    case Operation::multiply:
      return project_factor(z, b, a);
    case Operation::divide:
      return intersection(z * b, a);
    case Operation::min:
      return project_min(z, b, a);
    case Operation::max:
      return -project_min(-z, -b, -a);
    default:
      GCSLAB_CHECK(false);
  }
}

Range Program::narrowed_second(const Node& node, const Range& z) const {
  const Range& a = values_[node.a];
  const Range& b = values_[node.b];
  switch (node.operation) {
    case Operation::add:
      return intersection(b, z - a);
    case Operation::subtract:
      return intersection(b, a - z);
    case Operation::multiply:
      return project_factor(z, a, b);
    case Operation::divide:
      return project_factor(a, z, b);
    case Operation::min:
      return project_min(z, a, b);
    case Operation::max:
      return -project_min(-z, -a, -b);
    default:
      GCSLAB_CHECK(false);
  }
}

Range Program::narrowed_operand(const Node& node, const Range& z) const {
  const Range& a = values_[node.a];
  switch (node.operation) {
    case Operation::negate:
      return intersection(a, -z);
    case Operation::sqr:
      return project_sqr(z, a);
    case Operation::power_integer:
    case Operation::power_rational:
      return project_power(z, node.exponent, a);
    case Operation::sqrt:
      return project_sqrt(z, a);
    case Operation::cbrt:
      return intersection(power(z, 3), a);
    case Operation::exp:
      return intersection(log(z), a);
    case Operation::log:
      return intersection(exp(z), a);
    case Operation::sin:
      return project_sin(z, a);
    case Operation::cos:
      return project_cos(z, a);
    case Operation::tan:
      return project_tan(z, a);
    case Operation::asin:
      return project_asin(z, a);
    case Operation::acos:
      return project_acos(z, a);
    case Operation::atan:
      return project_atan(z, a);
    case Operation::abs:
      return project_abs(z, a);
    default:
      GCSLAB_CHECK(false);
  }
}

}  // namespace gcslab::verifier
