#include "expression/equation_system.h"

#include <algorithm>
#include <cctype>
#include <regex>

#include "base/check.h"
#include "base/nearest_name.h"
#include "expression/constant_enclosure.h"
#include "expression/parser.h"

namespace gcslab {

std::vector<std::string> read_variables(const YamlNode& node) {
  std::vector<std::string> names;
  for (const YamlNode& item : node.items()) {
    const std::string name = item.text();
    if (!is_variable_name(name))
      item.fail("is '" + name + "'; a variable is letters, digits and _, no function");
    if (std::ranges::find(names, name) != names.end()) item.fail("names the variable '" + name + "' twice");
    names.push_back(name);
  }
  if (names.empty()) node.fail("names no variable");
  return names;
}

namespace {

using ExpressionParser = Expression (*)(ExpressionGraph&, std::string_view, std::span<const std::string>);

std::vector<Expression> read_expressions(const YamlNode& node, EquationSystem& system,
                                         ExpressionParser parse) {
  if (node.is_scalar()) node.fail("is one text; write a list: [\"" + node.text() + "\"]");
  std::vector<Expression> result;
  for (const YamlNode& item : node.items()) {
    try {
      result.push_back(parse(*system.graph, item.text(), system.variables));
    } catch (const InputError& error) {
      throw InputError(item.where(), error.what());
    }
  }
  return result;
}

Interval read_interval(const YamlNode& node) {
  const std::vector<YamlNode> ends = node.items();
  if (ends.size() != 2) node.fail("must be [lower, upper]");
  try {
    return interval_from_texts(ends[0].text(), ends[1].text());
  } catch (const InputError& error) {
    node.fail(std::string("is no interval: ") + error.what());
  }
}

/// An interval that contains the constant expression that `text` spells.
Interval enclosure_of_text(const std::string& text) {
  if (text == "inf" || text == "+inf") return {std::numeric_limits<double>::max(), Interval::entire().upper};
  if (text == "-inf") return {Interval::entire().lower, -std::numeric_limits<double>::max()};
  ExpressionGraph graph;
  const Interval enclosure = constant_enclosure(parse_expression(graph, text, {}));
  if (is_empty(enclosure)) throw InputError("\"" + text + "\" is not defined");
  return enclosure;
}

}  // namespace

Interval interval_from_texts(const std::string& lower, const std::string& upper) {
  const Interval low = enclosure_of_text(lower);
  const Interval high = enclosure_of_text(upper);
  if (low.lower > high.upper || low.lower == Interval::entire().upper ||
      high.upper == Interval::entire().lower || (lower == "inf") || (upper == "-inf")) {
    throw InputError("the lower end " + lower + " is greater than the upper end " + upper);
  }
  return {low.lower, high.upper};
}

Box read_box(const YamlNode& node, const std::vector<std::string>& variables) {
  node.allow_keys(variables);
  Box box;
  for (const std::string& name : variables) box.push_back(read_interval(node.at(name)));
  return box;
}

EquationSystem read_equation_system(const YamlNode& problem) {
  EquationSystem system;
  system.variables = read_variables(problem.at("variables"));
  system.equations = read_expressions(problem.at("equations"), system, parse_equation);
  if (system.equations.empty()) problem.at("equations").fail("lists no equation");
  if (const auto inequalities = problem.find("inequalities")) {
    system.inequalities = read_expressions(*inequalities, system, parse_inequality);
  }
  system.box = read_box(problem.at("box"), system.variables);
  return system;
}

Box read_box_option(const std::string& text, const std::vector<std::string>& variables, const Box& box) {
  const auto fail = [&](const std::string& cause) {
    throw InputError("--box \"" + text + "\": " + cause + "; expected for example \"x=[-3,3],y=[0,1]\"");
  };
  std::string rest = text;
  std::erase_if(rest, [](unsigned char c) { return std::isspace(c) != 0; });
  Box result = box;
  std::vector<std::string> given;
  do {
    static const std::regex item(R"(([^=,]+)=\[([^\[\]]+),([^\[\],]+)\](,(?=.)|$))");
    std::smatch match;
    if (!std::regex_search(rest, match, item, std::regex_constants::match_continuous))
      fail("not a list of intervals");
    const std::string name = match[1];
    const auto variable = std::ranges::find(variables, name);
    if (variable == variables.end()) fail(unknown_name_message("variable", name, variables));
    if (std::ranges::find(given, name) != given.end()) fail("the variable '" + name + "' is given twice");
    given.push_back(name);
    try {
      result[static_cast<std::size_t>(variable - variables.begin())] =
          interval_from_texts(match[2], match[3]);
    } catch (const InputError& error) {
      fail(error.what());
    }
    rest = match.suffix();
  } while (!rest.empty());
  return result;
}

}  // namespace gcslab
