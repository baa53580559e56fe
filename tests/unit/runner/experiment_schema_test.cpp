// configs/schema/experiment.schema.json, which editors use, against the loader, which decides.

#include <charconv>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "base/atomic_file.h"
#include "base/yaml_reader.h"
#include "config_samples.h"

namespace gcslab {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

json scalar_json(const YamlNode& node) {
  const std::string text = node.text();
  if (node.is_quoted()) return text;
  if (text == "true" || text == "false") return text == "true";
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return text;
  return json::parse(text, nullptr, false).is_number_integer() ? json::parse(text) : json(number);
}

/// The document as an editor's YAML reader passes it to a schema.
json to_json(const YamlNode& node) {
  json result;
  if (node.is_list()) {
    result = json::array();
    for (const YamlNode& item : node.items()) result.push_back(to_json(item));
  } else if (node.is_map()) {
    result = json::object();
    for (const auto& [key, value] : node.entries()) result[key] = to_json(value);
  } else if (node.is_scalar()) {
    result = scalar_json(node);
  }
  return result;
}

class ExperimentSchema : public testing::Test {
 protected:
  ExperimentSchema() {
    const fs::path file = fs::path(GCSLAB_SOURCE_DIR) / "configs/schema/experiment.schema.json";
    const json document = json::parse(read_file(file));
    valijson::SchemaParser(valijson::SchemaParser::kDraft7)
        .populateSchema(valijson::adapters::NlohmannJsonAdapter(document), schema_);
  }

  bool accepts(const json& document) const {
    valijson::Validator validator;
    return validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(document), nullptr);
  }

  bool accepts_text(const std::string& text) const {
    return accepts(text.empty() ? json(nullptr) : to_json(YamlNode::parse(text, "c.yaml")));
  }

 private:
  valijson::Schema schema_;
};

TEST_F(ExperimentSchema, AcceptsWhatTheLoaderAccepts) {
  for (const AcceptedSample& sample : accepted_samples())
    EXPECT_TRUE(accepts_text(sample.text)) << sample.name;
}

TEST_F(ExperimentSchema, RefusesEveryFaultOfShape) {
  for (const RefusedSample& sample : refused_samples()) {
    if (!sample.by_schema) continue;
    EXPECT_FALSE(accepts_text(sample.text)) << sample.name;
  }
}

TEST_F(ExperimentSchema, LeavesNamesToTheLoader) {
  for (const RefusedSample& sample : refused_samples()) {
    const bool is_readable = sample.name != "not_yaml" && sample.name != "duplicate_key";
    if (sample.by_schema || !is_readable) continue;
    EXPECT_TRUE(accepts_text(sample.text)) << sample.name;
  }
}

TEST_F(ExperimentSchema, AcceptsEveryConfigThatIsShipped) {
  for (const char* folder : {"configs/paper", "configs/study"}) {
    const fs::path path = fs::path(GCSLAB_SOURCE_DIR) / folder;
    if (!fs::exists(path)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path)) {
      if (entry.path().extension() != ".yaml") continue;
      EXPECT_TRUE(accepts(to_json(YamlNode::load_file(entry.path())))) << entry.path();
    }
  }
}

}  // namespace
}  // namespace gcslab
