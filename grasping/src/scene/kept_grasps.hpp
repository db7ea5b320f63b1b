#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "quadrille/grasping/grasp.hpp"

namespace quadrille {

/// The grasps of a plan, of which only so many may be given.
class KeptGrasps {
 public:
  /// @param per_target  number of grasps that are asked for of each target; 0 for all
  explicit KeptGrasps(int per_target) : per_target_(static_cast<std::size_t>(per_target)) {}

  /// Keeps the grasps of one target, or as many of them as are asked for.
  /// @param reach  half the target's largest size [m]
  void add(const std::vector<Grasp>& grasps, double reach);

  /// Returns at most so many grasps, best first. Each target keeps its best grasp before any target
  /// keeps a second one. If a number of each target is asked for, each keeps its second before any
  /// keeps a third, and so on; then a warning tells that some are left out.
  std::vector<Grasp> best(int max_grasps, std::vector<std::string>* warnings) &&;

 private:
  /// A grasp, and after how many others of its target it is kept if there are too many.
  struct Kept {
    Grasp grasp;
    std::size_t rank = 0;
  };

  std::size_t per_target_;
  std::vector<Kept> kept_;
};

}  // namespace quadrille
