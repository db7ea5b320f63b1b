#include "scene/scene_shapes.hpp"

#include <algorithm>
#include <string>

#include "body/body.hpp"
#include "quadrille/grasping/shape.hpp"

namespace quadrille {
namespace {

ShapeOwner owner_of(const Detection& detection) {
  return {detection.id, detection.X_CQ * Eigen::Vector3d(detection.extent_Q.center()),
          detection.extent_Q.sizes().maxCoeff()};
}

ShapeOwner owner_of(const Box& box) {
  return {box.id, box.X_CB.translation(), box.size.maxCoeff()};
}

/// The box of which a detection is a face; nullptr if there is none.
const Box* box_of(int id, const std::vector<Box>& boxes) {
  const auto found = std::find_if(boxes.begin(), boxes.end(), [&](const Box& box) {
    return std::find(box.faces.begin(), box.faces.end(), id) != box.faces.end();
  });
  return found == boxes.end() ? nullptr : &*found;
}

}  // namespace

void add_shapes(const std::vector<Detection>& detections, SceneParts* parts) {
  for (const Box& box : parts->boxes) {
    parts->shapes.push_back(make_shape(box));
    parts->owners.push_back(owner_of(box));
  }
  for (const Detection& d : detections) {
    if (d.type == QuadricType::kPlane) parts->why_none[d.id] = "is a plane";
    // A box takes the place of its faces.
    if (const Box* box = box_of(d.id, parts->boxes)) {
      parts->why_none[d.id] = "is a face of box " + std::to_string(box->id);
      continue;
    }
    const std::vector<CollisionShape> shapes = make_shapes(d);
    parts->shapes.insert(parts->shapes.end(), shapes.begin(), shapes.end());
    parts->owners.resize(parts->shapes.size(), owner_of(d));
    if (!is_wanted(d, parts->options)) {
      parts->why_none[d.id] = "is of a type that is not to be grasped";
      continue;
    }
    if (shapes.empty() || (d.type != QuadricType::kPlane && !make_body(d))) {
      parts->refuse(d.id, Refusal::kNoShape);
    }
    if (shapes.empty()) {
      parts->warnings.push_back("quadric " + std::to_string(d.id) + " has no collision shape: " +
                                std::string(to_string(d.type)) + " has no finite, positive size");
    }
  }
}

}  // namespace quadrille
