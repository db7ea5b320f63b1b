#include "quadrille/remembered_scene.hpp"

#include <string>

#include "io/describe.hpp"
#include "quadrille/grasping/shape.hpp"

namespace quadrille {

view::Scene remembered_scene(const RememberedFrame& frame, view::PlanSetup setup) {
  const auto& [input, lack, robot_lack] = frame.cloud;
  setup.robot = moved(input.robot, input.X_CK);
  for (const SolidShape& shape : input.attached) {
    setup.query.attached.push_back(with_geometry(shape));
  }
  view::Scene scene = scene_of_detections(input.cloud, frame.found, frame.views, input.X_CK, setup);
  scene.name = input.channel;
  scene.utime = input.utime;
  if (!robot_lack.empty()) {
    scene.warnings.push_back(
        "the robot's shapes cannot be placed, so its points are taken for things: " + robot_lack);
  }
  if (!lack.empty()) {
    scene.warnings.push_back(
        "this cloud stands alone, since the pose of its camera is not known: " + lack);
    return scene;
  }
  scene.X_CK = input.X_CK;
  scene.path = frame.path;
  if (!frame.views.empty()) {
    scene.notes.push_back("with what " + io::count_of(frame.views.size(), "earlier cloud") +
                          " showed");
  }
  return scene;
}

}  // namespace quadrille
