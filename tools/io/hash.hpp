#pragma once

#include <string>

namespace quadrille::io {

/// XXH3 of a text with 64 bits, as 16 hexadecimal digits: it tells texts apart, and is the same on
/// all machines. It keeps nobody from making two texts that have the same one.
std::string hash_text(const std::string& text);

}  // namespace quadrille::io
