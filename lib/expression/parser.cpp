#include "expression/parser.h"

#include <cctype>
#include <functional>
#include <vector>

#include "base/error.h"
#include "base/nearest_name.h"

namespace gcslab {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

class Parser {
 public:
  /// Parses text[begin .. end); errors quote the whole text.
  Parser(ExpressionGraph& graph, std::string_view text, std::span<const std::string> variables,
         std::size_t begin, std::size_t end)
      : graph_(graph),
        whole_text_(text),
        text_(text.substr(0, end)),
        variables_(variables),
        position_(begin) {}

  Expression whole() {
    const Expression result = sum();
    skip_spaces();
    if (position_ < text_.size()) fail("expected an operator or the end (a product is written 2*x)");
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { fail_at(position_, message); }

  [[noreturn]] void fail_at(std::size_t position, const std::string& message) const {
    throw InputError("in \"" + std::string(whole_text_) + "\", column " + std::to_string(position + 1) +
                     ": " + message);
  }

  /// Runs a construction of the graph and adds the place to its errors.
  Expression at_place(std::size_t position, const std::function<Expression()>& build) const {
    try {
      return build();
    } catch (const InputError& error) {
      fail_at(position, error.what());
    }
  }

  void skip_spaces() {
    while (position_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[position_])) != 0)
      ++position_;
  }

  char peek() {
    skip_spaces();
    return position_ < text_.size() ? text_[position_] : '\0';
  }

  bool accept(char c) {
    if (peek() != c) return false;
    ++position_;
    return true;
  }

  void expect(char c) {
    if (!accept(c)) fail(std::string("expected '") + c + "'");
  }

  Expression sum() {
    Expression result = product();
    while (true) {
      const std::size_t place = position_;
      if (accept('+')) {
        const Expression next = product();
        result = at_place(place, [&] { return result + next; });
      } else if (accept('-')) {
        const Expression next = product();
        result = at_place(place, [&] { return result - next; });
      } else {
        return result;
      }
    }
  }

  Expression product() {
    Expression result = unary();
    while (true) {
      const std::size_t place = position_;
      if (accept('*')) {
        if (peek() == '*') fail("'**' is no operator; a power is written ^");
        const Expression factor = unary();
        result = at_place(place, [&] { return result * factor; });
      } else if (accept('/')) {
        const Expression divisor = unary();
        result = at_place(place, [&] { return result / divisor; });
      } else {
        return result;
      }
    }
  }

  Expression unary() {
    const DepthGuard guard(*this);
    if (accept('-')) return -unary();
    if (accept('+')) return unary();
    return power();
  }

  Expression power() {
    const Expression base = atom();
    if (!accept('^')) return base;
    const std::size_t place = position_;
    const Expression exponent = unary();
    if (!exponent.is_constant())
      fail_at(place, "the exponent must be a rational constant (write exp(y*log(x)) for x^y)");
    return at_place(place, [&] { return graph_.power(base, exponent.constant()); });
  }

  Expression atom() {
    const char c = peek();
    if (c == '(') {
      ++position_;
      const Expression inner = sum();
      expect(')');
      return inner;
    }
    if (is_digit(c) || c == '.') return number();
    if (is_letter(c)) return name();
    fail("expected a number, a variable, a function or '('");
  }

  Expression number() {
    const std::size_t begin = position_;
    const auto digits = [&] {
      while (position_ < text_.size() && is_digit(text_[position_])) ++position_;
    };
    digits();
    if (position_ < text_.size() && text_[position_] == '.') ++position_;
    digits();
    if (position_ < text_.size() && (text_[position_] == 'e' || text_[position_] == 'E')) {
      ++position_;
      if (position_ < text_.size() && (text_[position_] == '+' || text_[position_] == '-')) ++position_;
      digits();
    }
    const std::string_view literal = text_.substr(begin, position_ - begin);
    return at_place(begin, [&] { return graph_.constant(rational_from_text(literal)); });
  }

  Expression name() {
    const std::size_t begin = position_;
    while (position_ < text_.size() && (is_letter(text_[position_]) || is_digit(text_[position_])))
      ++position_;
    const std::string name(text_.substr(begin, position_ - begin));
    for (std::size_t i = 0; i < variables_.size(); ++i) {
      if (variables_[i] == name) return graph_.variable(static_cast<int>(i));
    }
    if (name == "pi") return graph_.pi();
    if (const auto function = function_named(name)) return call(*function, name);
    fail_at(begin,
            unknown_name_message(peek() == '(' ? "function" : "variable", name, known_names(peek() == '(')));
  }

  Expression call(Operation function, const std::string& name) {
    const std::size_t place = position_;
    if (!accept('(')) fail_at(place, "expected '(' after the function " + name);
    const Expression first = sum();
    if (info(function).operands == 1) {
      if (peek() == ',') fail(name + " takes one argument");
      expect(')');
      return at_place(place, [&] { return graph_.apply(function, first); });
    }
    if (!accept(',')) fail(name + " takes two arguments; expected ','");
    const Expression second = sum();
    expect(')');
    return graph_.apply(function, first, second);
  }

  std::vector<std::string> known_names(bool functions) const {
    if (!functions) {
      std::vector<std::string> names(variables_.begin(), variables_.end());
      names.emplace_back("pi");
      return names;
    }
    std::vector<std::string> names;
    for (int i = 0; i <= static_cast<int>(Operation::max); ++i) {
      const OperationInfo& operation = info(static_cast<Operation>(i));
      if (!operation.name.empty()) names.emplace_back(operation.name);
    }
    return names;
  }

  struct DepthGuard {
    explicit DepthGuard(Parser& owner) : parser(owner) {
      if (++parser.depth_ > kMaximumNesting) parser.fail("nested too deeply");
    }
    ~DepthGuard() { --parser.depth_; }
    DepthGuard(const DepthGuard&) = delete;
    DepthGuard& operator=(const DepthGuard&) = delete;
    Parser& parser;
  };

  ExpressionGraph& graph_;
  std::string_view whole_text_;
  std::string_view text_;  ///< up to the end of the part that is parsed
  std::span<const std::string> variables_;
  std::size_t position_;
  int depth_ = 0;
};

}  // namespace

namespace {

Expression parse_part(ExpressionGraph& graph, std::string_view text, std::span<const std::string> variables,
                      std::size_t begin, std::size_t end) {
  return Parser(graph, text, variables, begin, end).whole();
}

}  // namespace

Expression parse_expression(ExpressionGraph& graph, std::string_view text,
                            std::span<const std::string> variables) {
  return parse_part(graph, text, variables, 0, text.size());
}

Expression parse_equation(ExpressionGraph& graph, std::string_view text,
                          std::span<const std::string> variables) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) return parse_expression(graph, text, variables);
  const bool is_relation = equals > 0 && (text[equals - 1] == '<' || text[equals - 1] == '>');
  if (is_relation || text.find('=', equals + 1) != std::string_view::npos) {
    throw InputError("in \"" + std::string(text) + "\": an equation has one '=' and no '<' or '>'");
  }
  const Expression left = parse_part(graph, text, variables, 0, equals);
  return left - parse_part(graph, text, variables, equals + 1, text.size());
}

Expression parse_inequality(ExpressionGraph& graph, std::string_view text,
                            std::span<const std::string> variables) {
  for (const std::string_view relation : {"<=", ">="}) {
    const std::size_t place = text.find(relation);
    if (place == std::string_view::npos) continue;
    const Expression left = parse_part(graph, text, variables, 0, place);
    const Expression right = parse_part(graph, text, variables, place + 2, text.size());
    return relation == "<=" ? left - right : right - left;
  }
  throw InputError("in \"" + std::string(text) + "\": expected '<=' or '>='");
}

bool is_variable_name(std::string_view name) {
  if (name.empty() || !is_letter(name.front()) || name == "pi" || function_named(name)) return false;
  for (const char c : name) {
    if (!is_letter(c) && !is_digit(c)) return false;
  }
  return true;
}

}  // namespace gcslab
