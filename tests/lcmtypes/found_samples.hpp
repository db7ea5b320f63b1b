#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "cloud_samples.hpp"
#include "quadrille/bus/bodies_message.hpp"
#include "quadrille/bus/body_tracks_message.hpp"
#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/quadrics_message.hpp"

namespace quadrille::test {

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
  box.wall = BodyWall{0.004, 0.0005};
  SceneBody lump;
  lump.id = 11;
  lump.kind = BodyKind::kLump;
  lump.X_CB = box.X_CB;
  lump.size = {0.03, 0.02, 0.04};
  lump.std.setConstant(std::numeric_limits<double>::infinity());
  lump.points = 77;
  return {box, lump};
}

/// The tracks of these bodies.
inline body_tracks_t make_body_tracks() {
  std::vector<SceneBody> bodies = make_bodies();
  for (SceneBody& body : bodies) body.track = body.id + 10;
  return bus::tracks_message(make_cloud(), bodies);
}

}  // namespace quadrille::test
