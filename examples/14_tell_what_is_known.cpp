// Tells the processes where the robot is, and of an obstacle that the camera does not see, as a
// robot's program would, ten times a second until Ctrl-C:
//   14_tell_what_is_known [TIMES [LCM_URL]]
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <lcm/lcm-cpp.hpp>
#include <lcmtypes/quadrille/collision_shapes_t.hpp>
#include <lcmtypes/quadrille/robot_t.hpp>
#include <limits>
#include <string>
#include <thread>
#include <utility>
#include <vector>

// Takes the time from the clock that stamps your clouds.
std::int64_t now_us() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::microseconds>(now).count();
}

quadrille::collision_shape_t make_shape(const std::string& kind, std::vector<double> dimensions,
                                        double x, double y, double z) {
  quadrille::collision_shape_t shape{};
  shape.kind = kind;
  shape.pose.position[0] = x;
  shape.pose.position[1] = y;
  shape.pose.position[2] = z;
  shape.pose.quaternion[0] = 1.0;  // w, x, y, z
  shape.num_dimensions = static_cast<std::int32_t>(dimensions.size());
  shape.dimensions = std::move(dimensions);
  return shape;
}

// A forearm and a hand, in the camera's frame: z ahead, y down. Yours come from the joints' angles.
quadrille::robot_t make_robot() {
  quadrille::robot_t robot{};
  robot.utime = now_us();  // a cloud gets the shapes of the message that is nearest in time
  robot.frame = "camera";
  robot.padding = 0.01;
  robot.shapes = {make_shape("capsule", {0.06, 0.3}, 0.25, -0.1, 0.5),
                  make_shape("box", {0.1, 0.2, 0.06}, 0.25, -0.1, 0.75)};
  robot.num_shapes = static_cast<std::int32_t>(robot.shapes.size());
  // A camera is fixed to the back of the hand. Its pose is in the hand's frame G, whose z axis runs
  // along the approach.
  robot.attached = {make_shape("box", {0.03, 0.09, 0.03}, 0.07, 0.0, -0.1)};
  robot.num_attached = static_cast<std::int32_t>(robot.attached.size());
  return robot;
}

// A shelf board above the scene. Each message takes the place of the one before.
quadrille::collision_shapes_t make_obstacles() {
  quadrille::collision_shapes_t obstacles{};
  obstacles.utime = now_us();
  obstacles.frame = "camera";
  obstacles.shapes = {make_shape("box", {0.8, 0.02, 0.3}, 0.0, -0.4, 0.7)};
  obstacles.num_shapes = static_cast<std::int32_t>(obstacles.shapes.size());
  return obstacles;
}

int main(int argc, char** argv) {
  const int times = argc > 1 ? std::atoi(argv[1]) : std::numeric_limits<int>::max();
  const std::string url = argc > 2 ? argv[2] : "";  // "" means $LCM_DEFAULT_URL
  lcm::LCM lcm(url);
  if (!lcm.good()) {
    std::cerr << "LCM cannot open " << (url.empty() ? "its default address" : url) << '\n';
    if (url.empty() || url.starts_with("udpm:")) {
      std::cerr << "is there a multicast route? (ip route add 224.0.0.0/4 dev lo)\n";
    }
    return 1;
  }
  for (int n = 0; n < times; ++n) {
    const quadrille::robot_t robot = make_robot();
    const quadrille::collision_shapes_t obstacles = make_obstacles();
    lcm.publish("ROBOT", &robot);
    lcm.publish("OBSTACLES", &obstacles);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  std::cout << "published the robot on ROBOT and an obstacle on OBSTACLES " << times << " times\n";
}
