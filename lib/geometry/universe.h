#pragma once

// Where figures live: the Euclidean plane or space.

#include <cstddef>

namespace gcslab {

enum class Universe { plane, space };

constexpr std::size_t dimension(Universe universe) { return universe == Universe::plane ? 2 : 3; }

}  // namespace gcslab
