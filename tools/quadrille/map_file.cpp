#include "quadrille/map_file.hpp"

#include <utility>

#include "io/planner/octree_file.hpp"

namespace quadrille {

MapFile::MapFile(const std::string& path) : file_(path) {}

void MapFile::keep(std::shared_ptr<const OccupancyGrid> space, const Eigen::Isometry3d& X_CK) {
  space_ = std::move(space);
  X_CK_ = X_CK;
}

void MapFile::finish() {
  if (!space_) return;
  const bool moves = !X_CK_.matrix().isIdentity(0.0);
  file_.write(io::octree_bytes(*(moves ? space_->moved(X_CK_) : *space_).to_octree()));
  file_.commit();
}

}  // namespace quadrille
