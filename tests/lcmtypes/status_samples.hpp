#pragma once

#include "quadrille/bus/status_message.hpp"

namespace quadrille::test {

inline detector_status_t make_detector_status() {
  detector_status_t m{};
  m.sender = "robot:12:34";
  m.superseded = 3;
  m.pose_age = 4.25;
  m.transport.dropped_datagrams = 7;
  m.process.version = "0.1.0";
  m.rejected = {{"bad_length", 2}};
  m.num_rejected = 1;
  m.remembered_views = 5;
  m.pose_correction = 0.003;
  m.rejected_views = {{"cut_short", 8}};
  m.num_rejected_views = 1;
  m.rejected_knowledge = {{"bad_value", 3}};
  m.num_rejected_knowledge = 1;
  m.untracked = {{"no_pose", 5}};
  m.num_untracked = 1;
  m.unplaced_views = {{"old_pose", 6}};
  m.num_unplaced_views = 1;
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

}  // namespace quadrille::test
