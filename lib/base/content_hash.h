#pragma once

// Names for contents: equal text, equal name. Used to know a job again and to notice an edited file; not a
// signature.

#include <string>
#include <string_view>

namespace gcslab {

/// 128-bit XXH3 of the text as 32 hexadecimal digits.
std::string content_hash(std::string_view text);

}  // namespace gcslab
