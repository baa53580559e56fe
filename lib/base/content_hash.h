#pragma once

// Names for contents: equal text, equal name. Used to know a job again and to notice an edited file; not a
// signature.

#include <memory>
#include <string>
#include <string_view>

struct XXH3_state_s;

namespace gcslab {

/// 128-bit XXH3 of the text as 32 hexadecimal digits.
std::string content_hash(std::string_view text);

/// The same for a text that comes in parts.
class ContentHasher {
 public:
  ContentHasher();
  void add(std::string_view part);
  /// The content_hash of all parts so far.
  std::string hash() const;

 private:
  struct Deleter {
    void operator()(XXH3_state_s* state) const;
  };
  std::unique_ptr<XXH3_state_s, Deleter> state_;
};

}  // namespace gcslab
