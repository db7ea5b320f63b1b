// Detects the quadrics of a cloud: a ball of 5 cm radius that floats in front of a wall.
#include <cmath>
#include <iomanip>
#include <iostream>

#include "quadrille/detector/detector.hpp"

// The cloud that a depth camera of 320x240 pixels at the origin would see.
quadrille::PointCloud ball_before_wall() {
  const Eigen::Vector3d center(0.0, 0.0, 0.6);
  const double radius = 0.05;

  quadrille::PointCloud cloud;
  cloud.width = 320;
  cloud.height = 240;
  for (int row = 0; row < cloud.height; ++row) {
    for (int column = 0; column < cloud.width; ++column) {
      const Eigen::Vector3d ray =
          Eigen::Vector3d((column - 159.5) / 280.0, (row - 119.5) / 280.0, 1.0).normalized();
      const double along = ray.dot(center);
      const double square = along * along - center.squaredNorm() + radius * radius;
      const double range = square > 0.0 ? along - std::sqrt(square) : 1.0 / ray.z();
      cloud.points.push_back((range * ray).cast<float>());
    }
  }
  return cloud;
}

int main() {
  const quadrille::DetectionResult result = quadrille::detect(ball_before_wall());

  std::cout << std::fixed << std::setprecision(4);
  for (const quadrille::Detection& found : result.detections) {
    std::cout << found.id << ' ' << to_string(found.type) << ", score " << found.score << ", "
              << found.inliers << " points, at " << found.X_CQ.translation().transpose() << " m";
    for (const auto& [name, value, std] : found.dimensions) {
      std::cout << ", " << name << ' ' << value << " ± " << std;
    }
    std::cout << '\n';
  }
  std::cout << result.detections.size() << " quadrics in " << result.total_ms << " ms\n";
}
