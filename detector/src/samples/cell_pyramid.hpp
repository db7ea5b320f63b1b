#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/mask.hpp"
#include "quadrille/detector/pinhole.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/stage_options.hpp"
#include "samples/depth/noise.hpp"
#include "samples/sight.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// Number of levels of a pyramid; the cell edge doubles from each level to the next. Real scans
/// need all three, since noise and objects differ tenfold in size.
inline constexpr int kLevels = 3;

/// Averages of the measured points at several resolutions, which a front end makes from a cloud.
class CellPyramid {
 public:
  virtual ~CellPyramid() = default;

  /// Number of cells of a level, empty ones included; level 0 is the finest.
  virtual int size(int level) const = 0;
  /// For each cell of a level, the cell of the next coarser level that contains it; the coarsest
  /// level has no parents.
  virtual const std::vector<int>& parents(int level) const = 0;
  /// Number of points in a finest cell, their mean in frame C [m], and its noise [m].
  virtual int count(int cell) const = 0;
  virtual Eigen::Vector3f mean(int cell) const = 0;
  virtual float sigma(int cell) const = 0;
  /// Bounds of sigma(cell), cheaper than it; the least and the most that it may be [m].
  virtual std::pair<float, float> sigma_bounds(int cell) const {
    const float exact = sigma(cell);
    return {exact, exact};
  }
  /// The finest cell that contains a point of the cloud [m]. It is −1 if the point is not finite,
  /// not seen, or on the other side of a depth edge.
  virtual int cell_of(const Eigen::Vector3f& point) const = 0;
  /// Receives the number of a point and its finest cell.
  using VisitPoint = std::function<void(std::size_t point, int cell)>;
  /// Visits every step-th point of the cloud that has a cell with an owner.
  /// @param owner  for each finest cell, negative for those without an owner
  virtual void visit_points(const CloudView& cloud, std::size_t step, std::span<const int> owner,
                            const VisitPoint& visit) const;
  /// The depth seen along the ray of each finest cell; empty if the cells do not belong to one
  /// view.
  virtual Sight sight() const { return {}; }
  /// How the sensor sees all points of the cloud; null if the cells do not belong to one view, or
  /// only some points were looked at.
  virtual const PinholeView* view() const { return nullptr; }
  /// Samples of the coarsest level with the smallest windows, on which planes are found.
  virtual SurfaceSamples coarse_samples() const = 0;
  /// Samples of all levels, computed without some of the finest cells so that normals do not mix
  /// surfaces.
  /// @param keep  finest cells to use
  virtual std::vector<SurfaceSamples> samples(const Mask& keep, int threads) const = 0;
};

/// Makes the front end that suits the cloud: a depth grid for a single view, voxels otherwise.
/// @return null if the cloud is too small for either
std::unique_ptr<CellPyramid> make_pyramid(const CloudView& cloud, const SamplingOptions& options);

/// Makes the depth grid of a single-view cloud; null if the cloud is not a single view.
std::unique_ptr<CellPyramid> make_depth_pyramid(const CloudView& cloud,
                                                const SamplingOptions& options);

/// Makes the voxels of a cloud fused from several views.
std::unique_ptr<CellPyramid> make_voxel_pyramid(const CloudView& cloud,
                                                const SamplingOptions& options);

}  // namespace quadrille
