#include "box_solver/proof_log.h"

#include <array>
#include <charconv>
#include <ostream>
#include <string_view>

namespace gcslab {
namespace {

std::string_view word_of(Argument argument) {
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

/// " " and the number in hexadecimal digits, exactly.
void write_number(std::ostream& out, double value) {
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
  out.write(text.data(), result.ptr - text.data());
}

void write_monomial(std::ostream& out, const std::vector<std::uint32_t>& variables) {
  char separator = ' ';
  for (const std::uint32_t variable : variables) {
    out << separator << variable;
    separator = '*';
  }
}

void write_interval(std::ostream& out, const Interval& x) {
  if (is_empty(x)) {
    out << " empty";
    return;
  }
  write_number(out, x.lower);
  write_number(out, x.upper);
}

}  // namespace

void ProofLog::write_box(const Box& box) {
  for (const Interval& side : box) write_interval(*out_, side);
}

void ProofLog::begin(const Box& search_box) {
  *out_ << "gcslab-proof 1\nbox";
  write_box(search_box);
  *out_ << '\n';
}

void ProofLog::start(std::uint64_t id, const Box& box) {
  *out_ << "start " << id;
  write_box(box);
  *out_ << '\n';
}

void ProofLog::root(std::size_t number, const CertifiedRoot& root) {
  *out_ << "root " << number;
  write_box(root.box);
  *out_ << " U";
  write_box(root.uniqueness_box);
  *out_ << '\n';
}

void ProofLog::write_step(const ProofStep& step) {
  *out_ << word_of(step.argument);
  switch (step.argument) {
    case Argument::expansion:
    case Argument::otherwise:
    case Argument::join:
      break;
    case Argument::cases:
      *out_ << ' ' << step.variable;
      write_number(*out_, step.result.lower);
      break;
    case Argument::hull_of_equation:
    case Argument::hull_of_inequality:
      *out_ << ' ' << step.function;
      [[fallthrough]];
    default:
      *out_ << ' ' << step.variable;
      write_interval(*out_, step.result);
  }
  for (const double multiplier : step.multipliers) write_number(*out_, multiplier);
  if (step.argument == Argument::polytope) *out_ << " ;";
  for (const ProductMultiplier& product : step.products) {
    write_monomial(*out_, product.first);
    write_monomial(*out_, product.second);
    *out_ << ' ' << product.s << ' ' << product.t;
    write_number(*out_, product.multiplier);
  }
  *out_ << '\n';
}

void ProofLog::node(std::uint64_t id, const ProofTrace& trace) {
  *out_ << "node " << id << '\n';
  for (const ProofStep& step : trace.steps()) write_step(step);
}

void ProofLog::end_empty() { *out_ << "end empty\n"; }
void ProofLog::end_covered(std::size_t root) { *out_ << "end covered " << root << '\n'; }
void ProofLog::end_undecided() { *out_ << "end undecided\n"; }
void ProofLog::end_pending() { *out_ << "end pending\n"; }

void ProofLog::end_cut(std::size_t variable, double point, std::uint64_t lower, std::uint64_t upper) {
  *out_ << "end cut " << variable;
  write_number(*out_, point);
  *out_ << ' ' << lower << ' ' << upper << '\n';
}

void ProofLog::finish() { *out_ << "end\n"; }

}  // namespace gcslab
