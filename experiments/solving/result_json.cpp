#include "experiments/solving/result_json.h"

#include <cmath>
#include <cstdlib>
#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/content_hash.h"
#include "base/error.h"
#include "expression/differentiate.h"
#include "interval/rounding.h"

namespace gcslab {
namespace {

constexpr const char* kPendingFormat = "gcslab-pending 1";

std::string number_text(double value) { return fmt::format("{:a}", value + 0.0); }

double number_from(const Json& json, const std::string& where) {
  if (json.is_string()) {
    const std::string text = json.get<std::string>();
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (!text.empty() && *end == '\0' && !std::isnan(value)) return value;
  }
  throw InputError(where + ": expected a number as a string, found " + json.dump());
}

std::string mpfr_text(mpfr_srcptr value) {
  char* text = nullptr;
  if (mpfr_asprintf(&text, "%Ra", value) < 0) throw std::bad_alloc();
  std::string result = text;
  mpfr_free_str(text);
  return result;
}

double residual(const SystemFunctions& functions, const std::vector<double>& point) {
  const NearestRounding nearest;
  SystemEvaluator<double> evaluator(functions);
  std::vector<double> values(functions.equations().size());
  evaluator.values(point, values);
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::fabs(value));
  return largest;
}

Json evidence_json(const CertifiedRoot& root) {
  Json list = Json::array();
  for (const Evidence& evidence : root.evidence) {
    list.push_back({{"type", evidence.type},
                    {"claim", std::string(name_of(evidence.claim))},
                    {"box", box_to_json(evidence.box)},
                    {"bits", evidence.bits}});
  }
  return list;
}

void add_digits(Json& entry, const SystemFunctions& functions, const CertifiedRoot& root, int bits) {
  const RefinedRoot refined = refine_root(functions, root, bits);
  const int digits = static_cast<int>(std::floor(bits * std::log10(2.0)));
  Json decimal = Json::array();
  Json box = Json::array();
  for (const MpfrInterval& side : refined.box) {
    decimal.push_back(decimal_text(side, digits));
    box.push_back({mpfr_text(side.lower()), mpfr_text(side.upper())});
  }
  entry["decimal"] = std::move(decimal);
  entry["refined_box"] = std::move(box);
  entry["refined_bits"] = refined.bits;
  entry["refined_reached"] = refined.reached;
}

/// A root of multiplicity m of a polynomial in one variable is a simple one of its derivative of order m - 1.
SystemFunctions with_simple_root(const SystemFunctions& functions, const CertifiedRoot& root) {
  EquationSystem system = functions.system();
  for (int order = 1; order < root.multiplicity; ++order)
    system.equations[0] = differentiate(system.equations[0], 0);
  return SystemFunctions(std::move(system));
}

/// What a proof of uniqueness says beside the claim, or that there is none.
void add_isolation(Json& entry, const Solution& solution) {
  if (solution.claim != Claim::unique) {
    entry["isolated"] = "unknown";
    return;
  }
  entry["uniqueness_box"] = box_to_json(solution.root.uniqueness_box);
  entry["multiplicity"] = solution.root.multiplicity;
  entry["isolated"] = "proved";
}

Json solution_json(const SystemFunctions& functions, const Solution& solution, int bits) {
  std::vector<double> point;
  for (const Interval& side : solution.root.box) point.push_back(midpoint(side));
  Json entry = {
      {"point", point},
      {"box", box_to_json(solution.root.box)},
      {"kind", "real"},
      {"residual", residual(functions, point)},
      {"certificate",
       {{"claim", std::string(name_of(solution.claim))}, {"evidence", evidence_json(solution.root)}}}};
  add_isolation(entry, solution);
  if (!functions.inequalities().empty()) {
    entry["inequalities"] = solution.inequalities == InequalityState::proved ? "proved" : "undecided";
  }
  if (bits > 53 && solution.claim == Claim::unique)
    add_digits(entry, with_simple_root(functions, solution.root), solution.root, bits);
  return entry;
}

Json root_json(const CertifiedRoot& root) {
  return {{"box", box_to_json(root.box)},
          {"uniqueness_box", box_to_json(root.uniqueness_box)},
          {"evidence", evidence_json(root)}};
}

Claim claim_from(const std::string& name, const std::string& where) {
  for (const Claim claim : {Claim::unique, Claim::exists, Claim::at_most_one, Claim::none}) {
    if (name_of(claim) == name) return claim;
  }
  throw InputError(where + ": '" + name + "' is no claim");
}

CertifiedRoot root_from_json(const Json& json, const std::string& where) {
  CertifiedRoot root{
      box_from_json(json.at("box"), where), box_from_json(json.at("uniqueness_box"), where), {}};
  for (const Json& item : json.at("evidence")) {
    root.evidence.push_back({item.at("type").get<std::string>(),
                             claim_from(item.at("claim").get<std::string>(), where),
                             box_from_json(item.at("box"), where), item.at("bits").get<int>()});
  }
  return root;
}

}  // namespace

Json box_to_json(const Box& box) {
  Json sides = Json::array();
  for (const Interval& side : box) sides.push_back({number_text(side.lower), number_text(side.upper)});
  return sides;
}

Box box_from_json(const Json& json, const std::string& where) {
  Box box;
  for (const Json& side : json) {
    if (!side.is_array() || side.size() != 2)
      throw InputError(where + ": expected [\"lower\", \"upper\"], found " + side.dump());
    const double lower = number_from(side[0], where);
    const double upper = number_from(side[1], where);
    if (!(lower <= upper)) throw InputError(where + ": an interval is empty: " + side.dump());
    box.emplace_back(lower, upper);
  }
  return box;
}

Json solutions_json(const SystemFunctions& functions, const SearchResult& result, int bits) {
  Json list = Json::array();
  for (const Solution& solution : result.solutions) list.push_back(solution_json(functions, solution, bits));
  return list;
}

Json undecided_json(const SearchResult& result) {
  Json list = Json::array();
  for (const UndecidedBox& entry : result.undecided)
    list.push_back({{"box", box_to_json(entry.box)}, {"reason", entry.reason}});
  for (const Box& box : result.pending)
    list.push_back({{"box", box_to_json(box)}, {"reason", "not searched when the budget ended"}});
  return list;
}

void write_pending(const std::filesystem::path& path, const std::string& problem_hash, const Box& search_box,
                   const SearchResult& result) {
  Json file = {
      {"format", kPendingFormat}, {"problem_hash", problem_hash}, {"search_box", box_to_json(search_box)}};
  file["boxes"] = Json::array();
  for (const Box& box : result.pending) file["boxes"].push_back(box_to_json(box));
  file["roots"] = Json::array();
  for (const CertifiedRoot& root : result.roots) file["roots"].push_back(root_json(root));
  file["undecided"] = Json::array();
  for (const UndecidedBox& entry : result.undecided)
    file["undecided"].push_back({{"box", box_to_json(entry.box)}, {"reason", entry.reason}});
  seal(file);
  write_file_atomically(path, file.dump(1) + "\n");
}

SearchStart read_pending(const std::filesystem::path& path, const std::string& problem_hash,
                         const Box& search_box) {
  const std::string where = path.string();
  try {
    Json file = Json::parse(read_file(path));
    if (file.at("format").get<std::string>() != kPendingFormat)
      throw InputError(where + ": is not a file that --pending wrote");
    const std::string hash = file.at("content_hash").get<std::string>();
    seal(file);
    if (file.at("content_hash").get<std::string>() != hash)
      throw InputError(where + ": was changed after --pending wrote it");
    if (file.at("problem_hash").get<std::string>() != problem_hash ||
        box_from_json(file.at("search_box"), where) != search_box) {
      throw InputError(where + ": belongs to another problem or another box");
    }
    SearchStart start;
    for (const Json& box : file.at("boxes")) start.boxes.push_back(box_from_json(box, where));
    for (const Json& root : file.at("roots")) start.roots.push_back(root_from_json(root, where));
    for (const Json& entry : file.at("undecided"))
      start.undecided.push_back(
          {box_from_json(entry.at("box"), where), entry.at("reason").get<std::string>()});
    return start;
  } catch (const Json::exception& error) {
    throw InputError(where + ": is not a file that --pending wrote (" + error.what() + ")");
  }
}

void seal(Json& result) {
  result.erase("content_hash");
  result["content_hash"] = content_hash(nlohmann::json(result).dump());
}

}  // namespace gcslab
