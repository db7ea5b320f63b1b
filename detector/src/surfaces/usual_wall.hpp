#pragma once

namespace quadrille {

/// Cups and bowls have walls of about 4 mm, two thirds of them between 2 and 6 mm [m].
inline constexpr double kUsualThickness = 0.004, kThicknessSpread = 0.002;

}  // namespace quadrille
