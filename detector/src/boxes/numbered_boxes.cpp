#include "boxes/numbered_boxes.hpp"

#include <algorithm>
#include <cmath>

#include "boxes/face.hpp"

namespace quadrille {
namespace {

/// True if a plane lies on a side of a box.
bool is_face(const Detection& plane, const Box& box) {
  if (plane.type != QuadricType::kPlane || !is_reported(plane)) return false;
  const Eigen::Isometry3d X_BQ = box.X_CB.inverse() * plane.X_CQ;
  const Eigen::Vector3d n_B = X_BQ.linear().col(2);
  const Eigen::Vector3d middle_B = X_BQ * plane.extent_Q.center();
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(n_B[axis]) < std::cos(kMaxSkew)) continue;
    const double height = std::abs(middle_B[axis]) - 0.5 * box.size[axis];
    Eigen::Vector3d on_side_B = middle_B;
    on_side_B[axis] = 0.0;
    return std::abs(height) < kRounding && box.outer_B.contains(on_side_B);
  }
  return false;
}

}  // namespace

std::vector<Box> numbered_boxes(std::vector<Box> boxes, const std::vector<Detection>& detections) {
  int last_id = 0;
  for (const Detection& d : detections) last_id = std::max(last_id, d.id);
  for (Box& box : boxes) {
    box.id = ++last_id;
    box.faces.clear();
    for (const Detection& d : detections) {
      if (is_face(d, box)) box.faces.push_back(d.id);
    }
  }
  return boxes;
}

}  // namespace quadrille
