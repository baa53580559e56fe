#include "expression/bertini_writer.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/check.h"
#include "expression/notation.h"
#include "expression/polynomial_form.h"
#include "expression/variable_names.h"

namespace gcslab {
namespace {

/// A sign stands behind an opening parenthesis only: versions of Bertini differ in what -a + b means.
class BertiniNotation final : public Notation {
 public:
  using Notation::Notation;

 private:
  Form constant(const Rational& value) const override {
    const bool is_natural = value >= 0 && value.get_den() == 1;
    return {{Piece::of(is_natural ? value.get_str() : "(" + value.get_str() + ")")}, Binding::atom};
  }
  Form pi() const override { return {{Piece::of("Pi")}, Binding::atom}; }
  Form negation(Expression e) const override {
    return {{Piece::of("(-"), Piece::of(e.operand(0), Binding::power), Piece::of(")")}, Binding::atom};
  }
  Form power(Expression e, const Rational& exponent) const override {
    return {{Piece::of(e.operand(0), Binding::atom), Piece::of("^" + exponent.get_str())}, Binding::power};
  }
  Form call(Expression /*e*/) const override { GCSLAB_CHECK(false); }
};

bool is_allowed(const std::string& name) {
  constexpr std::array<std::string_view, 28> kReserved = {"CONFIG",
                                                          "INPUT",
                                                          "END",
                                                          "variable",
                                                          "variable_group",
                                                          "hom_variable_group",
                                                          "pathvariable",
                                                          "function",
                                                          "constant",
                                                          "random",
                                                          "random_real",
                                                          "parameter",
                                                          "implicit_parameter",
                                                          "subfunction",
                                                          "pi",
                                                          "Pi",
                                                          "PI",
                                                          "i",
                                                          "I",
                                                          "e",
                                                          "E",
                                                          "exp",
                                                          "log",
                                                          "sin",
                                                          "cos",
                                                          "tan",
                                                          "sqrt",
                                                          "pow"};
  return std::isalpha(static_cast<unsigned char>(name.front())) != 0 &&
         std::ranges::find(kReserved, name) == kReserved.end();
}

/// f1, f2, ..., with more underscores where a variable has such a name.
std::vector<std::string> function_names(std::size_t count, const std::vector<std::string>& variables) {
  std::string prefix = "f";
  const auto is_taken = [&](const std::string& name) {
    return std::ranges::any_of(variables, [&](const std::string& v) { return v.starts_with(name); });
  };
  while (is_taken(prefix)) prefix += "_";
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= count; ++i) names.push_back(prefix + std::to_string(i));
  return names;
}

std::string comments(const EquationSystem& system, const ForeignNames& names) {
  std::string text =
      "% written by gcslab\n% The box is not written: Bertini looks for all complex solutions.\n";
  if (!system.inequalities.empty()) {
    text += fmt::format("% {} inequalities are not written; solutions may violate them.\n",
                        system.inequalities.size());
  }
  for (const auto& [changed, original] : names.renamed) {
    text += fmt::format("% {} stands for {}\n", changed, original);
  }
  return text;
}

}  // namespace

std::string write_bertini(const EquationSystem& system) {
  require_polynomial_form(system, Constants::rational_and_pi, "Bertini");
  const ForeignNames names = foreign_names(system.variables, is_allowed);
  const BertiniNotation notation(names.names);
  const std::vector<std::string> functions = function_names(system.equations.size(), names.names);
  std::string text = comments(system, names) + "CONFIG\nEND;\n\nINPUT\n";
  text += fmt::format("variable_group {};\nfunction {};\n\n", fmt::join(names.names, ", "),
                      fmt::join(functions, ", "));
  for (std::size_t i = 0; i < functions.size(); ++i) {
    text += fmt::format("{} = {};\n", functions[i], written(system.equations[i], notation));
  }
  return text + "END;\n";
}

}  // namespace gcslab
