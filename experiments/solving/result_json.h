#pragma once

// The result of `solve` as JSON (README.md, "Results"), and the state of an interrupted search as a file.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "box_solver/search.h"
#include "certification/root_refinement.h"

namespace gcslab {

using Json = nlohmann::ordered_json;

/// [["lo", "hi"], ...], each number a hexadecimal floating-point literal.
Json box_to_json(const Box& box);
/// The inverse. `where` names the place in error messages. Throws InputError.
Box box_from_json(const Json& json, const std::string& where);

/// The keys "solutions" and "undecided". With `bits` > 53 each root is refined to that many bits.
Json solutions_json(const SystemFunctions& functions, const SearchResult& result, int bits);
Json undecided_json(const SearchResult& result);

/// What --pending writes and --resume reads: the boxes left, and all that is known already. `problem_hash`
/// ties the file to its problem.
void write_pending(const std::filesystem::path& path, const std::string& problem_hash, const Box& search_box,
                   const SearchResult& result);
/// Throws InputError when the file is no such file or belongs to another problem or box.
SearchStart read_pending(const std::filesystem::path& path, const std::string& problem_hash,
                         const Box& search_box);

/// Adds the key "content_hash": the hash of everything else as compact text with its keys sorted.
void seal(Json& result);

}  // namespace gcslab
