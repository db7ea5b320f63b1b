#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/options.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// The views of a scene that moving cameras had, kept up to date.
///
/// The memory keeps the views of each camera whose directions of sight are `views.sector` apart. A
/// newer view of the camera from nearly the same direction takes the place of the one before. At
/// most `views.most` views are kept in all, thinned to what planners can tell apart. Each is
/// forgotten after `views.remember` seconds; what it alone saw is then unknown.
///
/// If a new view sees through points of an older one, these points are forgotten at once. If it
/// shows a thing where an older one saw through, all that the older one saw within 10 cm of the
/// thing, and behind that, is forgotten, since the thing may reach so far. Poses are corrected as
/// by align_views(). The same views give the same bits.
class ViewMemory {
 public:
  /// @throws std::invalid_argument if an option is out of range
  QUADRILLE_EXPORT explicit ViewMemory(const DetectorOptions& options = {});
  QUADRILLE_EXPORT ~ViewMemory();
  QUADRILLE_EXPORT ViewMemory(ViewMemory&&) noexcept;
  QUADRILLE_EXPORT ViewMemory& operator=(ViewMemory&&) noexcept;

  /// Adds a view. If its time is before that of the camera's last one, a log has been restarted,
  /// and all views of later times are forgotten. A cloud without usable points or viewpoint is not
  /// kept.
  /// @param utime   when the cloud was taken [us], by a clock that all cameras have in common
  /// @param cloud   in frame C, with its viewpoint and without points on the robot
  /// @param X_WC    pose of C in a fixed frame W, as far as it is known
  /// @param camera  number of the camera
  /// @return the motion within W that corrects the pose; the identity if there is nothing to
  ///   compare the view with
  QUADRILLE_EXPORT Eigen::Isometry3d add(std::int64_t utime, const PointCloud& cloud,
                                         const Eigen::Isometry3d& X_WC, int camera = 0);

  /// Returns the views but the one that this camera had at this time, the newest first.
  /// @param X_WC  pose in W of the frame C in which they are wanted; that of the camera's last view
  ///   is corrected as this one was
  QUADRILLE_EXPORT std::vector<PointCloud> others(std::int64_t utime, const Eigen::Isometry3d& X_WC,
                                                  int camera = 0) const;

  /// Forgets all views.
  QUADRILLE_EXPORT void forget();
  /// Forgets all that the views saw within a box and through it, so that it is unknown.
  /// @param X_WR  pose of the box's frame R in W
  QUADRILLE_EXPORT void forget(const Eigen::Isometry3d& X_WR, const Eigen::AlignedBox3d& box_R);

  /// Number of views that are kept.
  QUADRILLE_EXPORT std::size_t size() const;

 private:
  struct Views;
  std::unique_ptr<Views> views_;
};

}  // namespace quadrille
