#include "expression/system_formats.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "expression/bertini_writer.h"
#include "expression/json_writer.h"
#include "expression/minibex_reader.h"
#include "expression/minibex_writer.h"
#include "expression/phc_reader.h"
#include "expression/phc_writer.h"

namespace gcslab {
namespace {

std::vector<std::string> readable_extensions() {
  std::vector<std::string> result;
  for (const SystemFormat& format : system_formats().entries()) {
    if (format.read != nullptr)
      result.insert(result.end(), format.extensions.begin(), format.extensions.end());
  }
  return result;
}

}  // namespace

const Registry<SystemFormat>& system_formats() {
  static const Registry<SystemFormat> formats(
      "format", {
                    {"phc", "input of PHCpack: polynomials", {".phc"}, read_phc, write_phc},
                    {"minibex", "language of IBEX", {".bch", ".mbx"}, read_minibex, write_minibex},
                    {"bertini", "input of Bertini: polynomials", {".bertini"}, nullptr, write_bertini},
                    {"json", "exact, for programs", {".json"}, nullptr, write_json},
                });
  return formats;
}

const SystemFormat* format_of_file(const std::filesystem::path& path) {
  const std::vector<SystemFormat>& formats = system_formats().entries();
  const auto found = std::ranges::find_if(formats, [&](const SystemFormat& format) {
    return format.read != nullptr &&
           std::ranges::find(format.extensions, path.extension().string()) != format.extensions.end();
  });
  return found == formats.end() ? nullptr : &*found;
}

EquationSystem read_system_file(const std::filesystem::path& path) {
  const SystemFormat* format = format_of_file(path);
  if (format == nullptr) {
    throw InputError({path.string(), 0},
                     fmt::format("no format reads the extension '{}'; expected one of {}",
                                 path.extension().string(), fmt::join(readable_extensions(), ", ")));
  }
  return format->read(read_file(path), path.string());
}

}  // namespace gcslab
