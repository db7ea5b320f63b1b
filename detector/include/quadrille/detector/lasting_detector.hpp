#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/options.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Detects the quadrics of a scene that lasts while cameras move about it.
///
/// Of each cloud it keeps the samples and the surfaces that it found there, as ViewMemory keeps
/// clouds: views from directions `views.sector` apart, at most `views.most`, for `views.remember`
/// seconds, without what newer views contradict. The surfaces of all kept views are candidates
/// together with those of the new cloud: each is refitted to all that the views show of it, and
/// judged by their evidence. So sides that one view did not show become seen, hidden things stay,
/// and things that a newer view sees through go. A cloud in which nothing can be found contradicts
/// nothing: the result is then what the kept views show, and a warning says so. A view that stands
/// alone gives the bits of detect(), and the same views in the same order give the same bits.
class LastingDetector {
 public:
  /// @throws std::invalid_argument if an option is out of range
  QUADRILLE_EXPORT explicit LastingDetector(const DetectorOptions& options = {});
  QUADRILLE_EXPORT ~LastingDetector();
  QUADRILLE_EXPORT LastingDetector(LastingDetector&&) noexcept;
  QUADRILLE_EXPORT LastingDetector& operator=(LastingDetector&&) noexcept;

  /// Detects the quadrics that a cloud and the views before it show, and keeps the view.
  /// @param utime   when the cloud was taken [us], by a clock that all cameras have in common; a
  ///   time before the camera's last one means that a log has been restarted, and all later views
  ///   are forgotten
  /// @param cloud   in frame C, with its viewpoint and without points on the robot
  /// @param X_WC    pose of C in a fixed frame W, as far as it is known
  /// @param camera  number of the camera
  /// @return the result in C; `points_read`, `points_finite` and `points_used` are those of this
  /// cloud
  QUADRILLE_EXPORT DetectionResult detect(std::int64_t utime, const CloudView& cloud,
                                          const Eigen::Isometry3d& X_WC, int camera = 0);

  /// Forgets all views.
  QUADRILLE_EXPORT void forget();
  /// Forgets all that the views saw within a box and through it.
  /// @param X_WR  pose of the box's frame R in W
  QUADRILLE_EXPORT void forget(const Eigen::Isometry3d& X_WR, const Eigen::AlignedBox3d& box_R);

  /// The motion within W that corrects the pose of a camera's last view; the identity if there was
  /// nothing to compare it with.
  QUADRILLE_EXPORT Eigen::Isometry3d correction(int camera = 0) const;

  /// Number of kept views.
  QUADRILLE_EXPORT std::size_t size() const;

 private:
  struct Views;
  std::unique_ptr<Views> views_;
};

}  // namespace quadrille
