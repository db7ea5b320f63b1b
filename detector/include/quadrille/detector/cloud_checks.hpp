#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Points farther from the viewpoint than this count as missing [m]. No depth sensor measures them,
/// but drivers send values such as 1e30 for pixels without depth.
inline constexpr double kMaxRange = 1000.0;

/// Tells which points of a cloud its sensor can have measured.
struct RangeCheck {
  /// Number of points within the range, and of finite points beyond it.
  std::size_t near = 0, far = 0;
  /// The cloud without the far points: they are dropped, or NaN in an organised cloud. Nullopt if
  /// there are none, so that nothing is copied.
  std::optional<PointCloud> rest;

  /// A message such as "12 points … are left out"; empty if there are no far points.
  QUADRILLE_EXPORT std::string warning() const;

  /// Returns the points within the range; this is the checked cloud itself if no point is far.
  CloudView kept(const CloudView& cloud) const { return rest ? CloudView(*rest) : cloud; }
  const PointCloud& kept(const PointCloud& cloud) const { return rest ? *rest : cloud; }
};

/// Finds the points of a cloud that are farther than kMaxRange from its viewpoint. If hardly any is
/// nearer, the viewpoint is not the sensor's (it may be a map's origin), and the middle of the
/// points is used instead.
QUADRILLE_EXPORT RangeCheck check_range(const CloudView& cloud);

/// Explains why a cloud cannot have been seen from its viewpoint; empty if nothing contradicts it.
///
/// A sensor looks to one side, is not inside what it sees, and does not see through surfaces. A
/// cloud fused from several views shows what one view would hide, and this is accepted; but in any
/// cloud, no plane may hide most of what lies around it.
/// @param detections  detections in the cloud, in its frame C; only planes are used
/// @return one sentence: what is wrong, where, and what to do
QUADRILLE_EXPORT std::string contradict_viewpoint(const CloudView& cloud,
                                                  const std::vector<Detection>& detections);

}  // namespace quadrille
