#include "quadrille/detector/printable.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace quadrille {
namespace {

/// Bytes of the UTF-8 character at the start of a text; 0 if the bytes are no valid character or a
/// control character.
std::size_t size_of_character(std::string_view text) {
  const auto byte = [&](std::size_t i) -> std::uint32_t {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
  };
  const std::uint32_t first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  if (first < 0xc2 || first > 0xf4) return 0;
  const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  std::uint32_t code = first & (0x7fu >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3f);
  }
  // Codes below these limits would fit into fewer bytes; codes from 0x80 to 0x9f are control
  // characters.
  constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0xa0, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xd800 && code <= 0xdfff;
  return code < kLeast[size] || is_surrogate || code > 0x10ffff ? 0 : size;
}

std::string escape(char byte) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  const auto value = static_cast<unsigned char>(byte);
  return {'\\', 'x', kDigits[value >> 4], kDigits[value & 15]};
}

}  // namespace

std::string printable(std::string_view bytes, std::size_t max) {
  constexpr std::string_view kEllipsis = "...";
  std::string text;
  std::size_t fits = 0;  // Longest prefix that leaves room for the ellipsis [bytes].
  while (!bytes.empty()) {
    const std::size_t size = size_of_character(bytes);
    text += size > 0 ? std::string(bytes.substr(0, size)) : escape(bytes.front());
    bytes.remove_prefix(std::max<std::size_t>(size, 1));
    if (text.size() > max) return text.substr(0, fits).append(kEllipsis);
    if (text.size() + kEllipsis.size() <= max) fits = text.size();
  }
  return text;
}

}  // namespace quadrille
