#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "base/mask.hpp"
#include "samples/sight.hpp"

namespace quadrille {

/// A place where something was put down, and how far from there the thing may reach [m].
struct NewPlace {
  Eigen::Vector3f p_C;
  float reach;
};

/// What a newer view contradicts of an older one: whatever it sees through, and, where it shows
/// something new, that to which the older view's rays passed close by. The older view knows nothing
/// of what is behind a new thing, or hidden in it.
class Contradiction {
 public:
  /// @param older, newer  what the views saw, in one frame C
  Contradiction(const Sight& older, const Sight& newer);

  /// Marks the points of the older view that are contradicted.
  /// @param points_C  what the older view saw [m]
  Mask of_points(std::span<const Eigen::Vector3f> points_C) const;
  /// Marks those of them that the newer view sees through, and those in or behind something new.
  Mask seen_through(std::span<const Eigen::Vector3f> points_C) const;
  void mark_behind_new(std::span<const Eigen::Vector3f> points_C, Mask* marked) const;
  /// Clears the cells of the older view that are contradicted: nothing was seen along their rays.
  void clear(Sight* older) const;

 private:
  /// True if a point, or the ray of the older view to it, comes near to a new place.
  bool passes_new(const Eigen::Vector3f& p_C) const;

  const Sight &older_, &newer_;
  Eigen::Vector3f eye_C_;
  std::vector<NewPlace> places_C_;
  /// The cells of the older view that the newer one sees through.
  Mask through_;
};

/// A box that is to be forgotten, with all that a view saw through it, which is then unknown.
struct ForgottenBox {
  /// The box, in its frame R [m].
  Eigen::AlignedBox3f box_R;
  /// Pose of the view's frame C in R.
  Eigen::Isometry3f X_RC;

  /// Marks the points in the box, and those whose rays passed through it.
  Mask of_points(std::span<const Eigen::Vector3f> points_C, const Eigen::Vector3d& eye_C) const;
  /// Clears the cells of a view whose rays passed through it.
  void clear(Sight* sight) const;
};

}  // namespace quadrille
