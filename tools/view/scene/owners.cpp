#include "view/scene/owners.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille::view {
namespace {

/// Returns the distance beyond which a point does not belong to a surface [m]: several deviations
/// of the surface's inliers.
double tolerance_of(const Detection& detection) {
  constexpr double kMinTolerance = 0.002, kDeviations = 3.0;
  return std::max(kDeviations * detection.rms, kMinTolerance);
}

struct Surface {
  std::uint8_t place = 0;
  Eigen::Isometry3d X_QC;
  Eigen::AlignedBox3d box_Q;
  Quadric Q_C;
  double tolerance = 0.0;
};

std::vector<Surface> surfaces_of(const std::vector<Detection>& detections) {
  std::vector<Surface> surfaces;
  for (std::size_t i = 0; i < std::min<std::size_t>(detections.size(), 255); ++i) {
    const Detection& d = detections[i];
    if (d.extent_Q.isEmpty()) continue;
    Surface surface{static_cast<std::uint8_t>(i + 1), d.X_CQ.inverse(), d.extent_Q, d.Q_C,
                    tolerance_of(d)};
    surface.box_Q.min().array() -= surface.tolerance;
    surface.box_Q.max().array() += surface.tolerance;
    surfaces.push_back(surface);
  }
  return surfaces;
}

std::size_t stride_of(const PointCloud& cloud, std::size_t max_points) {
  const double excess = static_cast<double>(cloud.points.size()) /
                        static_cast<double>(std::max<std::size_t>(max_points, 1));
  const double stride = cloud.organised() ? std::sqrt(excess) : excess;
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(stride)));
}

}  // namespace

std::vector<Eigen::Vector3f> thin_out(const PointCloud& cloud, std::size_t max_points,
                                      std::vector<Rgb>* colours) {
  const std::size_t stride = stride_of(cloud, max_points);
  const std::size_t width = cloud.organised() ? static_cast<std::size_t>(cloud.width) : 1;
  const bool coloured = colours != nullptr && cloud.coloured();
  std::vector<Eigen::Vector3f> kept;
  for (std::size_t row = 0; row < cloud.points.size() / width; row += stride) {
    for (std::size_t column = 0; column < width; column += stride) {
      const Eigen::Vector3f& p = cloud.points[row * width + column];
      if (!p.allFinite() || kept.size() >= max_points) continue;
      kept.push_back(p);
      if (coloured) colours->push_back(cloud.colours[row * width + column]);
    }
  }
  return kept;
}

std::vector<std::uint8_t> owners_of(const std::vector<Eigen::Vector3f>& points,
                                    const std::vector<Detection>& detections) {
  const std::vector<Surface> surfaces = surfaces_of(detections);
  std::vector<std::uint8_t> owners(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d p_C = points[i].cast<double>();
    double nearest = 1.0;
    for (const Surface& surface : surfaces) {
      if (!surface.box_Q.contains(surface.X_QC * p_C)) continue;
      const double distance = std::abs(surface.Q_C.distance(p_C)) / surface.tolerance;
      if (!(distance < nearest)) continue;
      nearest = distance;
      owners[i] = surface.place;
    }
  }
  return owners;
}

}  // namespace quadrille::view
