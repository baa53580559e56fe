#include "geometry/sort.h"

#include <algorithm>

namespace gcslab {
namespace {

std::vector<CoordinateName> names(Universe universe, const std::vector<std::pair<std::string, Role>>& roles) {
  std::vector<CoordinateName> result;
  for (const auto& [prefix, role] : roles) {
    if (role == Role::offset || role == Role::radius) {
      result.push_back({prefix, role});
      continue;
    }
    for (std::size_t axis = 0; axis < dimension(universe); ++axis)
      result.push_back({prefix + "xyz"[axis], role});
  }
  return result;
}

std::vector<CoordinateName> names_of(Sort sort, Universe universe) {
  const bool is_plane = universe == Universe::plane;
  switch (sort) {
    case Sort::point:
      return names(universe, {{"", Role::position}});
    case Sort::line:
      return is_plane ? names(universe, {{"n", Role::direction}, {"d", Role::offset}})
                      : names(universe, {{"", Role::position}, {"u", Role::direction}});
    case Sort::plane:
      return names(universe, {{"n", Role::direction}, {"d", Role::offset}});
    case Sort::circle:
      return is_plane ? names(universe, {{"", Role::position}, {"r", Role::radius}})
                      : names(universe, {{"", Role::position}, {"n", Role::direction}, {"r", Role::radius}});
    case Sort::sphere:
      return names(universe, {{"", Role::position}, {"r", Role::radius}});
  }
  return {};
}

}  // namespace

const std::vector<Sort>& all_sorts() {
  static const std::vector<Sort> all = {Sort::point, Sort::line, Sort::plane, Sort::circle, Sort::sphere};
  return all;
}

std::string name_of(Sort sort) {
  switch (sort) {
    case Sort::point:
      return "point";
    case Sort::line:
      return "line";
    case Sort::plane:
      return "plane";
    case Sort::circle:
      return "circle";
    case Sort::sphere:
      return "sphere";
  }
  return {};
}

bool exists_in(Sort sort, Universe universe) {
  return universe == Universe::space || (sort != Sort::plane && sort != Sort::sphere);
}

std::string text_of(const std::vector<Sort>& sorts) {
  std::vector<std::string> texts;
  for (auto first = sorts.begin(); first != sorts.end();) {
    const auto next = std::find_if(first, sorts.end(), [&](Sort sort) { return sort != *first; });
    const auto count = next - first;
    texts.push_back(count == 1 ? "a " + name_of(*first)
                               : std::to_string(count) + " " + name_of(*first) + "s");
    first = next;
  }
  std::string text;
  for (const std::string& each : texts) {
    if (!text.empty()) text += &each == &texts.back() ? " and " : ", ";
    text += each;
  }
  return text.empty() ? "nothing" : text;
}

const std::vector<CoordinateName>& coordinate_names(Sort sort, Universe universe) {
  static const auto table = [] {
    std::vector<std::vector<CoordinateName>> result;
    for (const Universe each : {Universe::plane, Universe::space}) {
      for (const Sort of : all_sorts()) result.push_back(names_of(of, each));
    }
    return result;
  }();
  return table[static_cast<std::size_t>(universe) * all_sorts().size() + static_cast<std::size_t>(sort)];
}

}  // namespace gcslab
