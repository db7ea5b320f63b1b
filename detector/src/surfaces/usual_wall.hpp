#pragma once

namespace quadrille {

/// Cups and bowls have walls of about 4 mm: those of mugs and bowls of earthenware have 3 to 6 mm,
/// those of glass and metal 1 to 3 mm [m].
inline constexpr double kUsualThickness = 0.004, kThicknessSpread = 0.002;

// Thick earthenware has 6 to 7 mm. What is farther apart is not one wall [m].
inline constexpr double kMaxThickness = 0.008;

}  // namespace quadrille
