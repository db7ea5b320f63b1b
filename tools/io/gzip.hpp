#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille::io {

/// Returns true if the bytes begin like a gzip file.
bool is_gzip(std::span<const std::byte> bytes);

/// Decompresses a gzip file.
/// @param name  name of the file in errors
/// @throws FileError if it is damaged, truncated, or holds more than 2 GiB
std::vector<std::byte> gunzip(std::span<const std::byte> bytes, const std::string& name);

/// Compresses bytes to a gzip file, fast rather than small.
/// @throws std::length_error if there are 4 GiB or more
std::string gzip(std::string_view bytes);

}  // namespace quadrille::io
