#include "views/thinned.hpp"

#include <algorithm>
#include <cstddef>

#include "views/outlook.hpp"

namespace quadrille {
namespace {

// Largest distance between neighbouring pixels, a little less than a planner's voxel [m], and the
// largest number of rows or columns that become one.
constexpr double kSpacing = 0.004, kMaxStep = 4.0;

/// Distance between neighbouring pixels at the median depth [m].
double pixel_spacing(const PointCloud& cloud, const Sight& sight) {
  const double span = static_cast<double>(sight.step) * sight.width;
  const Outlook outlook = outlook_of(sight, Eigen::Isometry3d::Identity());
  return span / cloud.width * (outlook.place_W - outlook.eye_W).norm();
}

}  // namespace

PointCloud thinned(const PointCloud& cloud, const Sight& sight) {
  if (!cloud.organised() || sight.w.empty()) return cloud;
  const auto step =
      static_cast<int>(std::clamp(kSpacing / pixel_spacing(cloud, sight), 1.0, kMaxStep));
  if (step == 1) return cloud;
  PointCloud thin;
  thin.width = (cloud.width + step - 1) / step;
  thin.height = (cloud.height + step - 1) / step;
  thin.viewpoint = cloud.viewpoint;
  thin.frame = cloud.frame;
  thin.read = cloud.read;
  for (int v = 0; v < cloud.height; v += step) {
    for (int u = 0; u < cloud.width; u += step) {
      thin.points.push_back(cloud.points[static_cast<std::size_t>(v) * cloud.width + u]);
    }
  }
  return thin;
}

}  // namespace quadrille
