#pragma once

// Directed rounding on x86-64: scopes that set the rounding mode of SSE and AVX arithmetic, and barriers that
// keep an operation inside its scope.
//
// A scope sets the mode, clears flush-to-zero and denormals-are-zero (both would break outward rounding near
// zero) and restores the caller's control word on exit. Compilers do not know of rounding modes: they fold,
// merge and move floating-point operations as if there were one. So a scope alone proves nothing; each
// directed operation also passes its operands and its result through `opaque`, which no compiler sees through
// or moves across a scope's border.

#include <cstdint>
#include <immintrin.h>

#ifdef __FAST_MATH__
#error "gcslab needs IEEE arithmetic: compile without -ffast-math"
#endif
#if defined(__GNUC__) && !defined(__clang__) && !defined(__ROUNDING_MATH__)
#error "gcslab needs directed rounding: compile with -frounding-math (link to the target gcslab_options)"
#endif
#if !defined(__AVX2__) || !defined(__FMA__)
#error "gcslab needs AVX2 and FMA: compile with -march=x86-64-v3"
#endif

namespace gcslab {

/// The values of the rounding field of the control register MXCSR.
enum class RoundingMode : std::uint32_t {
  nearest = 0x0000,
  downward = 0x2000,
  upward = 0x4000,
  to_zero = 0x6000
};

namespace rounding_detail {

inline constexpr std::uint32_t kRoundingField = 0x6000;
inline constexpr std::uint32_t kFlushToZero = 0x8000;
inline constexpr std::uint32_t kDenormalsAreZero = 0x0040;
inline constexpr std::uint32_t kSetByScope = kRoundingField | kFlushToZero | kDenormalsAreZero;

inline std::uint32_t read_control() {
  std::uint32_t control = 0;
  asm volatile("stmxcsr %0" : "=m"(control) : : "memory");
  return control;
}

inline void write_control(std::uint32_t control) { asm volatile("ldmxcsr %0" : : "m"(control) : "memory"); }

}  // namespace rounding_detail

/// The mode in which this thread rounds now.
inline RoundingMode rounding_mode() {
  return static_cast<RoundingMode>(rounding_detail::read_control() & rounding_detail::kRoundingField);
}

inline bool rounding_is_nearest() { return rounding_mode() == RoundingMode::nearest; }

/// While alive, this thread rounds in one mode. Scopes nest; one inside another of the same mode costs next
/// to nothing.
template <RoundingMode mode>
class RoundingScope {
 public:
  RoundingScope() : saved_(rounding_detail::read_control()) {
    if (changes()) rounding_detail::write_control(wanted());
  }
  ~RoundingScope() {
    if (changes()) rounding_detail::write_control(saved_);
  }
  RoundingScope(const RoundingScope&) = delete;
  RoundingScope& operator=(const RoundingScope&) = delete;

 private:
  std::uint32_t wanted() const {
    return (saved_ & ~rounding_detail::kSetByScope) | static_cast<std::uint32_t>(mode);
  }
  bool changes() const { return wanted() != saved_; }

  std::uint32_t saved_;
};

using UpwardRounding = RoundingScope<RoundingMode::upward>;
using NearestRounding = RoundingScope<RoundingMode::nearest>;

/// The same value, of which the compiler knows nothing more.
inline double opaque(double value) {
  asm volatile("" : "+x"(value));
  return value;
}
inline __m128d opaque(__m128d value) {
  asm volatile("" : "+x"(value));
  return value;
}
inline __m256d opaque(__m256d value) {
  asm volatile("" : "+x"(value));
  return value;
}

/// Sum, product and quotient in the mode of the scope around them.
inline double rounded_add(double x, double y) { return opaque(opaque(x) + opaque(y)); }
inline double rounded_subtract(double x, double y) { return opaque(opaque(x) - opaque(y)); }
inline double rounded_multiply(double x, double y) { return opaque(opaque(x) * opaque(y)); }
inline double rounded_divide(double x, double y) { return opaque(opaque(x) / opaque(y)); }

}  // namespace gcslab
