#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "boxes/direction_index.hpp"
#include "boxes/face.hpp"
#include "boxes/face_edge.hpp"

namespace quadrille {

/// Faces that may be those of one box, and what was seen around them. Frame A has the origin of C
/// and the axes of the box.
struct BoxDraft {
  /// One, two or three. The i-th has axis i as its normal, or, if it makes a left-handed three, the
  /// reverse of it.
  std::vector<const Face*> faces;
  Eigen::Matrix3d R_CA = Eigen::Matrix3d::Identity();
  /// Points of the cloud towards the faces and around them [m], and the same as they were seen
  /// through the plane of each face.
  std::vector<Eigen::Vector3d> around_C;
  std::vector<std::vector<SeenThrough>> seen_through;
  /// Must outlive this, as must the faces.
  const DirectionIndex* sight = nullptr;

  Eigen::Isometry3d X_CA() const;
  /// Unit direction in which the upper or lower end of a side looks.
  Eigen::Vector3d out_C(int axis, int upper) const;
  /// The face that is this end; nullptr if there is none.
  const Face* face_on(int axis, int upper) const;
  /// Bounds of the faces, but for their outermost points, in frame A [m].
  Eigen::AlignedBox3d reach_A() const;
  std::array<Eigen::Vector3d, 8> corners_C(const Eigen::AlignedBox3d& box_A) const;
  /// The largest of the faces' tolerances [m].
  double max_tolerance() const;
};

/// Finds the axes and looks around.
BoxDraft draft_of(const std::vector<const Face*>& faces, const DirectionIndex& sight);

}  // namespace quadrille
