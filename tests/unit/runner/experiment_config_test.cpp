#include "experiments/runner/experiment_config.h"

#include <gtest/gtest.h>

#include "config_samples.h"
#include "experiments/tasks/catalogue.h"
#include "selftest_task.h"

namespace gcslab {
namespace {

ExperimentConfig parse(const std::string& text) {
  return parse_experiment(text, "c.yaml", selftest_catalogue());
}

std::string refusal(const std::string& text, const Catalogue& catalogue = selftest_catalogue()) {
  try {
    parse_experiment(text, "c.yaml", catalogue);
    return "accepted";
  } catch (const InputError& error) {
    return error.what();
  }
}

std::vector<std::string> labels_of(const ExperimentConfig& config) { return config.axis_values("method"); }

std::string config_with_methods(const std::string& methods) {
  return "experiment: e\ntask: selftest\nproblems: one\nmethods: [" + methods + "]\n";
}

TEST(ExperimentConfig, EverySampleThatIsRightIsAccepted) {
  for (const AcceptedSample& sample : accepted_samples())
    EXPECT_EQ(refusal(sample.text), "accepted") << sample.name;
}

TEST(ExperimentConfig, EveryFaultIsRefusedInOneLineWithItsPlaceAndCause) {
  for (const RefusedSample& sample : refused_samples()) {
    const std::string message = refusal(sample.text);
    EXPECT_NE(message.find(sample.message), std::string::npos) << sample.name << ": " << message;
    EXPECT_TRUE(message.starts_with("c.yaml:")) << sample.name << ": " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << sample.name << ": " << message;
  }
}

TEST(ExperimentConfig, ReadsEveryKey) {
  const ExperimentConfig config = parse(kFullConfig);
  EXPECT_EQ(config.experiment, "tahari-figure-4.5");
  EXPECT_EQ(config.title, "Covers of curves");
  EXPECT_EQ(config.source, "Tahari 2011, figure 4.5");
  EXPECT_EQ(config.axis_values("problem"), (std::vector<std::string>{"one", "three"}));
  EXPECT_EQ(labels_of(config), (std::vector<std::string>{"succeed (answer=42, arithmetic=fast)",
                                                         "succeed (answer=7, arithmetic=slow)", "a nap"}));
  EXPECT_EQ(config.methods[2].options.real("seconds"), 0.01);
  EXPECT_TRUE(config.methods[2].options.flag("heeds_stop"));
  EXPECT_EQ(config.axis_values("depth"), (std::vector<std::string>{"6", "8"}));
  EXPECT_EQ(config.axis_values("split"), std::vector<std::string>{"alternate"});
  EXPECT_EQ(config.axis_values("cell_size"), std::vector<std::string>{"0.5"});
  EXPECT_EQ(config.seeds, (std::vector<std::uint64_t>{1, 2}));
  EXPECT_EQ(config.repetitions, 5);
  EXPECT_EQ(config.limits, (Limits{60, 30.5, 2000}));
}

TEST(ExperimentConfig, ReadsRangesOfSeeds) {
  const ExperimentConfig config =
      parse("experiment: e\ntask: selftest\nproblems: one\nmethods: {name: succeed}\nseeds: [7, 1..3]\n");
  EXPECT_EQ(config.seeds, (std::vector<std::uint64_t>{7, 1, 2, 3}));
}

TEST(ExperimentConfig, ReadsTablesAndFigures) {
  const ExperimentConfig config = parse(kFullConfig);
  ASSERT_EQ(config.report.size(), 3U);
  const ReportItem& table = config.report[0];
  EXPECT_EQ(table.form, ReportItem::Form::table);
  EXPECT_EQ(table.columns, (std::vector<std::string>{"method", "depth"}));
  EXPECT_EQ(table.values, (std::vector<std::string>{"answer", "wall_s"}));
  EXPECT_EQ(table.best, "min");
  EXPECT_EQ(table.filter.at("depth"), std::vector<std::string>{"8"});
  EXPECT_EQ(config.report[1].values, std::vector<std::string>{"wall_s/answer"});
  EXPECT_EQ(config.report[1].options.at("relative_to").text, "succeed");
  const ReportItem& figure = config.report[2];
  EXPECT_EQ(figure.form, ReportItem::Form::figure);
  EXPECT_EQ(figure.kind, "cover_panels");
  EXPECT_EQ(figure.options.at("curve").text, "true");
  EXPECT_EQ(figure.options.at("curve").where.text(), "c.yaml:19");
  EXPECT_EQ(figure.options.size(), 1U);
}

TEST(ExperimentConfig, LabelsNameOnlyTheOptionsThatDiffer) {
  EXPECT_EQ(labels_of(parse(config_with_methods("{name: succeed}, {name: sleep}"))),
            (std::vector<std::string>{"succeed", "sleep"}));
  EXPECT_EQ(labels_of(parse(config_with_methods("{name: succeed, options: {answer: 7}}"))),
            std::vector<std::string>{"succeed"});
  EXPECT_EQ(labels_of(parse(config_with_methods("{name: succeed, options: {scale: 2}}, {name: succeed}"))),
            (std::vector<std::string>{"succeed (scale=2)", "succeed (scale=1)"}));
}

TEST(ExperimentConfig, AFaultOfTheReportingRoomIsRefusedBeforeAnyJob) {
  Catalogue catalogue = selftest_catalogue();
  catalogue.check_report_item = [](const ReportItem& item) {
    for (const auto& [name, value] : item.options) throw InputError(value.where, "no option " + name);
  };
  const std::string start =
      config_with_methods("{name: succeed}") + "report:\n  - figure: {file: a, kind: k, ";
  EXPECT_EQ(refusal(start + "curve: true}\n", catalogue), "c.yaml:6: no option curve");
  EXPECT_EQ(refusal(start + "captoin: x}\n", catalogue),
            "c.yaml:6: unknown key 'captoin' (did you mean 'caption'?)");
}

TEST(ExperimentConfig, AMissingFileIsAnInputError) {
  EXPECT_THROW(load_experiment("/no/such/config.yaml", selftest_catalogue()), InputError);
}

}  // namespace
}  // namespace gcslab
