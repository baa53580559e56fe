#include "base/error.h"

namespace gcslab {

std::string SourceLocation::text() const { return line > 0 ? file + ":" + std::to_string(line) : file; }

}  // namespace gcslab
