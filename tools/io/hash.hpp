#pragma once

#include <string>

namespace quadrille::io {

/// Returns the 64-bit XXH3 hash of a text as 16 hexadecimal digits, the same on all machines. It is
/// not cryptographic: two texts with the same hash can be made on purpose.
std::string hash_text(const std::string& text);

}  // namespace quadrille::io
