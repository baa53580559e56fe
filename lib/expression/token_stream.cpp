#include "expression/token_stream.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/check.h"
#include "expression/parser.h"

namespace gcslab {
namespace {

/// Messages quote no more of a word than this.
constexpr std::size_t kQuotedLength = 40;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_hexadecimal(char c) { return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f'; }

Rational value_of_bits(std::string_view digits) {
  std::uint64_t bits = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), bits, 16);
  const double value = std::bit_cast<double>(bits);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) {
    throw InputError("'#" + std::string(digits.substr(0, kQuotedLength)) + "' are not the bits of a double");
  }
  return rational_from_double(value);
}

}  // namespace

std::string described(const Token& token) {
  if (token.kind == Token::Kind::end) return "the end of the file";
  std::string result = "'";
  for (const char c : token.text.substr(0, kQuotedLength)) {
    if (c >= ' ' && c <= '~') {
      result += c;
    } else {
      constexpr std::string_view kDigits = "0123456789abcdef";
      const auto code = static_cast<unsigned char>(c);
      result += std::string("\\x") + kDigits[code / 16] + kDigits[code % 16];
    }
  }
  return result + (token.text.size() > kQuotedLength ? "...'" : "'");
}

Rational value_of(const Token& number) {
  GCSLAB_CHECK(number.kind == Token::Kind::number);
  if (number.text.front() == '#') return value_of_bits(number.text.substr(1));
  return rational_from_text(number.text);
}

TokenStream::TokenStream(std::string_view text, std::string file, LexicalRules rules)
    : text_(text), file_(std::move(file)), rules_(std::move(rules)) {}

const Token& TokenStream::peek(std::size_t ahead) {
  while (tokens_.size() <= position_ + ahead) {
    if (!tokens_.empty() && tokens_.back().kind == Token::Kind::end) return tokens_.back();
    tokens_.push_back(cut());
  }
  return tokens_[position_ + ahead];
}

Token TokenStream::next() {
  const Token token = peek();
  if (token.kind != Token::Kind::end) ++position_;
  return token;
}

bool TokenStream::accept(std::string_view sign) {
  if (!peek().is(sign)) return false;
  ++position_;
  return true;
}

void TokenStream::expect(std::string_view sign, std::string_view where) {
  if (!accept(sign)) fail_expected("'" + std::string(sign) + "' " + std::string(where));
}

void TokenStream::fail(int line, const std::string& message) const {
  throw InputError(SourceLocation{file_, line}, message);
}

void TokenStream::fail_expected(std::string_view what) {
  const Token& found = peek();
  fail(found.line, "expected " + std::string(what) + ", not " + described(found));
}

TokenStream::Nesting::Nesting(TokenStream& tokens) : tokens_(tokens) {
  if (tokens.depth_ >= kMaximumNesting) tokens.fail(tokens.peek().line, "nested too deeply");
  ++tokens.depth_;
}

bool TokenStream::skip_comment() {
  if (!rules_.line_comment.empty() && starts_with(rules_.line_comment)) {
    at_ = std::min(text_.find_first_of("\n\r", at_), text_.size());
    return true;
  }
  if (rules_.comment_opening.empty() || !starts_with(rules_.comment_opening)) return false;
  const std::size_t end = text_.find(rules_.comment_closing, at_ + rules_.comment_opening.size());
  if (end == std::string_view::npos) {
    fail(line_,
         "the comment that begins here has no end; expected '" + std::string(rules_.comment_closing) + "'");
  }
  line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                       text_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
  at_ = end + rules_.comment_closing.size();
  return true;
}

void TokenStream::skip_blanks() {
  while (at_ < text_.size()) {
    if (is_blank(text_[at_])) {
      if (text_[at_] == '\n') ++line_;
      ++at_;
    } else if (!skip_comment()) {
      return;
    }
  }
}

/// A second point ends a number, so that 1..5 is two of them.
std::size_t TokenStream::number_length() const {
  std::size_t length = 0;
  const auto digits = [&] {
    while (is_digit(character(length))) ++length;
  };
  digits();
  if (character(length) == '.' && character(length + 1) != '.') ++length;
  digits();
  if (character(length) != 'e' && character(length) != 'E') return length;
  const bool has_sign = character(length + 1) == '+' || character(length + 1) == '-';
  if (!is_digit(character(length + (has_sign ? 2 : 1)))) return length;
  length += has_sign ? 2 : 1;
  digits();
  return length;
}

std::size_t TokenStream::sign_length() const {
  const bool is_long =
      std::ranges::any_of(rules_.long_signs, [this](std::string_view sign) { return starts_with(sign); });
  return is_long ? 2 : 1;
}

Token TokenStream::cut() {
  skip_blanks();
  if (at_ >= text_.size()) return {Token::Kind::end, {}, line_};
  const char first = character(0);
  Token::Kind kind = Token::Kind::sign;
  std::size_t length = 1;
  if (is_letter(first)) {
    kind = Token::Kind::name;
    const auto belongs = [this](char c) {
      return is_letter(c) || is_digit(c) ||
             (c != '\0' && rules_.more_name_characters.find(c) != std::string_view::npos);
    };
    while (belongs(character(length))) ++length;
  } else if (is_digit(first) || (first == '.' && is_digit(character(1)))) {
    kind = Token::Kind::number;
    length = number_length();
  } else if (first == '#' && rules_.hexadecimal_doubles && is_hexadecimal(character(1))) {
    kind = Token::Kind::number;
    while (is_hexadecimal(character(length))) ++length;
  } else {
    length = sign_length();
  }
  const Token token{kind, text_.substr(at_, length), line_};
  at_ += length;
  return token;
}

}  // namespace gcslab
