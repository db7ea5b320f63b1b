#pragma once

namespace quadrille {

/// How far axes may be apart that count as one: the angle between them [rad], and their distance as
/// a share of the larger radius, to which the noise is added.
struct AxisTolerance {
  double skew, offset_share;
};

/// The tolerance for small parts of a body, whose axes alone may be so far off by noise: 20° and a
/// quarter of the radius.
inline constexpr AxisTolerance kPerhapsOneAxis = {0.35, 0.25};

}  // namespace quadrille
