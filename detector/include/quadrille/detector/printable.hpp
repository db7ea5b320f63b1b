#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "quadrille/detector/export.hpp"

namespace quadrille {

/// Largest length of a line of output for people, and of a path within it [bytes].
inline constexpr std::size_t kMaxLine = 1000, kMaxPath = 400;

/// Makes arbitrary bytes, such as those of a file, a message or an argument, fit to be shown within
/// one line: control characters and invalid UTF-8 become a backslash, x and two hexadecimal digits,
/// and "..." replaces the end of a longer text. Applied to its own result, it changes nothing.
/// @param max  largest length of the result, at least 3 [bytes]
QUADRILLE_EXPORT std::string printable(std::string_view bytes, std::size_t max = 80);

}  // namespace quadrille
