// Applies an estimator of your own to detections: spheres are fitted anew to their points by least
// squares of distances, and replace the detector's spheres.
#include <cmath>
#include <iomanip>
#include <iostream>
#include <random>
#include <vector>

#include "quadrille/detector/detector.hpp"
#include "quadrille/detector/quadric.hpp"

// A ball of 4 cm radius on a table, seen from above with noise of 1 mm.
quadrille::PointCloud ball_on_table() {
  const Eigen::Vector3d center(0.02, -0.01, 0.56);
  const double radius = 0.04;
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 0.001);

  quadrille::PointCloud cloud;
  cloud.width = 320;
  cloud.height = 240;
  for (int row = 0; row < cloud.height; ++row) {
    for (int column = 0; column < cloud.width; ++column) {
      const Eigen::Vector3d ray =
          Eigen::Vector3d((column - 159.5) / 280.0, (row - 119.5) / 280.0, 1.0).normalized();
      const double along = ray.dot(center);
      const double square = along * along - center.squaredNorm() + radius * radius;
      const double range = square > 0.0 ? along - std::sqrt(square) : 0.6 / ray.z();
      cloud.points.push_back(((range + noise(random)) * ray).cast<float>());
    }
  }
  return cloud;
}

// The points that lie on a quadric: within three standard deviations of it and within its seen
// extent.
std::vector<Eigen::Vector3d> points_on(const quadrille::Detection& found,
                                       const quadrille::PointCloud& cloud) {
  const Eigen::Isometry3d X_QC = found.X_CQ.inverse();
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3f& point : cloud.points) {
    const Eigen::Vector3d p_C = point.cast<double>();
    const bool is_near = std::abs(found.Q_C.distance(p_C)) < 3.0 * found.rms;
    if (is_near && found.extent_Q.contains(X_QC * p_C)) points.push_back(p_C);
  }
  return points;
}

// The centre and radius that minimise the sum of squared distances, by the Gauss-Newton method.
Eigen::Vector4d fit_sphere(const std::vector<Eigen::Vector3d>& points, Eigen::Vector4d sphere) {
  for (int step = 0; step < 10; ++step) {
    Eigen::Matrix4d H = Eigen::Matrix4d::Zero();
    Eigen::Vector4d g = Eigen::Vector4d::Zero();
    for (const Eigen::Vector3d& p : points) {
      const Eigen::Vector3d d = p - sphere.head<3>();
      const double range = d.norm(), residual = range - sphere[3];
      Eigen::Vector4d J;
      J << -d / range, -1.0;
      H += J * J.transpose();
      g += J * residual;
    }
    sphere -= H.ldlt().solve(g);
  }
  return sphere;
}

int main() {
  const quadrille::PointCloud cloud = ball_on_table();
  quadrille::DetectionResult result = quadrille::detect(cloud);

  std::cout << std::fixed << std::setprecision(2);
  for (quadrille::Detection& found : result.detections) {
    if (found.type != quadrille::QuadricType::kSphere) continue;
    const std::vector<Eigen::Vector3d> points = points_on(found, cloud);
    Eigen::Vector4d start;
    start << found.X_CQ.translation(), found.dimensions[0].value;
    const Eigen::Vector4d sphere = fit_sphere(points, start);
    std::cout << "sphere of radius " << 1000.0 * start[3] << " mm, fitted to " << points.size()
              << " points " << 1000.0 * sphere[3] << " mm\n";

    // All fields that depend on the surface must be updated.
    found.X_CQ.translation() = sphere.head<3>();
    found.dimensions[0].value = sphere[3];
    const quadrille::Quadric Q_C = quadrille::from_canonical(
        {found.type, found.X_CQ, {{found.dimensions[0].name, found.dimensions[0].value}}});
    // The gradient must still point to the side that the sensor saw.
    const bool same_side = Q_C.matrix().cwiseProduct(found.Q_C.matrix()).sum() > 0.0;
    found.Q_C = (same_side ? Q_C : Q_C.flipped()).normalized();
  }
}
