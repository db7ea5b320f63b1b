#pragma once

namespace quadrille {

/// Depth below which a view tells nothing [m].
inline constexpr double kNearestDepth = 0.02;

}  // namespace quadrille
