#pragma once

// The words of a proof file, line by line. Whatever is not as it should be throws Refused with file and line.

#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "base/content_hash.h"
#include "interval/interval.h"
#include "verifier/refusal.h"

namespace gcslab::verifier {

/// The double that a text spells in hexadecimal digits or as inf; false for other texts.
bool read_hexadecimal(std::string_view text, double& value);

class ProofReader {
 public:
  /// Reads from `stream`, which must outlive it. `name` is the file's, for messages.
  ProofReader(std::istream& stream, std::string name) : stream_(&stream), name_(std::move(name)) {}

  /// Goes to the next line; false at the end of the file.
  bool next_line();
  bool at_end_of_line() const { return position_ == line_.size(); }

  /// The next word of the line; there must be one.
  std::string_view word();
  std::uint64_t integer();
  /// An integer below `limit`.
  std::size_t index(std::size_t limit, const char* what);
  double number();
  /// Two bounds with lower <= upper.
  Interval interval();
  /// Two bounds, or "empty".
  Interval interval_or_empty();
  Box box(std::size_t variables);
  /// Indices below `limit` in a word that joins them by '*'.
  std::vector<std::size_t> joined_indices(std::string_view word, std::size_t limit, const char* what) const;
  /// That word and no other.
  void expect(std::string_view word);
  /// Nothing may be left on the line.
  void end_line();

  /// The content hash of all lines before this one.
  std::string hash_before() const { return hasher_.hash(); }

  [[noreturn]] void refuse(const std::string& reason) const;

 private:
  std::string_view peek() const;
  std::uint64_t integer_from(std::string_view text) const;
  std::size_t checked(std::uint64_t value, std::size_t limit, const char* what) const;

  std::istream* stream_;
  std::string name_;
  std::string line_;
  std::size_t position_ = 0;
  std::uint64_t number_of_line_ = 0;
  ContentHasher hasher_;
};

}  // namespace gcslab::verifier
