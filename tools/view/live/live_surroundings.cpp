#include "view/live/live_surroundings.hpp"

#include <stdexcept>
#include <utility>
#include <variant>

#include "quadrille/bus/scene_messages.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille::view {
namespace {

/// Returns shapes in the frame of the scene; none, with a warning, if their place is not known.
/// @param what  what the shapes are, such as "the robot's shapes"
std::vector<SolidShape> placed(std::vector<SolidShape> shapes, const std::string& frame,
                               const std::string& what, bool has_poses, const SceneFrames& frames,
                               Scene* scene) {
  if (shapes.empty()) return shapes;
  const auto X_SF = frames.X_SF(frame);
  if (!X_SF) {
    scene->warnings.push_back(what + " are not shown: they are in frame '" + printable(frame) +
                              "', whose place in this scene is not known" +
                              (has_poses ? "" : std::string("; ") + kPoseRemedy));
    return {};
  }
  for (SolidShape& shape : shapes) shape.X_CS = *X_SF * shape.X_CS;
  return shapes;
}

/// Returns the solids of a message. A shape that makes no solid is left out, since the processes
/// tell of it.
std::vector<SolidShape> solids_of(const collision_shapes_t& message) {
  std::vector<SolidShape> solids;
  for (const collision_shape_t& shape : message.shapes) {
    try {
      solids.push_back(bus::from_message(shape));
    } catch (const std::invalid_argument&) {
      continue;
    }
  }
  return solids;
}

/// Adds the path of a camera and its pose when it took the cloud.
void add_camera(const CameraTrail& camera, const SceneFrames& frames, Scene* scene) {
  const auto X_SW = frames.X_SF(kWorldFrame);
  if (!frames.X_WK || !X_SW) return;
  scene->X_CK = *X_SW * *frames.X_WK;
  for (const Eigen::Vector3d& p_W : camera.path()) {
    scene->path.emplace_back((*X_SW * p_W).cast<float>());
  }
}

}  // namespace

void add_surroundings(const LatestMessages& messages, const SceneFrames& frames, Scene* scene) {
  const bool has_poses = messages.camera.has_value();
  if (const auto robot = messages.robot.at(scene->utime)) {
    scene->robot =
        placed(robot->robot.shapes, robot->frame, "the robot's shapes", has_poses, frames, scene);
  }
  if (messages.obstacles) {
    const auto decoded = bus::decode_shapes(*messages.obstacles);
    if (const auto* const told = std::get_if<collision_shapes_t>(&decoded)) {
      scene->obstacles =
          placed(solids_of(*told), told->frame, "the obstacles", has_poses, frames, scene);
    }
  }
  if (messages.camera) add_camera(*messages.camera, frames, scene);
}

}  // namespace quadrille::view
