#include <vector>

#include "expression/parser.h"
#include "fuzz/fuzz_target.h"

namespace {

/// Printed text must parse back to the same node.
void check_printing(gcslab::Expression expression, const std::vector<std::string>& variables) {
  using namespace gcslab;
  const std::string printed = to_text(expression, variables);
  try {
    if (parse_expression(expression.graph(), printed, variables) != expression) {
      report_fault("another expression after printing " + printed);
    }
  } catch (const InputError& error) {
    if (!is_limit(error)) report_fault(error.what());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gcslab;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::vector<std::string> variables = {"x", "y", "z"};
  survive([&] {
    ExpressionGraph graph;
    check_printing(parse_expression(graph, text, variables), variables);
  });
  survive([&] {
    ExpressionGraph graph;
    check_printing(parse_equation(graph, text, variables), variables);
  });
  survive([&] {
    ExpressionGraph graph;
    check_printing(parse_inequality(graph, text, variables), variables);
  });
  return 0;
}
