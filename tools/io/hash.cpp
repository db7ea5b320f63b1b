// Only the header of xxHash is used, so that no program needs its library to run.
#define XXH_INLINE_ALL
#include "io/hash.hpp"

#include <fmt/format.h>
#include <xxhash.h>

namespace quadrille::io {

std::string hash_text(const std::string& text) {
  return fmt::format("{:016x}", XXH3_64bits(text.data(), text.size()));
}

}  // namespace quadrille::io
