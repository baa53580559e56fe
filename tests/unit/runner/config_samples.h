#pragma once

// Configs that are right, and configs that are wrong in one place, for the loader and for the JSON Schema.

#include <string>
#include <vector>

namespace gcslab {

struct AcceptedSample {
  std::string name;
  std::string text;
};

struct RefusedSample {
  std::string name;
  std::string text;
  std::string message;  ///< what the error says, from the file's name on
  bool by_schema;       ///< the shape is wrong, not only a name: the schema refuses it too
};

inline const char* const kFullConfig = R"(experiment: tahari-figure-4.5
title: Covers of curves
source: "Tahari 2011, figure 4.5"
task: selftest
problems: [one, suite:odd]
methods:
  - {name: succeed}
  - {name: succeed, options: {arithmetic: slow, answer: 7}}
  - name: sleep
    label: a nap
    options: {seconds: 0.01}
parameters: {depth: [6, 8], split: alternate}
seeds: [1, 2]
repetitions: 5
limits: {wall_s: 60, cpu_s: 30.5, memory_mb: 2000}
report:
  - table: {file: cells, rows: problem, columns: [method, depth], values: [answer, wall_s], best: min, filter: {depth: 8}}
  - table: {file: ratios, caption: Ratios, rows: [problem], values: wall_s/answer, relative_to: succeed}
  - figure: {file: covers, kind: cover_panels, rows: problem, columns: method, filter: {method: [a nap], seed: [1]}, curve: true}
)";

inline std::vector<AcceptedSample> accepted_samples() {
  return {
      {"full", kFullConfig},
      {"shortest", "experiment: e\ntask: selftest\nproblems: one\nmethods: {name: succeed}\n"},
      {"scalars_for_lists",
       "experiment: e\ntask: selftest\nproblems: suite:all\nmethods: [{name: succeed}]\nparameters: {depth: "
       "3}\nseeds: 7\n"},
      {"seed_range",
       "experiment: e\ntask: selftest\nproblems: one\nmethods: {name: succeed}\nseeds: [7, 1..3]\n"},
      {"number_as_name", "experiment: 4.5\ntask: selftest\nproblems: one\nmethods: {name: succeed}\n"},
      {"empty_report",
       "experiment: e\ntask: selftest\nproblems: one\nmethods: {name: succeed}\nreport: []\n"},
  };
}

inline std::vector<RefusedSample> refused_samples() {
  const std::string head = "experiment: e\ntask: selftest\nproblems: [one]\n";  // lines 1 to 3
  const std::string start = head + "methods: [{name: succeed}]\n";              // lines 1 to 4
  const auto table = [&](const std::string& keys) { return start + "report:\n  - table: {" + keys + "}\n"; };
  const auto figure = [&](const std::string& keys) {
    return start + "report:\n  - figure: {" + keys + "}\n";
  };
  return {
      // the outermost keys
      {"unknown_key", start + "repetition: 5\n",
       "c.yaml:5: unknown key 'repetition' (did you mean 'repetitions'?)", true},
      {"duplicate_key", start + "seeds: 1\nseeds: 2\n", "c.yaml:6: key 'seeds' is given twice", false},
      {"not_yaml", "experiment: [e\n", "c.yaml:2: is not YAML", false},
      {"empty", "", "c.yaml: is empty", true},
      {"list", "- a\n", "c.yaml:1: is not a map of keys", true},
      {"no_experiment", "task: selftest\nproblems: one\nmethods: {name: succeed}\n",
       "c.yaml:1: lacks the key 'experiment'", true},
      {"no_task", "experiment: e\nproblems: one\nmethods: {name: succeed}\n", "lacks the key 'task'", true},
      {"no_problems", "experiment: e\ntask: selftest\nmethods: {name: succeed}\n", "lacks the key 'problems'",
       true},
      {"no_methods", head, "lacks the key 'methods'", true},
      {"experiment_as_path", "experiment: ../e\ntask: selftest\nproblems: one\nmethods: {name: succeed}\n",
       "c.yaml:1: 'experiment' is '../e'; it names files", true},
      {"unknown_task", "experiment: e\ntask: selftset\nproblems: one\nmethods: {name: succeed}\n",
       "c.yaml:2: unknown task 'selftset' (did you mean 'selftest'?)", false},
      // problems
      {"unknown_problem",
       "experiment: e\ntask: selftest\nproblems:\n  - one\n  - threee\nmethods: {name: succeed}\n",
       "c.yaml:5: unknown problem 'threee' (did you mean 'three'?)", false},
      {"problem_twice", "experiment: e\ntask: selftest\nproblems: [one, one]\nmethods: {name: succeed}\n",
       "c.yaml:3: 'problems[1]' is 'one', which is listed already", true},
      {"no_problem", "experiment: e\ntask: selftest\nproblems: []\nmethods: {name: succeed}\n",
       "c.yaml:3: 'problems' is an empty list", true},
      {"wrong_kind_of_problem",
       "experiment: e\ntask: selftest\nproblems:\n  - wrong-kind\nmethods: {name: succeed}\n",
       "c.yaml:4: wrong-kind: is a letter", false},
      {"problem_is_map", "experiment: e\ntask: selftest\nproblems: [{a: b}]\nmethods: {name: succeed}\n",
       "c.yaml:3: 'problems[0]' is not a word or number", true},
      // methods
      {"unknown_method", head + "methods:\n  - {name: succeed}\n  - {name: sleeep}\n",
       "c.yaml:6: unknown method of selftest 'sleeep' (did you mean 'sleep'?)", false},
      {"method_is_word", head + "methods: [succeed]\n", "c.yaml:4: 'methods[0]' is not a map of keys", true},
      {"method_without_name", head + "methods: [{label: x}]\n", "c.yaml:4: 'methods[0]' lacks the key 'name'",
       true},
      {"unknown_method_key", head + "methods: [{name: succeed, option: {answer: 1}}]\n",
       "c.yaml:4: unknown key 'option' (did you mean 'options'?)", true},
      {"unknown_option",
       head + "methods:\n  - name: succeed\n    options:\n      negative: true\n      anwser: 1\n",
       "c.yaml:8: unknown option of succeed 'anwser' (did you mean 'answer'?)", false},
      {"option_out_of_range", head + "methods: [{name: succeed, options: {answer: 101}}]\n",
       "c.yaml:4: option 'answer' of succeed is '101'; expected integer in [-100, 100]", false},
      {"option_no_number", head + "methods: [{name: succeed, options: {answer: many}}]\n",
       "is 'many'; expected integer", false},
      {"option_no_choice", head + "methods: [{name: succeed, options: {arithmetic: fsat}}]\n",
       "is 'fsat'; expected one of fast, slow", false},
      {"option_is_list", head + "methods: [{name: succeed, options: {answer: [1]}}]\n",
       "c.yaml:4: 'methods[0].options.answer' is not a word or number", true},
      {"method_twice",
       head + "methods:\n  - {name: succeed}\n  - {name: succeed, options: {answer: 42}, label: again}\n",
       "c.yaml:6: method 'succeed' with these options is listed already", false},
      {"label_twice", head + "methods:\n  - {name: succeed, label: a}\n  - {name: sleep, label: a}\n",
       "c.yaml:6: two methods have the label 'a'", false},
      {"no_method", head + "methods: []\n", "c.yaml:4: 'methods' is an empty list", true},
      // parameters, seeds, repetitions, limits
      {"unknown_parameter", start + "parameters: {deepth: 8}\n",
       "c.yaml:5: unknown parameter of task selftest 'deepth' (did you mean 'depth'?)", false},
      {"parameter_out_of_range", start + "parameters:\n  depth: [6,\n          31]\n",
       "c.yaml:7: option 'depth' of task selftest is '31'; expected integer in [0, 30]", false},
      {"parameter_twice", start + "parameters: {depth: [6, 6]}\n", "is 6, which is listed already", true},
      {"parameter_equal_number", start + "parameters: {cell_size: [0.5, 5e-1]}\n",
       "is 0.5, which is listed already", true},
      {"no_parameter_value", start + "parameters: {depth: []}\n", "'parameters.depth' is an empty list",
       true},
      {"negative_seed", start + "seeds: [-1]\n", "c.yaml:5: 'seeds[0]' is negative", true},
      {"seed_no_number", start + "seeds: x\n", "c.yaml:5: 'seeds' is 'x'; a whole number was expected", true},
      {"seed_quoted", start + "seeds: \"1\"\n", "a whole number was expected", true},
      {"seed_range", start + "seeds: 9..2\n", "a range such as 0..99", false},
      {"seed_twice", start + "seeds: [1, 1]\n", "c.yaml:5: 'seeds[1]' is listed already", true},
      {"no_repetition", start + "repetitions: 0\n", "c.yaml:5: 'repetitions' is 0; expected 1 to 1000000",
       true},
      {"repetitions_list", start + "repetitions: [5]\n", "c.yaml:5: 'repetitions' is not a word or number",
       true},
      {"unknown_limit", start + "limits: {wall: 60}\n", "c.yaml:5: unknown key 'wall'", true},
      {"limit_of_zero", start + "limits: {wall_s: 0}\n",
       "c.yaml:5: 'limits.wall_s' is 0; expected more than 0", true},
      {"limit_no_number", start + "limits: {memory_mb: 2 GB}\n",
       "'limits.memory_mb' is '2 GB'; a number was expected", true},
      // the report
      {"unknown_form", start + "report:\n  - tabel: {}\n",
       "c.yaml:6: unknown key 'tabel' (did you mean 'table'?)", true},
      {"two_forms",
       start +
           "report:\n  - table: {file: a, rows: problem, values: answer}\n    figure: {file: b, kind: k}\n",
       "c.yaml:6: 'report[0]' must be either a table or a figure", true},
      {"report_is_map", start + "report: {table: {file: a}}\n", "c.yaml:5: 'report' is not a list", true},
      {"table_without_file", table("rows: problem, values: answer"),
       "c.yaml:6: 'report[0].table' lacks the key 'file'", true},
      {"table_without_rows", table("file: a, values: answer"), "lacks the key 'rows'", true},
      {"table_without_values", table("file: a, rows: problem"), "lacks the key 'values'", true},
      {"figure_without_kind", figure("file: a"), "lacks the key 'kind'", true},
      {"unknown_axis", table("file: a, rows: problme, values: answer"),
       "c.yaml:6: unknown axis 'problme' (did you mean 'problem'?)", false},
      {"shared_axis", table("file: a, rows: problem, columns: [method, problem], values: answer"),
       "axis 'problem' is both in rows and in columns", false},
      {"unknown_value", table("file: a, rows: problem, values: [answr]"),
       "unknown value 'answr' (did you mean 'answer'?)", false},
      {"unknown_quotient", table("file: a, rows: problem, values: wall_s/answr"),
       "unknown value 'answr' (did you mean 'answer'?)", false},
      {"value_twice", table("file: a, rows: problem, values: [answer, answer]"), "is 'answer' a second time",
       true},
      {"unknown_best", table("file: a, rows: problem, values: answer, best: most"),
       "unknown choice of best 'most'", true},
      {"unknown_filter", table("file: a, rows: problem, values: answer, filter: {depht: 8}"),
       "unknown key 'depht' (did you mean 'depth'?)", false},
      {"filter_not_in_config", table("file: a, rows: problem, values: answer, filter: {problem: two}"),
       "unknown problem 'two' (known: one)", false},
      {"file_with_folder", table("file: a/b, rows: problem, values: answer"), "is 'a/b'; it names files",
       true},
      {"file_twice", start + "report:\n  - figure: {file: a, kind: k}\n  - figure: {file: a, kind: k}\n",
       "c.yaml:7: two report items write the file 'a'", false},
      {"option_of_figure_is_list", figure("file: a, kind: k, curve: [true]"), "is not a word or number",
       true},
  };
}

}  // namespace gcslab
