#include "expression/phc_reader.h"
#include "fuzz/fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gcslab;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  survive([&] {
    const EquationSystem system = read_phc(text, "fuzz");
    check_round_trip(system, "phc");
    check_round_trip(system, "minibex");
  });
  return 0;
}
