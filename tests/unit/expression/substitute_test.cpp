#include "expression/substitute.h"

#include <gtest/gtest.h>

#include "expression/parser.h"
#include "expression/printer.h"

namespace gcslab {
namespace {

const std::vector<std::string> kNames = {"x", "y"};

TEST(Substitute, PutsExpressionsForVariables) {
  ExpressionGraph graph, target;
  const Expression f = parse_expression(graph, "x^3 + sin(x*y) - max(y, x^(2/3)) / (pi + y)", kNames);
  const std::vector<Expression> replacements = {parse_expression(target, "y^2", kNames),
                                                parse_expression(target, "3", kNames)};
  EXPECT_EQ(to_text(substitute(f, target, replacements), kNames),
            to_text(parse_expression(target, "(y^2)^3 + sin(y^2*3) - max(3, (y^2)^(2/3)) / (pi + 3)", kNames),
                    kNames));
}

TEST(Substitute, WithVariablesItCopies) {
  ExpressionGraph graph, target;
  const std::vector<Expression> variables = {target.variable(0), target.variable(1)};
  const Expression f = parse_expression(graph, "exp(x) * sqrt(x) - abs(y) + 1/7", kNames);
  const std::size_t size = graph.size();
  const Expression copy = substitute(f, target, variables);
  EXPECT_EQ(&copy.graph(), &target);
  EXPECT_EQ(graph.size(), size);
  EXPECT_EQ(to_text(copy, kNames), to_text(f, kNames));
}

}  // namespace
}  // namespace gcslab
