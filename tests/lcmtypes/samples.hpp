#pragma once

#include <bit>
#include <cmath>
#include <cstring>
#include <lcmtypes/bot_core/pose_t.hpp>
#include <lcmtypes/drake/lcmt_point_cloud.hpp>
#include <limits>
#include <vector>

#include "quadrille/bus/bodies_message.hpp"
#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/grasps_message.hpp"
#include "quadrille/bus/occupancy_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/bus/request_message.hpp"
#include "quadrille/bus/scene_messages.hpp"
#include "quadrille/bus/status_message.hpp"

namespace quadrille::test {

/// An organised cloud of 4 x 3 points, two of them missing.
inline bus::CloudMessage make_cloud() {
  bus::CloudMessage message{1234567, 42, {}};
  message.cloud.frame = "camera";
  message.cloud.width = 4;
  message.cloud.height = 3;
  message.cloud.read = 12;
  for (int i = 0; i < 12; ++i) {
    message.cloud.points.emplace_back(0.1f * i, -0.2f * i, 1.0f + 0.01f * i);
  }
  const float nan = std::numeric_limits<float>::quiet_NaN();
  message.cloud.points[5] = message.cloud.points[7] = {nan, nan, nan};
  return message;
}

/// The same points as a row, the missing ones dropped.
inline bus::CloudMessage make_unorganised_cloud() {
  bus::CloudMessage message = make_cloud();
  message.cloud.width = message.cloud.height = 0;
  std::erase_if(message.cloud.points, [](const Eigen::Vector3f& p) { return !p.allFinite(); });
  return message;
}

/// A cylinder and a plane as a detector would report them.
inline DetectionResult make_result() {
  Detection cylinder;
  cylinder.id = 1;
  cylinder.type = QuadricType::kCylinder;
  Vector10d q;
  q << 1, 1, 0, 0, 0, 0, 0, 0, 0, -0.0016;
  cylinder.Q_C = Quadric(q).normalized();
  cylinder.score = 0.9;
  cylinder.inliers = 1234;
  cylinder.rms = 0.0007;
  cylinder.X_CQ = Eigen::Translation3d(0.1, -0.2, 0.9) *
                  Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  cylinder.dimensions = {{"radius", 0.04, 0.0002}, {"length", 0.1, 0.001}};
  cylinder.extent_Q = {Eigen::Vector3d(-0.04, -0.04, -0.05), Eigen::Vector3d(0.04, 0.04, 0.05)};
  cylinder.seen = 0.4;
  cylinder.track = 7;
  Detection plane = cylinder;
  plane.id = 2;
  plane.type = QuadricType::kPlane;
  q << 0, 0, 0, 0, 0, 0, 0, 0, 0.5, -1;
  plane.Q_C = Quadric(q).normalized();
  plane.dimensions = {{"width", 1.0, 0.01}, {"height", 0.5, 0.01}};
  DetectionResult result;
  result.detections = {cylinder, plane};
  result.points_finite = 10;
  result.points_used = 9;
  result.warnings = {"few points"};
  return result;
}

/// A drake message of one row of float64 records, the coordinates at odd offsets.
inline drake::lcmt_point_cloud make_wide_message(bool big_endian) {
  drake::lcmt_point_cloud m;
  m.utime = 7;
  m.frame_name = "lidar";
  m.width = 2;
  m.height = 1;
  m.point_step = 33;
  m.row_step = 66;
  m.flags = big_endian ? drake::lcmt_point_cloud::IS_BIGENDIAN : 0;
  int offset = 1;
  for (const char* name : {"z", "intensity", "x", "y"}) {
    drake::lcmt_point_cloud_field field;
    field.name = name;
    field.byte_offset = offset;
    field.datatype = drake::lcmt_point_cloud::FLOAT64;
    field.count = 1;
    m.fields.push_back(field);
    offset += 8;
  }
  m.num_fields = 4;
  m.filler = {0, 0, 0};
  m.filler_size = 3;
  m.data.assign(66, 0xee);
  m.data_size = 66;
  for (int point = 0; point < 2; ++point) {
    for (int member = 0; member < 4; ++member) {
      std::uint64_t bits = std::bit_cast<std::uint64_t>(10.0 * point + member + 0.5);
      if (big_endian != (std::endian::native == std::endian::big)) bits = __builtin_bswap64(bits);
      std::memcpy(&m.data[static_cast<std::size_t>(33 * point + 1 + 8 * member)], &bits, 8);
    }
  }
  return m;
}

inline std::vector<std::byte> make_quadrics_bytes() {
  return bus::encode(bus::to_message(make_cloud(), make_result()));
}

/// Two boxes that differ in their ids and faces.
inline std::vector<Box> make_boxes() {
  Box box;
  box.id = 9;
  box.faces = {3, 7};
  box.score = 0.8;
  box.X_CB = make_result().detections[0].X_CQ;
  box.size = {0.3, 0.2, 0.1};
  box.std = {0.001, 0.002, 0.03};
  box.seen = {true, true, false};
  box.inner_B = {Eigen::Vector3d(-0.15, -0.1, 0.05), Eigen::Vector3d(0.15, 0.1, 0.05)};
  box.outer_B = {Eigen::Vector3d(-0.15, -0.1, -0.05), Eigen::Vector3d(0.15, 0.1, 0.05)};
  Box other = box;
  other.id = 10;
  other.faces = {4};
  return {box, other};
}

/// A box and a lump.
inline std::vector<SceneBody> make_bodies() {
  SceneBody box;
  box.id = 9;
  box.kind = BodyKind::kBox;
  box.parts = {3, 7};
  box.X_CB = make_result().detections[0].X_CQ;
  box.size = {0.3, 0.2, 0.1};
  box.std = {0.001, 0.002, std::numeric_limits<double>::infinity()};
  box.seen = {true, true, false};
  box.standing_on = 1;
  box.points = 4321;
  box.views = 3;
  box.unseen = 1.5;
  SceneBody lump;
  lump.id = 11;
  lump.kind = BodyKind::kLump;
  lump.X_CB = box.X_CB;
  lump.size = {0.03, 0.02, 0.04};
  lump.std.setConstant(std::numeric_limits<double>::infinity());
  lump.points = 77;
  return {box, lump};
}

inline grasps_t make_grasps() {
  grasps_t m{};
  m.utime = 77;
  m.seq = 4;
  m.frame = "camera";
  m.gripper = "franka";
  m.unknown = "obstacle";
  m.grasps.resize(2);
  m.grasps[1].target = 3;
  m.grasps[1].width = 0.05;
  m.num_grasps = 2;
  m.rejected = {{"width", 9}};
  m.num_rejected = 1;
  m.targets.resize(2);
  m.targets[0].target = 3;
  m.targets[0].num_grasps = 2;
  m.targets[1].target = 5;
  m.targets[1].furthest = "width";
  m.targets[1].rejected = {{"width", 9}};
  m.targets[1].num_rejected = 1;
  m.num_targets = 2;
  m.remedies.resize(1);
  m.remedies[0].target = 5;
  m.remedies[0].change = "--gripper wsg50";
  m.remedies[0].num_grasps = 4;
  m.remedies[0].score = 0.75;
  m.num_remedies = 1;
  m.looks.resize(1);
  m.looks[0].pose.position[0] = 0.125, m.looks[0].pose.position[2] = -0.5;
  m.looks[0].pose.quaternion[0] = 0.6, m.looks[0].pose.quaternion[2] = -0.8;
  m.looks[0].bodies = {5, 3};
  m.looks[0].num_bodies = 2;
  m.looks[0].gain = 1.25;
  m.num_looks = 1;
  m.warnings = {"few points"};
  m.num_warnings = 1;
  return m;
}

inline grasp_request_t make_request() {
  grasp_request_t m{};
  m.request_id = 7;
  m.cloud_utime = 1234;
  m.frame = "world";
  m.targets = {3, 5};
  m.num_targets = 2;
  m.tracks = {9};
  m.num_tracks = 1;
  m.types = {"sphere", "cone"};
  m.num_types = 2;
  m.has_reach = 1;
  m.reach_base[2] = -0.5;
  m.reach_max = 0.85;
  m.min_score = 0.75;
  m.per_target = 3;
  m.max_grasps = 4;
  m.min_size = 0.25;
  m.advise = 1;
  return m;
}

inline bot_core::pose_t make_pose() {
  bot_core::pose_t m{};
  m.utime = 1234567;
  m.pos[0] = 1.0, m.pos[1] = -2.0, m.pos[2] = 3.0;
  // A quarter turn about z.
  m.orientation[0] = m.orientation[3] = std::sqrt(0.5);
  return m;
}

inline detector_status_t make_detector_status() {
  detector_status_t m{};
  m.sender = "robot:12:34";
  m.superseded = 3;
  m.pose_age = 4.25;
  m.transport.dropped_datagrams = 7;
  m.process.version = "0.1.0";
  m.rejected = {{"bad_length", 2}};
  m.num_rejected = 1;
  m.untracked = {{"no_pose", 5}};
  m.num_untracked = 1;
  m.stages.resize(2);
  m.stages[1].name = "quadrics";
  m.stages[1].p99 = 41.5;
  m.num_stages = 2;
  m.warnings = {"buffer too small"};
  m.num_warnings = 1;
  return m;
}

inline planner_status_t make_planner_status() {
  planner_status_t m{};
  m.sender = "robot:12:35";
  m.unpaired_quadrics = 9;
  m.rejected_requests = {{"cut_short", 1}};
  m.num_rejected_requests = 1;
  m.pose_age = 7.5;
  m.remembered_views = 6;
  m.pose_correction = 0.002;
  m.rejected_views = {{"bad_value", 2}};
  m.num_rejected_views = 1;
  m.unplaced = {{"late_pose", 4}};
  m.num_unplaced = 1;
  m.unplaced_views = {{"no_pose", 3}};
  m.num_unplaced_views = 1;
  m.stages.resize(1);
  m.stages[0].name = "grasps";
  m.num_stages = 1;
  return m;
}

inline occupancy_t make_occupancy() {
  occupancy_t m{};
  m.utime = 5;
  m.frame = "camera";
  m.resolution = 0.005;
  m.data = {1, 2, 3};
  m.data_size = 3;
  return m;
}

/// A cylinder at a pose that is not the identity.
inline collision_shape_t make_cylinder_message() {
  collision_shape_t m{};
  m.target = 3;
  m.kind = "cylinder";
  m.pose.position[0] = 0.125, m.pose.position[1] = -0.25, m.pose.position[2] = 0.75;
  m.pose.quaternion[0] = 0.6, m.pose.quaternion[2] = -0.8;
  m.dimensions = {0.0625, 0.1875};
  m.num_dimensions = 2;
  return m;
}

/// A tetrahedron.
inline collision_shape_t make_convex_message() {
  collision_shape_t m{};
  m.kind = "convex";
  m.pose.quaternion[0] = 1.0;
  m.vertices = {{0.0, 0.0, 0.0}, {0.125, 0.0, 0.0}, {0.0, 0.25, 0.0}, {0.0, 0.0, 0.5}};
  m.num_vertices = 4;
  m.faces = {3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3};
  m.num_faces = 16;
  return m;
}

inline collision_shapes_t make_shapes_message() {
  collision_shapes_t m{};
  m.utime = 88;
  m.seq = 2;
  m.frame = "world";
  m.shapes = {make_cylinder_message(), make_convex_message()};
  m.num_shapes = 2;
  return m;
}

inline robot_t make_robot_message() {
  robot_t m{};
  m.utime = 99;
  m.frame = "world";
  m.padding = 0.0125;
  m.shapes = {make_cylinder_message(), make_convex_message()};
  m.num_shapes = 2;
  m.attached = {make_cylinder_message()};
  m.num_attached = 1;
  return m;
}

inline support_t make_support_message() {
  support_t m{};
  m.utime = 111;
  m.frame = "world";
  m.normal[1] = 0.6, m.normal[2] = 0.8;
  m.offset = -0.375;
  return m;
}

/// Names a region.
inline forget_t make_forget_message() {
  forget_t m{};
  m.utime = 222;
  m.frame = "camera";
  m.region = make_cylinder_message().pose;
  m.region_size[0] = 0.125, m.region_size[1] = 0.25, m.region_size[2] = 0.5;
  return m;
}

/// Overwrites a big-endian 32-bit number.
inline void put_int32(std::vector<std::byte>& bytes, std::size_t at, std::int32_t value) {
  for (int i = 0; i < 4; ++i) {
    bytes[at + static_cast<std::size_t>(i)] =
        static_cast<std::byte>(static_cast<std::uint32_t>(value) >> (24 - 8 * i) & 0xff);
  }
}

}  // namespace quadrille::test
