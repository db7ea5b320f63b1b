#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "boxes/direction_index.hpp"
#include "boxes/face.hpp"
#include "boxes/face_edge.hpp"

namespace quadrille {

/// Faces that may belong to one box, and what was seen around them. Frame A has the origin of C and
/// the axes of the box.
struct BoxDraft {
  /// One, two or three faces. The normal of the i-th is along axis i, or against it if the normals
  /// form a left-handed triple.
  std::vector<const Face*> faces;
  Eigen::Matrix3d R_CA = Eigen::Matrix3d::Identity();
  /// Bounds of the faces, without their outermost points, in frame A [m].
  Eigen::AlignedBox3d reach_A;
  /// Points of the cloud on and around the faces [m], and these points projected along their lines
  /// of sight onto the plane of each face.
  std::vector<Eigen::Vector3d> around_C;
  std::vector<std::vector<SeenThrough>> seen_through;
  /// The index of the cloud; it must outlive this, as must the faces.
  const DirectionIndex* sight = nullptr;

  Eigen::Isometry3d X_CA() const;
  /// Unit outward direction of the upper or lower end of a side.
  Eigen::Vector3d out_C(int axis, int upper) const;
  /// The face at this end; nullptr if there is none.
  const Face* face_on(int axis, int upper) const;
  std::array<Eigen::Vector3d, 8> corners_C(const Eigen::AlignedBox3d& box_A) const;
  /// The largest of the faces' tolerances [m].
  double max_tolerance() const;
  /// Thickness of the outermost layer of the box, which may be rounded and noisy [m].
  double skin() const;
  /// Number of lines of sight through the box, or of points in it, that are taken for strays.
  std::size_t max_strays() const;
  /// A box without its outermost layer, which takes at most three tenths of a side on either end.
  Eigen::AlignedBox3d core_A(const Eigen::AlignedBox3d& box_A) const;
};

/// Finds the axes, and collects what was seen around the faces.
BoxDraft draft_of(const std::vector<const Face*>& faces, const DirectionIndex& sight);

}  // namespace quadrille
