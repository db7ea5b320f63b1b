#pragma once

#include "quadrille/bus/grasps_message.hpp"
#include "quadrille/bus/occupancy_message.hpp"
#include "quadrille/bus/request_message.hpp"

namespace quadrille::test {

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

inline occupancy_t make_occupancy() {
  occupancy_t m{};
  m.utime = 5;
  m.frame = "camera";
  m.resolution = 0.005;
  m.data = {1, 2, 3};
  m.data_size = 3;
  return m;
}

}  // namespace quadrille::test
