#pragma once

// Equations (and inequalities) in named variables over a box: what every solver and cover starts from.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/yaml_reader.h"
#include "expression/expression.h"
#include "interval/interval.h"

namespace gcslab {

struct EquationSystem {
  std::shared_ptr<ExpressionGraph> graph = std::make_shared<ExpressionGraph>();
  std::vector<std::string> variables;
  std::vector<Expression> equations;     ///< each is to vanish
  std::vector<Expression> inequalities;  ///< each is to be <= 0
  Box box;                               ///< one interval a variable; may be unbounded
};

/// Reads the keys `variables`, `equations`, `inequalities` and `box` of a problem file; the other keys are
/// the caller's. Throws InputError with file and line.
EquationSystem read_equation_system(const YamlNode& problem);

/// Reads a list of variable names, each a name and given once.
std::vector<std::string> read_variables(const YamlNode& node);

/// Reads {x: [lower, upper], ...}, one interval a variable.
Box read_box(const YamlNode& node, const std::vector<std::string>& variables);

/// The tightest double interval around the reals from one end to the other; the ends are constant expressions
/// or -inf, inf. Throws InputError when it is empty or no number.
Interval interval_from_texts(const std::string& lower, const std::string& upper);

/// Reads "x=[-3,3],y=[0,1]" into a copy of `box`. Throws InputError for an unknown variable or a bad
/// interval.
Box read_box_option(const std::string& text, const std::vector<std::string>& variables, const Box& box);

}  // namespace gcslab
