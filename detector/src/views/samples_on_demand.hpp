#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "samples/cell_pyramid.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// The finest samples of all that a view sees. They are made when they are first asked for, because
/// most views of a moving camera are replaced before they or others are brought onto each other.
class SamplesOnDemand {
 public:
  /// @param cells  the cells of the view's cloud
  SamplesOnDemand(std::shared_ptr<const CellPyramid> cells, int threads);

  /// Moves the samples.
  void move(const Eigen::Isometry3d& X);
  const SurfaceSamples& get();

 private:
  /// Null once the samples are made.
  std::shared_ptr<const CellPyramid> cells_;
  int threads_;
  /// The motions that the samples will need, in their order.
  std::vector<Eigen::Isometry3d> motions_;
  SurfaceSamples samples_;
};

}  // namespace quadrille
