// Only the header of xxHash is used, so that no program needs its library to run.
#define XXH_INLINE_ALL
#include "io/hash.hpp"

#include <fmt/format.h>
#include <xxhash.h>

namespace quadrille::io {

std::uint64_t hash_of(std::span<const std::byte> bytes) {
  return XXH3_64bits(bytes.data(), bytes.size());
}

std::string hash_text(const std::string& text) {
  return fmt::format("{:016x}", hash_of(std::as_bytes(std::span(text))));
}

}  // namespace quadrille::io
