#include "experiments/solving/search_picture_json.h"

#include "base/error.h"

namespace gcslab {
namespace {

using Json = nlohmann::ordered_json;

Json sides_json(const Box& box) {
  Json sides = Json::array();
  for (const Interval& side : box) sides.push_back({side.lower, side.upper});
  return sides;
}

Box sides_from(const Json& json) {
  Box box;
  for (const Json& side : json) box.emplace_back(side.at(0).get<double>(), side.at(1).get<double>());
  return box;
}

Json recorded_json(const RecordedBox& box) {
  Json stages = Json::array();
  for (const Box& stage : box.stages) stages.push_back(sides_json(stage));
  Json json = {{"fate", std::string(name_of(box.fate))}, {"stages", stages}, {"reductions", box.reductions}};
  if (box.fate == BoxFate::empty) json["reason"] = std::string(name_of(box.reason));
  return json;
}

RecordedBox recorded_from(const Json& json) {
  RecordedBox box;
  box.fate = box_fate_from_name(json.at("fate").get<std::string>());
  for (const Json& stage : json.at("stages")) box.stages.push_back(sides_from(stage));
  if (box.stages.empty()) throw InputError("a recorded box without stages");
  box.reductions = json.at("reductions").get<int>();
  return box;
}

}  // namespace

SearchPicture search_picture(const Box& domain, const SearchRecord& record, const SearchResult& result) {
  SearchPicture picture{domain, record.boxes(), record.told(), {}};
  for (const Solution& solution : result.solutions) {
    std::vector<double> point;
    for (const Interval& side : solution.root.box) point.push_back(midpoint(side));
    picture.roots.push_back(std::move(point));
  }
  return picture;
}

Json to_json(const SearchPicture& picture) {
  Json boxes = Json::array();
  for (const RecordedBox& box : picture.boxes) boxes.push_back(recorded_json(box));
  return {{"search",
           {{"domain", sides_json(picture.domain)},
            {"told", picture.told},
            {"roots", picture.roots},
            {"boxes", std::move(boxes)}}}};
}

SearchPicture search_picture_from_json(const Json& json) {
  try {
    const Json& search = json.at("search");
    SearchPicture picture;
    picture.domain = sides_from(search.at("domain"));
    picture.told = search.at("told").get<std::uint64_t>();
    picture.roots = search.at("roots").get<std::vector<std::vector<double>>>();
    for (const Json& box : search.at("boxes")) picture.boxes.push_back(recorded_from(box));
    return picture;
  } catch (const Json::exception& error) {
    throw InputError(std::string("not the boxes of a search: ") + error.what());
  }
}

}  // namespace gcslab
