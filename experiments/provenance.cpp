#include "experiments/provenance.h"

#include <boost/version.hpp>
#include <chrono>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fstream>
#include <gmp.h>
#include <mpfr.h>
#include <nlohmann/json.hpp>

#include "gcslab_build_info.h"  // made by record_build.cmake at every build

namespace gcslab {
namespace {

using Json = nlohmann::ordered_json;

std::string compiler_name() {
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "gcc " __VERSION__;
#else
  return "unknown";
#endif
}

std::string cpu_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string boost_version() {
  return fmt::format("{}.{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100);
}

}  // namespace

Json provenance(std::uint64_t seed, const std::string& started) {
  static const std::string cpu = cpu_name();
  return {{"commit", build_info::kCommit},
          {"dirty", build_info::kDirty},
          {"compiler", compiler_name()},
          {"flags", build_info::kFlags},
          {"cpu", cpu},
          {"libraries", {{"gmp", gmp_version}, {"mpfr", mpfr_get_version()}, {"boost", boost_version()}}},
          {"seed", seed},
          {"started", started}};
}

std::string utc_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

}  // namespace gcslab
