// A consumer of two targets, of which one knows nothing of quadrille. Reads points, one a line, and
// prints what is found in them; fails if Eigen's types mean something else across a border.
#include <cmath>
#include <cstdio>
#include <iostream>

#include "poses.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/detector.hpp"

namespace {

bool is_same(const Placed& placed, const std::vector<Eigen::Isometry3d>& poses,
             const std::vector<Placed>& more) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
  for (const Eigen::Isometry3d& X : poses) centre += X.translation();
  for (const Placed& one : more) Q += one.weight * one.X.matrix() * one.Q;
  centre = poses.back().inverse() * (centre / static_cast<double>(poses.size()));
  return (placed.centre - centre).norm() < 1e-12 && (placed.Q - Q).norm() < 1e-12 &&
         placed.X.isApprox(poses.back());
}

}  // namespace

int main() {
  quadrille::PointCloud cloud;
  for (double x = 0.0, y = 0.0, z = 0.0; std::cin >> x >> y >> z;) {
    cloud.points.emplace_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
  }
  cloud.read = cloud.points.size();
  const quadrille::DetectionResult result = quadrille::detect(cloud);
  std::vector<Eigen::Isometry3d> poses;
  std::vector<Placed> more;
  for (quadrille::Detection d : result.detections) {
    std::printf("%s", std::string(to_string(d.type)).c_str());
    for (const double number : d.Q_C.coefficients()) std::printf(" %.17g", number);
    for (const double number : d.X_CQ.translation()) std::printf(" %.17g", number);
    for (const quadrille::Dimension& each : d.dimensions) {
      std::printf(" %.17g %.17g", each.value, std::isfinite(each.std) ? each.std : -1.0);
    }
    std::printf("\n");
    // Matrices that one side of the border allocates and the other one frees.
    d.covariance.open = Eigen::MatrixXd::Identity(10, 2);
    const quadrille::Detection there = moved(d, d.X_CQ * Eigen::Translation3d(1.0, 2.0, 3.0));
    if (there.covariance.open.cols() != 2) return 1;
    poses.push_back(there.X_CQ);
    more.push_back({d.score, d.X_CQ.translation(), there.X_CQ, there.Q_C.matrix()});
  }
  if (poses.empty() || !is_same(place(poses, more), poses, more)) return 1;
  Eigen::MatrixXd A = 12.0 * Eigen::MatrixXd::Identity(12, 12);
  for (Eigen::Index i = 0; i < A.size(); ++i) A(i) += static_cast<double>((7 * i) % 13);
  return decompose(A) < 1e-6 ? 0 : 1;
}
