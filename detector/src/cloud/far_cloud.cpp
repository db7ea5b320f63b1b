#include "cloud/far_cloud.hpp"

#include <Eigen/Geometry>
#include <utility>

#include "quadrille/detector/detection.hpp"

namespace quadrille {
namespace {

// Distance of a cloud's centre from the origin [m] beyond which it is shifted. At 8 m the square of
// a coordinate is stored to 4e-6 m², which is 0.04 mm on a can of 5 cm radius.
constexpr double kFar = 8.0;

}  // namespace

Eigen::Vector3d shift_to_origin(const Eigen::Vector3d& centre) {
  if (!(centre.norm() > kFar)) return Eigen::Vector3d::Zero();
  return -centre.array().round().matrix();
}

PointCloud translated(const CloudView& cloud, const Eigen::Vector3d& shift) {
  const Eigen::Vector3f s = shift.cast<float>();
  PointCloud moved;
  moved.points.reserve(cloud.points.size());
  for (const Eigen::Vector3f& p : cloud.points) moved.points.emplace_back(p + s);
  moved.width = cloud.width;
  moved.height = cloud.height;
  moved.viewpoint = cloud.viewpoint + shift;
  return moved;
}

Detection translated(Detection detection, const Eigen::Vector3d& shift) {
  return moved(std::move(detection), Eigen::Isometry3d(Eigen::Translation3d{shift}));
}

}  // namespace quadrille
