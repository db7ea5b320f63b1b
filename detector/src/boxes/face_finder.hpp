#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "boxes/direction_index.hpp"
#include "boxes/face.hpp"

namespace quadrille {

/// A face together with its points as they were measured, not moved onto its plane.
struct MeasuredFace {
  Face face;
  std::vector<Eigen::Vector3d> measured_C;
};

/// Limits of what is a face.
struct FaceLimits {
  /// The most that the measured noise of a face may be [m].
  double max_sigma = kMaxTolerance;
  /// Number of points looked at in each patch.
  std::size_t max_points = kMaxPoints;
  /// How far beside its patch a face may reach [m].
  double margin = kMaxTolerance;
};

/// Finds faces in patches of a cloud.
class FaceFinder {
 public:
  explicit FaceFinder(const DirectionIndex& sight, const FaceLimits& limits = {})
      : sight_(sight), limits_(limits) {}

  /// The faces that lie in the plane of a patch, the largest first.
  /// @param sigma  noise of the points along the normal [m]; measured if not given
  std::vector<MeasuredFace> faces_in(const FacePatch& patch,
                                     std::optional<double> sigma = {}) const;

  /// The largest face about a face, in the plane that is fitted to its points; nullopt if too few
  /// points lie there.
  /// @param R_CL  axes of a frame whose x and z are nearly those of the face
  std::optional<MeasuredFace> refitted(const MeasuredFace& face, const Eigen::Matrix3d& R_CL) const;

 private:
  /// The points around a patch that may be part of its plane, as they were measured.
  std::vector<Eigen::Vector3d> points_around(const FacePatch& patch, const Face& plane) const;

  const DirectionIndex& sight_;
  FaceLimits limits_;
};

}  // namespace quadrille
