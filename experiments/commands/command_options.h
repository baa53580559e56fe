#pragma once

// Pieces of the command line that several commands share.

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

namespace gcslab {

/// Accepts finite numbers above 0.
CLI::Validator positive_number();

/// The texts of `--set option=value ...`. Throws InputError for a missing '=' or an option given twice.
std::map<std::string, std::string> option_texts(const std::vector<std::string>& assignments);

}  // namespace gcslab
