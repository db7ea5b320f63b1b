#pragma once

#include <cmath>
#include <lcmtypes/bot_core/pose_t.hpp>

#include "quadrille/bus/scene_messages.hpp"

namespace quadrille::test {

inline bot_core::pose_t make_pose() {
  bot_core::pose_t m{};
  m.utime = 1234567;
  m.pos[0] = 1.0, m.pos[1] = -2.0, m.pos[2] = 3.0;
  // A quarter turn about z.
  m.orientation[0] = m.orientation[3] = std::sqrt(0.5);
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

}  // namespace quadrille::test
