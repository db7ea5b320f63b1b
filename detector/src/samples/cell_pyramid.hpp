#pragma once

#include <memory>
#include <vector>

#include "quadrille/detector/cloud_view.hpp"
#include "quadrille/detector/stage_options.hpp"
#include "samples/depth/noise.hpp"
#include "samples/sight.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// Levels of a pyramid, each of twice the cell edge of the one before. Real scans need all three:
/// noise and objects differ tenfold in size.
inline constexpr int kLevels = 3;

/// Averages of the measured points at several resolutions: what a front end makes of a cloud.
class CellPyramid {
 public:
  virtual ~CellPyramid() = default;

  /// Cells of a level, empty ones included; level 0 is the finest.
  virtual int size(int level) const = 0;
  /// Per cell of a level but the coarsest, the cell of the next coarser level that holds it.
  virtual const std::vector<int>& parents(int level) const = 0;
  /// Points in a finest cell, their mean in frame C [m], and its noise [m].
  virtual int count(int cell) const = 0;
  virtual Eigen::Vector3f mean(int cell) const = 0;
  virtual float sigma(int cell) const = 0;
  /// The finest cell that a point of the cloud is part of [m]; −1 for none: the point is not
  /// finite, not seen, or on the other side of a depth edge.
  virtual int cell_of(const Eigen::Vector3f& point) const = 0;
  /// What was seen along each finest cell; without cells if they are those of no single view.
  virtual Sight sight() const { return {}; }
  /// Samples of the coarsest level, with the smallest windows: what planes are found on.
  virtual SurfaceSamples coarse_samples() const = 0;
  /// Samples of all levels without some finest cells, so that normals do not mix surfaces.
  /// @param keep  per finest cell, zero to leave it out
  virtual std::vector<SurfaceSamples> samples(const std::vector<char>& keep, int threads) const = 0;
};

/// The front end that suits the cloud: a depth grid for a single view, voxels for all else.
/// @return null if the cloud is too small for either
std::unique_ptr<CellPyramid> make_pyramid(const CloudView& cloud, const SamplingOptions& options);

/// The depth grid of a single-view cloud; null if the cloud is none.
std::unique_ptr<CellPyramid> make_depth_pyramid(const CloudView& cloud,
                                                const SamplingOptions& options);

/// Voxels of a cloud from many sides.
std::unique_ptr<CellPyramid> make_voxel_pyramid(const CloudView& cloud,
                                                const SamplingOptions& options);

}  // namespace quadrille
