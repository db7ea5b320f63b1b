#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "boxes/direction_index.hpp"
#include "boxes/face.hpp"

namespace quadrille {

/// A connected piece of a patch as a face, together with its points as they were measured.
struct Piece {
  Face face;
  std::vector<Eigen::Vector3d> measured_C;
};

/// Finds connected pieces of flat surface in a cloud.
class PieceFinder {
 public:
  /// @param max_sigma   the most that the measured noise of a piece may be [m]
  /// @param max_points  number of points looked at in each patch
  explicit PieceFinder(const DirectionIndex& sight, double max_sigma = kMaxTolerance,
                       std::size_t max_points = kMaxPoints)
      : sight_(sight), max_sigma_(max_sigma), max_points_(max_points) {}

  /// The pieces of a patch in its plane, the largest first.
  /// @param sigma  noise of the points along the normal [m]; measured if not given
  std::vector<Piece> pieces_of(const FacePatch& patch, std::optional<double> sigma = {}) const;

  /// The largest piece around a piece, in the plane that is fitted to that piece; nullopt if too
  /// few points lie there.
  /// @param R_CL  axes of a frame whose x and z are nearly those of the piece
  std::optional<Piece> refitted(const Piece& piece, const Eigen::Matrix3d& R_CL) const;

 private:
  /// The points around a patch that may be part of its plane, as they were measured.
  std::vector<Eigen::Vector3d> points_around(const FacePatch& patch, const Face& plane) const;

  const DirectionIndex& sight_;
  double max_sigma_;
  std::size_t max_points_;
};

}  // namespace quadrille
