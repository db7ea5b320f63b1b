#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/scene_messages.hpp"
#include "quadrille/detector/solid_shape.hpp"

namespace quadrille::test {

inline pose_t pose_message(const Eigen::Isometry3d& X) {
  pose_t m{};
  const Eigen::Quaterniond q(X.linear());
  std::copy_n(X.translation().data(), 3, m.position);
  m.quaternion[0] = q.w(), m.quaternion[1] = q.x(), m.quaternion[2] = q.y();
  m.quaternion[3] = q.z();
  return m;
}

inline collision_shape_t box_message(const Eigen::Isometry3d& X, const Eigen::Vector3d& size) {
  collision_shape_t m{};
  m.kind = "box";
  m.pose = pose_message(X);
  m.dimensions = {size.x(), size.y(), size.z()};
  m.num_dimensions = 3;
  return m;
}

inline collision_shape_t ball_message(const Eigen::Vector3d& p, double radius) {
  collision_shape_t m{};
  m.kind = "sphere";
  m.pose = pose_message(Eigen::Isometry3d(Eigen::Translation3d(p)));
  m.dimensions = {radius};
  m.num_dimensions = 1;
  return m;
}

inline std::vector<std::byte> shapes_bytes(const std::string& frame,
                                           const std::vector<collision_shape_t>& shapes) {
  collision_shapes_t m{};
  m.frame = frame;
  m.shapes = shapes;
  m.num_shapes = static_cast<int>(shapes.size());
  return bus::encode(m);
}

inline std::vector<std::byte> robot_bytes(std::int64_t utime, const std::string& frame,
                                          const std::vector<collision_shape_t>& shapes,
                                          double padding = 0.005,
                                          const std::vector<collision_shape_t>& attached = {}) {
  robot_t m{};
  m.utime = utime;
  m.frame = frame;
  m.padding = padding;
  m.shapes = shapes;
  m.num_shapes = static_cast<int>(shapes.size());
  m.attached = attached;
  m.num_attached = static_cast<int>(attached.size());
  return bus::encode(m);
}

inline std::vector<std::byte> support_bytes(const std::string& frame, const Eigen::Vector3d& n,
                                            double offset) {
  support_t m{};
  m.frame = frame;
  std::copy_n(n.data(), 3, m.normal);
  m.offset = offset;
  return bus::encode(m);
}

inline std::vector<std::byte> forget_bytes(const std::string& frame, const Eigen::Isometry3d& X,
                                           const Eigen::Vector3d& size) {
  forget_t m{};
  m.frame = frame;
  m.region = pose_message(X);
  std::copy_n(size.data(), 3, m.region_size);
  return bus::encode(m);
}

inline std::vector<std::byte> forget_all_bytes() {
  forget_t m{};
  m.all = 1;
  return bus::encode(m);
}

}  // namespace quadrille::test
