#include "experiments/solving/path_state_json.h"

#include "base/atomic_file.h"
#include "base/error.h"
#include "experiments/solving/result_json.h"

namespace gcslab {
namespace {

constexpr const char* kFormat = "gcslab path 1";

Json to_json(const CurvePoint& point) {
  return {{"v", point.v}, {"tangent", point.tangent}, {"orientation", point.orientation}};
}

CurvePoint point_from(const Json& json) {
  return {json.at("v").get<std::vector<double>>(), json.at("tangent").get<std::vector<double>>(),
          json.at("orientation").get<int>()};
}

Json to_json(const Path& path) {
  Json crossings = Json::array(), branch_points = Json::array();
  for (const Crossing& crossing : path.crossings)
    crossings.push_back({{"v", crossing.v},
                         {"length", crossing.length},
                         {"rank", crossing.rank},
                         {"touching", crossing.is_touching}});
  for (const BranchPoint& point : path.branch_points)
    branch_points.push_back({{"v", point.v}, {"length", point.length}});
  return {{"end", static_cast<int>(path.end)},
          {"last", path.last},
          {"crossings", std::move(crossings)},
          {"branch_points", std::move(branch_points)},
          {"length", path.length},
          {"steps", path.steps},
          {"refused", path.refused}};
}

PathEnd end_from(const Json& json) {
  const int number = json.get<int>();
  if (number < 0 || number > static_cast<int>(PathEnd::budget))
    throw InputError("a path ends in no known way");
  return static_cast<PathEnd>(number);
}

Path path_from(const Json& json) {
  Path path;
  path.end = end_from(json.at("end"));
  path.last = json.at("last").get<std::vector<double>>();
  for (const Json& crossing : json.at("crossings")) {
    path.crossings.push_back({crossing.at("v").get<std::vector<double>>(),
                              crossing.at("length").get<double>(), crossing.at("rank").get<std::size_t>(),
                              crossing.at("touching").get<bool>()});
  }
  for (const Json& point : json.at("branch_points"))
    path.branch_points.push_back(
        {point.at("v").get<std::vector<double>>(), point.at("length").get<double>()});
  path.length = json.at("length").get<double>();
  path.steps = json.at("steps").get<std::uint64_t>();
  path.refused = json.at("refused").get<std::uint64_t>();
  return path;
}

}  // namespace

void write_path_state(const std::filesystem::path& file, const PathIdentity& identity,
                      const PathState& state) {
  Json json = {{"format", kFormat},           {"problem_hash", identity.problem_hash},
               {"method", identity.method},   {"options", identity.options},
               {"path", to_json(state.path)}, {"direction", state.direction},
               {"here", to_json(state.here)}};
  if (state.before) json["before"] = to_json(*state.before);
  json["step"] = state.step;
  json["length"] = state.length;
  json["landmark"] = to_json(state.landmark);
  json["steps_to_next_landmark"] = state.steps_to_next_landmark;
  seal(json);
  write_file_atomically(file, json.dump(1) + "\n");
}

PathState read_path_state(const std::filesystem::path& file, const PathIdentity& identity) {
  const std::string where = file.string();
  try {
    Json json = Json::parse(read_file(file));
    if (json.at("format").get<std::string>() != kFormat)
      throw InputError(where + ": is not a path that --pending wrote");
    const std::string hash = json.at("content_hash").get<std::string>();
    seal(json);
    if (json.at("content_hash").get<std::string>() != hash)
      throw InputError(where + ": was changed after --pending wrote it");
    if (json.at("problem_hash").get<std::string>() != identity.problem_hash)
      throw InputError(where + ": belongs to another problem");
    if (json.at("method").get<std::string>() != identity.method ||
        json.at("options").get<std::string>() != identity.options) {
      throw InputError(where + ": was followed with other options: " + json.at("method").get<std::string>() +
                       " " + json.at("options").get<std::string>());
    }
    PathState state;
    state.path = path_from(json.at("path"));
    state.direction = json.at("direction").get<int>();
    state.here = point_from(json.at("here"));
    if (json.contains("before")) state.before = point_from(json.at("before"));
    state.step = json.at("step").get<double>();
    state.length = json.at("length").get<double>();
    state.landmark = point_from(json.at("landmark"));
    state.steps_to_next_landmark = json.at("steps_to_next_landmark").get<std::uint64_t>();
    return state;
  } catch (const Json::exception& error) {
    throw InputError(where + ": is not a path that --pending wrote (" + error.what() + ")");
  }
}

}  // namespace gcslab
