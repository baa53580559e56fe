#include "base/content_hash.h"

#include <fmt/format.h>
#include <xxhash.h>

namespace gcslab {
namespace {

std::string digits(const XXH128_hash_t& hash) {
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace

std::string content_hash(std::string_view text) { return digits(XXH3_128bits(text.data(), text.size())); }

ContentHasher::ContentHasher() : state_(XXH3_createState()) { XXH3_128bits_reset(state_.get()); }

void ContentHasher::add(std::string_view part) {
  XXH3_128bits_update(state_.get(), part.data(), part.size());
}

std::string ContentHasher::hash() const { return digits(XXH3_128bits_digest(state_.get())); }

void ContentHasher::Deleter::operator()(XXH3_state_s* state) const { XXH3_freeState(state); }

}  // namespace gcslab
