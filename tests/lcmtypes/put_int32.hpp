#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille::test {

/// Overwrites a big-endian 32-bit number.
inline void put_int32(std::vector<std::byte>& bytes, std::size_t at, std::int32_t value) {
  for (int i = 0; i < 4; ++i) {
    bytes[at + static_cast<std::size_t>(i)] =
        static_cast<std::byte>(static_cast<std::uint32_t>(value) >> (24 - 8 * i) & 0xff);
  }
}

}  // namespace quadrille::test
