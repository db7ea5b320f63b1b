#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille::io {

/// True if the bytes begin as those of a gzip file.
bool is_gzip(std::span<const std::byte> bytes);

/// What a gzip file holds.
/// @param name  stands for the path in errors
/// @throws FileError if it is damaged, cut short, or holds more than 2 GiB
std::vector<std::byte> gunzip(std::span<const std::byte> bytes, const std::string& name);

/// The bytes as a gzip file, packed fast rather than small.
/// @throws std::length_error if they are 4 GiB or more
std::string gzip(std::string_view bytes);

}  // namespace quadrille::io
