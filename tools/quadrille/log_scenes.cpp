#include "quadrille/log_scenes.hpp"

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "poses/placement.hpp"
#include "poses/robot_state.hpp"
#include "quadrille/grasping/shape.hpp"
#include "quadrille/remembered_scene.hpp"

namespace quadrille {
namespace {

/// Adds what a robot says of itself to the setup of one cloud.
void add_robot(const RobotState& robot, const Placement& placement, const std::string& cloud_frame,
               view::PlanSetup* setup, std::vector<std::string>* warnings) {
  for (const SolidShape& shape : robot.attached) {
    setup->query.attached.push_back(with_geometry(shape));
  }
  try {
    setup->robot = moved(robot.in_camera_frame(placement, cloud_frame), placement.X_RK);
  } catch (const std::invalid_argument& error) {
    warnings->push_back(
        std::string("the robot's shapes cannot be placed, so its points are taken for things: ") +
        error.what());
  }
}

}  // namespace

view::MakeScene scenes_alone(const FrameArguments& frames, const ChooseSetup& choose) {
  return [frames, choose](const view::LogFrame& frame, const view::PlanChoice& choice) {
    const logs::LoggedCloud& logged = frame.cloud;
    const Placement placement = frames.placement();
    view::PlanSetup chosen_setup = choose(choice);
    std::vector<std::string> warnings;
    if (frame.robot) {
      add_robot(*frame.robot, placement, logged.message.cloud.frame, &chosen_setup, &warnings);
    }
    PointCloud cloud = moved(logged.message.cloud, placement.X_CK.inverse());
    frames.place_viewpoint(&cloud);
    view::Scene scene = scene_of_cloud(cloud, placement.X_RK, chosen_setup);
    scene.warnings.insert(scene.warnings.end(), warnings.begin(), warnings.end());
    scene.name = logged.channel;
    scene.utime = logged.message.utime;
    scene.seq = logged.message.seq;
    return scene;
  };
}

view::MakeScene scenes_in_memory(RememberedFrames frames, const ChooseSetup& choose) {
  const auto shared = std::make_shared<RememberedFrames>(std::move(frames));
  return [shared, choose](const view::LogFrame& logged, const view::PlanChoice& choice) {
    view::PlanSetup setup = choose(choice);
    const RememberedFrame* const frame = shared->at(logged.number);
    if (frame == nullptr) throw std::runtime_error("the log ends before this cloud");
    view::Scene scene = remembered_scene(*frame, std::move(setup));
    scene.seq = logged.cloud.message.seq;
    return scene;
  };
}

}  // namespace quadrille
