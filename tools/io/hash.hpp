#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace quadrille::io {

/// XXH3 with 64 bits: a number that tells texts and messages apart, the same on all machines. It
/// keeps nobody from making two that have the same one.
std::uint64_t hash_of(std::span<const std::byte> bytes);

/// The same of a text, as 16 hexadecimal digits.
std::string hash_text(const std::string& text);

}  // namespace quadrille::io
