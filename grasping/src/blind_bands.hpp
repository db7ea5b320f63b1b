#pragma once

#include <cstdint>
#include <vector>

namespace quadrille {

/// Fills the blind bands of a depth image whose rows lie along the sensor's baseline.
///
/// Beside the edge of a near thing a sensor with two eyes (or an eye and a projector) is blind
/// where the thing stands between the farther surface and its second eye. That eye's line of sight
/// over the edge has an inverse depth that changes linearly along the row, from that of the near
/// edge to that of the first surface beyond. All before that line both eyes would have seen: the
/// missing pixels take its depth. A gap wider than the baseline explains, b(1/z₀ − 1/z₁) in
/// tangents of the ray, has another cause (a dark or shiny thing, no surface in range) and stays
/// missing.
/// @param depth     row by row [m], 0 where missing; filled
/// @param pitch     tangent between neighbouring pixels of a row
/// @param baseline  largest distance between the eyes [m]; 0 fills nothing
/// @return for each pixel, whether it was filled
std::vector<std::uint8_t> fill_blind_bands(std::vector<float>& depth, int width, double pitch,
                                           double baseline);

}  // namespace quadrille
