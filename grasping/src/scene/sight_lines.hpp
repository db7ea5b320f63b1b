#pragma once

#include <Eigen/Core>
#include <vector>

#include "quadrille/detector/body.hpp"
#include "quadrille/grasping/occupancy.hpp"

namespace quadrille {

/// Tells what of the unknown space about bodies a camera would see from elsewhere, by what is known
/// already.
class SightLines {
 public:
  /// Both must outlive this.
  SightLines(const OccupancyGrid& space, const std::vector<SceneBody>& bodies)
      : space_(space), bodies_(bodies) {}

  /// Returns unknown places within a finger's reach of a body and above its support, evenly chosen.
  /// @param up_C  normal of the plane on which the body stands; zero if it is not known
  std::vector<Eigen::Vector3d> unknown_about(const SceneBody& body,
                                             const Eigen::Vector3d& up_C) const;

  /// Returns the share of places that a camera with this line of sight sees.
  /// @pre there is a place
  double share(const std::vector<Eigen::Vector3d>& places_C, const Eigen::Vector3d& eye_C,
               const Eigen::Vector3d& ahead) const;

 private:
  /// Returns true if the line of sight to a place crosses no occupied voxel and no body.
  bool sees(const Eigen::Vector3d& eye_C, const Eigen::Vector3d& p_C) const;

  const OccupancyGrid& space_;
  const std::vector<SceneBody>& bodies_;
};

}  // namespace quadrille
