#pragma once

// Whole files, read and written. A file written here is either the old one or the new one, never half of
// either.

#include <filesystem>
#include <string>
#include <string_view>

namespace gcslab {

/// The whole text of a file. Throws InputError when it cannot be read.
std::string read_file(const std::filesystem::path& path);

/// Writes beside the target, flushes to disk and renames over it. A target that is no regular file (a device,
/// a pipe) is written in place. Throws InputError when a byte cannot be written; the old file is then
/// untouched.
void write_file_atomically(const std::filesystem::path& path, std::string_view text);

/// Throws InputError when a file of that name could not be written now: before long work, not after it.
void check_writable(const std::filesystem::path& path);

/// Makes the folder and its parents. Throws InputError, with the cause, when that is not possible.
void make_folder(const std::filesystem::path& folder);

}  // namespace gcslab
