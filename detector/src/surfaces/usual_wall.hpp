#pragma once

namespace quadrille {

/// The thickness that is expected of the wall of a cup or bowl, and its standard deviation [m].
/// Mugs of earthenware are thicker, cups of metal thinner.
inline constexpr double kUsualThickness = 0.004, kThicknessSpread = 0.002;

/// Thick earthenware has 6 to 7 mm. What is farther apart is not one wall [m].
inline constexpr double kMaxThickness = 0.008;

}  // namespace quadrille
