#pragma once

#include <string>

#include "picture/image.hpp"

namespace quadrille {

/// Height of a line of text and width of one character, both with their gap, at scale 1 [pixels].
inline constexpr int kTextHeight = 9, kTextWidth = 6;

/// Writes one line in a built-in font of 5x7 pixels; characters beyond ASCII appear as '?'.
/// @param x, y   upper left corner [pixels]
/// @param scale  whole-number magnification
void draw_text(const std::string& text, int x, int y, int scale, const Color& color, Image* image);

}  // namespace quadrille
