#pragma once

#include <string>
#include <vector>

#include "quadrille/grasping/plan.hpp"

namespace quadrille::physics {

/// The parts of the output of `quadrille plan --json` for one cloud that a trial needs.
struct PlanFile {
  /// Path of the cloud, as it was given to `quadrille plan`.
  std::string cloud;
  std::vector<Grasp> grasps;
  /// The detections, with only their id and quadric.
  std::vector<Detection> detections;
};

/// @throws io::FileError naming the file if it is not such a plan
PlanFile read_plan(const std::string& path);

}  // namespace quadrille::physics
