#pragma once

// Where a number comes from: which program, built how, on which machine, when.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace gcslab {

/// {"commit", "dirty", "compiler", "flags", "cpu", "libraries": {name: version}, "seed", "started"}. The
/// commit and whether files differed from it were recorded when the program was built; "unknown" when it was
/// built without git.
nlohmann::ordered_json provenance(std::uint64_t seed, const std::string& started);

/// The present moment in UTC, "2024-05-06T07:08:09Z".
std::string utc_now();

}  // namespace gcslab
