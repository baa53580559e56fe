#pragma once

// The file formats of equation systems besides our own YAML, in one list: a new format is a file with its
// reader or writer, and a line in system_formats.cpp.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/registry.h"
#include "expression/equation_system.h"

namespace gcslab {

struct SystemFormat {
  std::string name;
  std::string summary;
  std::vector<std::string> extensions;  ///< of file names, with the dot; the first is the usual one
  /// Reads a text; `file` is for messages. Null when the format is only written.
  EquationSystem (*read)(std::string_view text, const std::string& file);
  /// Null when the format is only read.
  std::string (*write)(const EquationSystem& system);
};

const Registry<SystemFormat>& system_formats();

/// The format that reads files of that extension, or nullptr.
const SystemFormat* format_of_file(const std::filesystem::path& path);

/// Reads a file in the format of its extension. Throws InputError with file and line, or for an extension
/// that no format has.
EquationSystem read_system_file(const std::filesystem::path& path);

}  // namespace gcslab
