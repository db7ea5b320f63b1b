#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace quadrille::io {

/// True if the bytes begin as those of a gzip file.
bool is_gzip(std::span<const std::byte> bytes);

/// What a gzip file holds.
/// @param name  stands for the path in errors
/// @throws FileError if it is damaged, cut short, or holds more than 2 GiB
std::vector<std::byte> gunzip(std::span<const std::byte> bytes, const std::string& name);

}  // namespace quadrille::io
