#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>

#include "io/new_file.hpp"
#include "quadrille/grasping/occupancy.hpp"

namespace quadrille {

/// The file of `plan --map`: the OctoMap of the last plan, which is written when all clouds were
/// planned for.
class MapFile {
 public:
  /// @throws io::FileError if the file cannot be written
  explicit MapFile(const std::string& path);

  /// Keeps the map of a plan, in place of that of the plan before.
  /// @param space  the map in its frame K; null if the plan has none
  /// @param X_CK   pose of K in the frame C in which the map is written
  void keep(std::shared_ptr<const OccupancyGrid> space, const Eigen::Isometry3d& X_CK);

  /// Writes the map that was kept last. Writes nothing if it is null, even if an earlier one was
  /// not.
  /// @throws io::FileError if the file cannot be written
  void finish();

 private:
  io::NewFile file_;
  std::shared_ptr<const OccupancyGrid> space_;
  Eigen::Isometry3d X_CK_ = Eigen::Isometry3d::Identity();
};

}  // namespace quadrille
