#pragma once

#include <string>
#include <vector>

#include "quadrille/grasping/plan.hpp"

namespace quadrille::physics {

/// What `quadrille plan --json` wrote of one cloud, as far as a trial needs it.
struct PlanFile {
  /// Path of the cloud, as it was given to `quadrille plan`.
  std::string cloud;
  std::vector<Grasp> grasps;
  /// Of the detections only id and quadric.
  std::vector<Detection> detections;
};

/// @throws io::FileError naming the file if it is no such plan
PlanFile read_plan(const std::string& path);

}  // namespace quadrille::physics
