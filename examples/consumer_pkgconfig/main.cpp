// Detects the quadrics of a cloud and prints the hand's opening, which shows that both libraries
// compile and link.
#include <iostream>

#include "quadrille/detector/detector.hpp"
#include "quadrille/grasping/gripper.hpp"

int main() {
  quadrille::PointCloud cloud;
  cloud.points.assign(100, Eigen::Vector3f(0.0f, 0.0f, 1.0f));

  const auto result = quadrille::detect(cloud);
  const auto hand = quadrille::franka_hand();
  std::cout << result.detections.size() << " quadrics; the " << hand.name << " hand opens "
            << 1000.0 * hand.max_opening << " mm\n";
}
