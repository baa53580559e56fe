#pragma once

// The options `arithmetic` and `bits`, shared by the bounds that are templates over the number type.

#include <vector>

#include "base/option.h"
#include "interval/arithmetic.h"

namespace gcslab {

/// The declarations of `arithmetic` and `bits`, followed by a bound's own options.
std::vector<OptionSpec> with_arithmetic_options(std::vector<OptionSpec> own = {});

/// Calls make.operator()<T>(bits) for the number type that the options choose.
template <class Make>
auto make_for_arithmetic(const Options& options, Make make) {
  const int bits = static_cast<int>(options.integer("bits"));
  return with_arithmetic(arithmetic_from_name(options.word("arithmetic")),
                         [&]<class T>(std::type_identity<T>) { return make.template operator()<T>(bits); });
}

}  // namespace gcslab
