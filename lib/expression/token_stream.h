#pragma once

// The words of a text file, for the readers of equation systems: names, numbers and signs, with their lines.
//
// Words are cut off as they are asked for, so that a reader may leave the end of a file alone. Comments and
// white space separate words and are otherwise ignored.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "interval/rational.h"

namespace gcslab {

struct Token {
  enum class Kind { end, name, number, sign };

  Kind kind = Kind::end;
  std::string_view text;  ///< empty at the end of the file
  int line = 1;

  bool is(std::string_view sign) const { return kind == Kind::sign && text == sign; }
};

/// What the words of a language look like. Names begin with a letter or underscore and go on with letters,
/// digits and underscores; numbers are decimal (2, .5, 1.e-3); every other character is a sign.
struct LexicalRules {
  std::string_view line_comment = {};             ///< begins a comment up to the end of the line
  std::string_view comment_opening = {};          ///< begins a comment
  std::string_view comment_closing = {};          ///< ends it
  std::vector<std::string_view> long_signs = {};  ///< signs of two characters
  std::string_view more_name_characters = {};     ///< besides letters, digits and _, after the first
  bool hexadecimal_doubles = false;  ///< '#' and 16 hexadecimal digits are a number: the bits of a double
};

class TokenStream {
 public:
  /// The text must outlive the stream and all tokens. `file` is for messages.
  TokenStream(std::string_view text, std::string file, LexicalRules rules);

  /// The word `ahead` places on; the end again and again after the last.
  const Token& peek(std::size_t ahead = 0);
  Token next();
  /// Takes the next word if it is that sign.
  bool accept(std::string_view sign);
  /// Takes that sign, or fails with "expected ';' after ..., not ...".
  void expect(std::string_view sign, std::string_view where);

  /// Places can be returned to.
  std::size_t position() const { return position_; }
  void return_to(std::size_t position) { position_ = position; }

  [[noreturn]] void fail(int line, const std::string& message) const;
  /// Fails at the next word: "expected <what>, not <word>".
  [[noreturn]] void fail_expected(std::string_view what);
  /// Runs `build` and adds the line to its InputError.
  template <class Build>
  auto at_line(int line, const Build& build) const {
    try {
      return build();
    } catch (const InputError& error) {
      fail(line, error.what());
    }
  }

  /// Lives while a reader is inside a pair of parentheses, a loop, ...; fails when there are too many.
  class Nesting {
   public:
    explicit Nesting(TokenStream& tokens);
    ~Nesting() { --tokens_.depth_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;

   private:
    TokenStream& tokens_;
  };

 private:
  Token cut();
  void skip_blanks();
  bool skip_comment();
  std::size_t number_length() const;
  std::size_t sign_length() const;
  bool starts_with(std::string_view prefix) const { return text_.substr(at_).starts_with(prefix); }
  char character(std::size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  std::string_view text_;
  std::string file_;
  LexicalRules rules_;
  std::size_t at_ = 0;  ///< of the text that is not cut yet
  int line_ = 1;
  std::vector<Token> tokens_;
  std::size_t position_ = 0;
  int depth_ = 0;
};

/// "'x'", "the end of the file"; unprintable characters as hexadecimal numbers.
std::string described(const Token& token);

/// The exact value of a number. Throws InputError, without a place, for what is none or no finite double.
Rational value_of(const Token& number);

}  // namespace gcslab
