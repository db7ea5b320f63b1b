#pragma once

#include <string>

#include "picture/image.hpp"

namespace quadrille {

/// Writes an 8 bit RGB PNG file.
/// @throws io::FileError if it cannot be written
void write_png(const std::string& path, const Image& image);

}  // namespace quadrille
