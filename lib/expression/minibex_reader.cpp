#include "expression/minibex_reader.h"

#include <fmt/format.h>
#include <set>
#include <utility>

#include "base/error.h"
#include "expression/minibex_expression.h"
#include "expression/minibex_range.h"
#include "expression/minibex_scope.h"
#include "expression/token_stream.h"
#include "expression/variable_names.h"

namespace gcslab {
namespace {

using minibex::is_keyword;

constexpr std::size_t kMaximumVariables = 100'000;

class MinibexReader {
 public:
  MinibexReader(std::string_view text, const std::string& file)
      : tokens_(text, file, minibex::words()),
        expressions_(tokens_, *system_.graph),
        ranges_(tokens_, expressions_) {}

  EquationSystem read() {
    while (!is_keyword(tokens_.peek(), "constraints")) read_block();
    tokens_.next();
    if (system_.variables.empty()) tokens_.fail_expected("'Variables' before the constraints");
    read_statements(variables_);
    expect_end("after the constraints");
    if (tokens_.peek().kind != Token::Kind::end) tokens_.fail_expected("nothing after the last 'end'");
    if (system_.equations.empty()) {
      tokens_.fail(0, "has no equation; expected at least one constraint with '='");
    }
    return std::move(system_);
  }

 private:
  void read_block() {
    const Token token = tokens_.peek();
    if (is_keyword(token, "constants")) return read_constants();
    if (is_keyword(token, "variables")) return read_variables();
    if (is_keyword(token, "function")) return read_function();
    if (is_keyword(token, "minimize")) {
      tokens_.fail(token.line, "minimizes, but gcslab solves systems; expected constraints only");
    }
    tokens_.fail_expected("'Constants', 'Variables', 'Function' or 'Constraints'");
  }

  bool at_block() {
    const Token& token = tokens_.peek();
    return is_keyword(token, "constants") || is_keyword(token, "variables") ||
           is_keyword(token, "function") || is_keyword(token, "minimize") ||
           is_keyword(token, "parameters") || is_keyword(token, "constraints") ||
           token.kind == Token::Kind::end;
  }

  void expect_separator(const std::string& where) {
    if (tokens_.accept(";") || tokens_.accept(",")) return;
    tokens_.fail_expected("';' " + where);
  }

  void expect_end(const std::string& where) {
    if (!is_keyword(tokens_.peek(), "end")) tokens_.fail_expected("'end' " + where);
    tokens_.next();
  }

  void read_constants() {
    tokens_.next();
    while (!at_block()) {
      const Token name = expressions_.new_name("the name of a constant");
      const minibex::Shape shape = ranges_.shape(constants_);
      if (!tokens_.accept("=") && !is_keyword(tokens_.peek(), "in")) {
        tokens_.fail_expected("'=' or 'in' after the name of a constant");
      }
      if (is_keyword(tokens_.peek(), "in")) tokens_.next();
      expressions_.define(constants_, name, minibex::ConstantArray{shape, ranges_.ranges(shape, constants_)});
      expect_separator("after the constant");
    }
  }

  struct Declaration {
    Token name;
    minibex::Shape shape;
  };

  void read_variables() {
    if (!system_.variables.empty()) tokens_.fail_expected("one block of variables");
    tokens_.next();
    std::vector<Declaration> declarations;
    while (!at_block()) {
      declarations.push_back(read_variable());
      if (!at_block()) expect_separator("after the variable");
    }
    if (declarations.empty()) tokens_.fail_expected("the name of a variable");
    name_variables(declarations);
  }

  Declaration read_variable() {
    const Token name = expressions_.new_name("the name of a variable");
    const minibex::Shape shape = ranges_.shape(constants_);
    std::vector<minibex::Range> domain(minibex::number_of_entries(shape));
    if (is_keyword(tokens_.peek(), "in")) {
      tokens_.next();
      domain = ranges_.ranges(shape, constants_);
    }
    minibex::ExpressionArray array{shape, {}};
    for (const minibex::Range& range : domain) {
      array.entries.push_back(system_.graph->variable(static_cast<int>(system_.box.size())));
      system_.box.push_back(tokens_.at_line(name.line, [&] { return minibex::enclosure(range); }));
    }
    if (system_.box.size() > kMaximumVariables) {
      tokens_.fail(name.line, "has more than " + std::to_string(kMaximumVariables) + " variables");
    }
    expressions_.define(variables_, name, std::move(array));
    return {name, shape};
  }

  /// Scalars keep their names where they can; entries of arrays take what is free.
  void name_variables(const std::vector<Declaration>& declarations) {
    std::set<std::string> taken;
    std::map<std::string_view, std::string> scalars;
    for (const Declaration& declaration : declarations) {
      if (declaration.shape.empty()) {
        scalars[declaration.name.text] = free_variable_name(declaration.name.text, taken);
      }
    }
    for (const Declaration& declaration : declarations) {
      if (declaration.shape.empty()) {
        system_.variables.push_back(scalars[declaration.name.text]);
      } else {
        name_entries(declaration, taken);
      }
    }
  }

  void name_entries(const Declaration& declaration, std::set<std::string>& taken) {
    const std::size_t entries = minibex::number_of_entries(declaration.shape);
    for (std::size_t place = 0; place < entries; ++place) {
      std::string suffix;
      std::size_t rest = place;
      for (auto dimension = declaration.shape.rbegin(); dimension != declaration.shape.rend(); ++dimension) {
        const auto size = static_cast<std::size_t>(dimension->size);
        suffix.insert(0, fmt::format("_{}", static_cast<long>(rest % size) + dimension->first.value_or(1)));
        rest /= size;
      }
      system_.variables.push_back(free_variable_name(std::string(declaration.name.text) + suffix, taken));
    }
  }

  void read_function() {
    tokens_.next();
    const Token name = expressions_.new_name("the name of a function");
    minibex::Function function{{}, 0, &constants_};
    tokens_.expect("(", "after the name of the function");
    do {
      const Token parameter = expressions_.new_name("the name of a parameter");
      for (const auto& other : function.parameters) {
        if (other.name == parameter.text)
          tokens_.fail(parameter.line, described(parameter) + " is named twice");
      }
      function.parameters.push_back({std::string(parameter.text), ranges_.shape(constants_)});
    } while (tokens_.accept(","));
    tokens_.expect(")", "after the parameters");
    function.body = tokens_.position();
    while (!is_keyword(tokens_.peek(), "end")) {
      if (tokens_.next().kind == Token::Kind::end) tokens_.fail_expected("'end' after the function");
    }
    tokens_.next();
    expressions_.define(constants_, name, std::move(function));
  }

  /// Statements up to an 'end', which is left.
  void read_statements(const minibex::Scope& surroundings) {
    minibex::Scope scope(&surroundings);
    while (!is_keyword(tokens_.peek(), "end")) {
      expressions_.charge(1);
      if (is_keyword(tokens_.peek(), "for")) {
        read_loop(scope);
        tokens_.accept(";");
        continue;
      }
      if (begins_abbreviation(scope)) {
        read_abbreviation(scope);
      } else {
        read_constraint(scope);
      }
      if (!is_keyword(tokens_.peek(), "end")) tokens_.expect(";", "after the constraint");
    }
    expect_all_used(scope);
  }

  bool begins_abbreviation(const minibex::Scope& scope) {
    const Token& name = tokens_.peek();
    return name.kind == Token::Kind::name && !minibex::is_reserved(name.text) && tokens_.peek(1).is("=") &&
           scope.find(tokens_.peek().text) == nullptr;
  }

  void read_abbreviation(minibex::Scope& scope) {
    const Token name = tokens_.next();
    tokens_.expect("=", "after the name");
    const Expression value = expressions_.expression(scope);
    expressions_.define(scope, name, minibex::Abbreviation{value, name.line});
  }

  /// A misspelt variable would otherwise take an equation away.
  void expect_all_used(const minibex::Scope& scope) {
    for (const auto& [name, symbol] : scope.own()) {
      const auto* abbreviation = std::get_if<minibex::Abbreviation>(&symbol);
      if (abbreviation != nullptr && !abbreviation->is_used) {
        tokens_.fail(abbreviation->line, "'" + name + "' is no variable and is not used afterwards");
      }
    }
  }

  /// for i=1:n; ... end
  void read_loop(const minibex::Scope& scope) {
    tokens_.next();
    const Token counter = expressions_.new_name("a new name to count with");
    tokens_.expect("=", "after the name");
    const minibex::ExpressionReader::Rounds rounds = expressions_.rounds(scope);
    tokens_.expect(";", "after the last value");
    const std::size_t start = tokens_.position();
    const TokenStream::Nesting guard(tokens_);
    for (long i = rounds.first; i <= rounds.last; ++i) {
      expressions_.charge(1);
      tokens_.return_to(start);
      minibex::Scope inner(&scope);
      expressions_.define(inner, counter, minibex::Counter{i});
      read_statements(inner);
    }
    if (rounds.last < rounds.first) skip_statements();
    expect_end("after the loop");
  }

  void skip_statements() {
    int depth = 0;
    while (depth > 0 || !is_keyword(tokens_.peek(), "end")) {
      expressions_.charge(1);
      const Token token = tokens_.next();
      if (is_keyword(token, "for")) ++depth;
      if (is_keyword(token, "end")) --depth;
      if (token.kind == Token::Kind::end) tokens_.fail_expected("'end' after the loop");
    }
  }

  void read_constraint(const minibex::Scope& scope) {
    const Expression left = expressions_.expression(scope);
    const Token relation = tokens_.peek();
    if (relation.is("<") || relation.is(">")) {
      tokens_.fail(relation.line, "the strict inequality " + described(relation) +
                                      " bounds no closed set; expected '<=', '>=' or '='");
    }
    if (is_keyword(relation, "in")) {
      tokens_.next();
      add_range(left, scope);
      return;
    }
    if (!relation.is("=") && !relation.is("<=") && !relation.is(">=")) {
      tokens_.fail_expected("'=', '<=' or '>='");
    }
    tokens_.next();
    const Expression right = expressions_.expression(scope);
    tokens_.at_line(relation.line, [&] {
      if (relation.is("=")) system_.equations.push_back(left - right);
      if (relation.is("<=")) system_.inequalities.push_back(left - right);
      if (relation.is(">=")) system_.inequalities.push_back(right - left);
    });
  }

  /// value in [a, b]
  void add_range(Expression value, const minibex::Scope& scope) {
    const int line = tokens_.peek().line;
    const minibex::Range range = ranges_.ranges({}, scope).front();
    tokens_.at_line(line, [&] {
      static_cast<void>(minibex::enclosure(range));  // refuses empty ones
      if (range.is_point()) {
        system_.equations.push_back(value - *range.lower);
        return;
      }
      if (range.lower) system_.inequalities.push_back(*range.lower - value);
      if (range.upper) system_.inequalities.push_back(value - *range.upper);
    });
  }

  EquationSystem system_;
  TokenStream tokens_;
  minibex::ExpressionReader expressions_;
  minibex::RangeReader ranges_;
  minibex::Scope constants_;
  minibex::Scope variables_{&constants_};
};

}  // namespace

EquationSystem read_minibex(std::string_view text, const std::string& file) {
  return MinibexReader(text, file).read();
}

}  // namespace gcslab
