#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace quadrille::io {

/// Returns the 64-bit XXH3 hash, which distinguishes texts and messages and is the same on all
/// machines. It is not cryptographic: two inputs with the same hash can be made on purpose.
std::uint64_t hash_of(std::span<const std::byte> bytes);

/// Returns the hash of a text as 16 hexadecimal digits.
std::string hash_text(const std::string& text);

}  // namespace quadrille::io
