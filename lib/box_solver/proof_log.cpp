#include "box_solver/proof_log.h"

#include <array>
#include <charconv>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

namespace gcslab {
namespace {

/// " " and the number in hexadecimal digits, exactly.
void append_number(std::string& line, double value) {
  std::array<char, 64> text{};
  char* start = text.data();
  *start++ = ' ';
  if (value < 0) *start++ = '-';
  const double size = value < 0 ? -value : value;
  if (size <= std::numeric_limits<double>::max()) {
    *start++ = '0';
    *start++ = 'x';
  }
  const auto result = std::to_chars(start, text.data() + text.size(), size + 0.0, std::chars_format::hex);
  line.append(text.data(), result.ptr);
}

template <class Integer>
void append_integer(std::string& line, Integer value, char separator = ' ') {
  line += separator;
  line += std::to_string(value);
}

/// The variables joined by '*', after `first`.
void append_monomial(std::string& line, std::span<const std::uint32_t> variables, char first = ' ') {
  char separator = first;
  for (const std::uint32_t variable : variables) {
    append_integer(line, variable, separator);
    separator = '*';
  }
}

void append_signed(std::string& line, const SignedMonomial& monomial) {
  line += ' ';
  append_monomial(line, monomial.variables, monomial.sign > 0 ? '+' : '-');
}

void append_interval(std::string& line, const Interval& x) {
  if (is_empty(x)) {
    line += " empty";
    return;
  }
  append_number(line, x.lower);
  append_number(line, x.upper);
}

void append_box(std::string& line, const Box& box) {
  for (const Interval& side : box) append_interval(line, side);
}

}  // namespace

std::string_view name_of(Argument argument) {
  switch (argument) {
    case Argument::hull_of_equation:
      return "hull_equation";
    case Argument::hull_of_inequality:
      return "hull_inequality";
    case Argument::expansion:
      return "expansion";
    case Argument::expansion_row:
      return "expansion_row";
    case Argument::square_row:
      return "square_row";
    case Argument::polytope:
      return "polytope";
    case Argument::mean_value_row:
      return "mean_value_row";
    case Argument::bernstein_row:
      return "bernstein_row";
    case Argument::cases:
      return "cases";
    case Argument::otherwise:
      return "otherwise";
    case Argument::join:
      break;
  }
  return "join";
}

void ProofLog::write(std::string_view line) {
  *out_ << line << '\n';
  hasher_.add(line);
  hasher_.add("\n");
}

void ProofLog::begin(const Box& search_box) {
  write("gcslab-proof 1");
  line_ = "box";
  append_box(line_, search_box);
  write(line_);
}

void ProofLog::term(const ExpressionPlace& place) {
  line_ = place.is_equation ? "term equation" : "term inequality";
  append_integer(line_, place.function);
  for (const int operand : place.operands) append_integer(line_, operand);
  write(line_);
}

void ProofLog::start(std::uint64_t id, const Box& box) {
  line_ = "start";
  append_integer(line_, id);
  append_box(line_, box);
  write(line_);
}

void ProofLog::root(std::size_t number, const CertifiedRoot& root) {
  line_ = "root";
  append_integer(line_, number);
  append_box(line_, root.box);
  line_ += " U";
  append_box(line_, root.uniqueness_box);
  write(line_);
}

void ProofLog::step(const ProofStep& step) {
  line_ = name_of(step.argument);
  switch (step.argument) {
    case Argument::expansion:
      append_box(line_, step.terms);
      break;
    case Argument::otherwise:
    case Argument::join:
      break;
    case Argument::cases:
      append_integer(line_, step.variable);
      append_number(line_, step.result.lower);
      break;
    case Argument::hull_of_equation:
    case Argument::hull_of_inequality:
      append_integer(line_, step.function);
      [[fallthrough]];
    default:
      append_integer(line_, step.variable);
      append_interval(line_, step.result);
  }
  for (const double multiplier : step.multipliers) append_number(line_, multiplier);
  for (const auto& [multiple, multiplier] : step.multiples) {
    line_ += multiple.is_quotient ? " q" : " m";
    append_integer(line_, multiple.equation);
    append_monomial(line_, multiple.variables);
    line_ += " :";
    append_number(line_, multiplier);
  }
  if (step.argument == Argument::polytope) line_ += " ;";
  for (const ProductMultiplier& product : step.products) {
    line_ += product.is_square ? " s" : " p";
    for (const SignedMonomial& factor : product.factors) append_signed(line_, factor);
    line_ += " :";
    append_number(line_, product.multiplier);
  }
  for (const StripMultiplier& strip : step.strips) {
    line_ += " g";
    append_integer(line_, strip.term);
    append_number(line_, strip.slope);
    line_ += " :";
    append_number(line_, strip.multiplier);
  }
  write(line_);
}

void ProofLog::node(std::uint64_t id, const ProofTrace& trace) {
  line_ = "node";
  append_integer(line_, id);
  write(line_);
  for (const ProofStep& taken : trace.steps()) step(taken);
}

void ProofLog::theorem(std::string_view name) {
  line_ = "theorem ";
  line_ += name;
  write(line_);
}

void ProofLog::end_empty() { write("end empty"); }
void ProofLog::end_undecided() { write("end undecided"); }
void ProofLog::end_pending() { write("end pending"); }

void ProofLog::end_counted(const std::vector<Interval>& excluded) {
  line_ = "end counted";
  for (const Interval& x : excluded) append_interval(line_, x);
  write(line_);
}

void ProofLog::end_covered(std::size_t root) {
  line_ = "end covered";
  append_integer(line_, root);
  write(line_);
}

void ProofLog::end_cut(std::size_t variable, double point, std::uint64_t lower, std::uint64_t upper) {
  line_ = "end cut";
  append_integer(line_, variable);
  append_number(line_, point);
  append_integer(line_, lower);
  append_integer(line_, upper);
  write(line_);
}

void ProofLog::finish() {
  write("end");
  *out_ << "hash " << hasher_.hash() << '\n';
}

}  // namespace gcslab
