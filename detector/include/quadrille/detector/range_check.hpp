#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "quadrille/detector/cloud_view.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Points farther from the viewpoint than this count as missing [m]. No depth sensor measures them;
/// drivers send such numbers, as 1e30, for pixels without depth.
inline constexpr double kMaxRange = 1000.0;

/// Which points of a cloud its sensor can have measured.
struct RangeCheck {
  /// Points within the range, and finite ones beyond it.
  std::size_t near = 0, far = 0;
  /// The cloud without the far ones, which are dropped, or NaN if it is organised; nullopt if there
  /// are none: nothing is copied then.
  std::optional<PointCloud> rest;

  /// "12 points … are left out"; empty if there are none.
  QUADRILLE_EXPORT std::string warning() const;

  /// What is left of the cloud that was checked: mostly itself.
  CloudView kept(const CloudView& cloud) const { return rest ? CloudView(*rest) : cloud; }
  const PointCloud& kept(const PointCloud& cloud) const { return rest ? *rest : cloud; }
};

/// Finds the points of a cloud that are farther than kMaxRange from its viewpoint. If hardly any is
/// nearer, the viewpoint is not the sensor's, as that of a map may be, and the middle of the points
/// stands for it.
QUADRILLE_EXPORT RangeCheck check_range(const CloudView& cloud);

}  // namespace quadrille
