#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "quadrille/detector/export.hpp"

namespace quadrille {

/// Bytes of a whole line for people, and of a path in it, at most.
inline constexpr std::size_t kMaxLine = 1000, kMaxPath = 400;

/// Bytes of any kind, such as a file, a message or an argument holds, as part of one line for
/// people: control characters, and bytes that are no UTF-8, become \xNN; the end of a longer text
/// "...". A text that it returned stays as it is.
/// @param max  bytes of the result at most, at least 3
QUADRILLE_EXPORT std::string printable(std::string_view bytes, std::size_t max = 80);

}  // namespace quadrille
