#include "base/outcome.h"

#include <array>
#include <utility>

#include "base/error.h"

namespace gcslab {
namespace {

constexpr std::array<std::pair<Status, std::string_view>, 7> kStatusNames = {{
    {Status::complete, "complete"},
    {Status::partial, "partial"},
    {Status::budget_exhausted, "budget_exhausted"},
    {Status::not_applicable, "not_applicable"},
    {Status::failed, "failed"},
    {Status::out_of_memory, "out_of_memory"},
    {Status::crashed, "crashed"},
}};

}  // namespace

std::string_view name_of(Status status) {
  for (const auto& [value, name] : kStatusNames) {
    if (value == status) return name;
  }
  return "failed";
}

Status status_from_name(std::string_view name) {
  for (const auto& [value, known] : kStatusNames) {
    if (known == name) return value;
  }
  throw InputError("unknown status '" + std::string(name) + "'");
}

std::string_view name_of(Promise promise) { return promise == Promise::rigorous ? "rigorous" : "baseline"; }

}  // namespace gcslab
