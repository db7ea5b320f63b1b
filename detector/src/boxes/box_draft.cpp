#include "boxes/box_draft.hpp"

#include <algorithm>

#include "boxes/box_axes.hpp"

namespace quadrille {
namespace {

/// Bounds of faces along some axes, without their outermost points [m].
Eigen::AlignedBox3d reach_of(const std::vector<const Face*>& faces, const Eigen::Matrix3d& R_CA) {
  Eigen::AlignedBox3d box_A;
  for (const Face* face : faces) {
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = face->reach(R_CA.col(k));
      box_A.min()[k] = std::min(box_A.min()[k], low);
      box_A.max()[k] = std::max(box_A.max()[k], high);
    }
  }
  return box_A;
}

}  // namespace

Eigen::Isometry3d BoxDraft::X_CA() const {
  Eigen::Isometry3d X_CA = Eigen::Isometry3d::Identity();
  X_CA.linear() = R_CA;
  return X_CA;
}

Eigen::Vector3d BoxDraft::out_C(int axis, int upper) const {
  return (upper ? 1.0 : -1.0) * R_CA.col(axis);
}

const Face* BoxDraft::face_on(int axis, int upper) const {
  if (axis >= static_cast<int>(faces.size())) return nullptr;
  const bool up = faces[axis]->n_C.dot(R_CA.col(axis)) > 0.0;
  return up == (upper == 1) ? faces[axis] : nullptr;
}

std::array<Eigen::Vector3d, 8> BoxDraft::corners_C(const Eigen::AlignedBox3d& box_A) const {
  std::array<Eigen::Vector3d, 8> corners;
  for (int i = 0; i < 8; ++i) {
    corners[i] = R_CA * box_A.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
  }
  return corners;
}

double BoxDraft::max_tolerance() const {
  double tolerance = 0.0;
  for (const Face* face : faces) tolerance = std::max(tolerance, face->tolerance());
  return tolerance;
}

double BoxDraft::skin() const { return kRounding + max_tolerance(); }

std::size_t BoxDraft::max_strays() const {
  // Share of the points on the faces. It need not be exact: with half as many strays none of 176
  // boxes in simulated scenes changes.
  constexpr double kShare = 0.04;
  std::size_t on_faces = 0;
  for (const Face* face : faces) on_faces += face->points_C.size();
  return static_cast<std::size_t>(kShare * static_cast<double>(on_faces));
}

Eigen::AlignedBox3d BoxDraft::core_A(const Eigen::AlignedBox3d& box_A) const {
  constexpr double kMaxShare = 0.3;
  const Eigen::Vector3d layer = (kMaxShare * box_A.sizes()).cwiseMin(skin());
  return {box_A.min() + layer, box_A.max() - layer};
}

BoxDraft draft_of(const std::vector<const Face*>& faces, const DirectionIndex& sight) {
  BoxDraft draft;
  draft.faces = faces;
  draft.sight = &sight;
  draft.R_CA = box_axes(faces);
  draft.reach_A = reach_of(faces, draft.R_CA);
  draft.around_C = sight.points_towards(draft.corners_C(draft.reach_A), kAround);
  for (const Face* face : faces) {
    draft.seen_through.push_back(look_through(*face, draft.around_C, sight));
  }
  return draft;
}

}  // namespace quadrille
