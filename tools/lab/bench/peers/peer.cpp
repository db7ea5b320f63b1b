#include "lab/bench/peers/peer.hpp"

#include <cmath>
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>

#include "io/cloud_file.hpp"
#include "io/new_file.hpp"
#include "lab/bench/stopwatch.hpp"

namespace quadrille::bench {
namespace {

/// Returns the quadric (x − c)ᵀ M (x − c) + k.
Quadric central(const Eigen::Matrix3d& M, const Eigen::Vector3d& c, double k) {
  Eigen::Matrix4d Q;
  Q.topLeftCorner<3, 3>() = M;
  Q.topRightCorner<3, 1>() = -M * c;
  Q.bottomLeftCorner<1, 3>() = -(M * c).transpose();
  Q(3, 3) = c.dot(M * c) + k;
  return Quadric(Q).normalized();
}

void run(const std::string& cloud_path, const std::string& family, const std::string& out_path,
         const Orientation& orientation, const Detect& detect) {
  const PointCloud cloud = io::read_cloud(cloud_path);
  const Stopwatch stopwatch;
  const std::vector<Found> findings = detect(orient(cloud.points, orientation(family)), family);
  nlohmann::json json = {{"wall_ms", stopwatch.wall_ms()}, {"cpu_ms", stopwatch.cpu_ms()}};
  json["findings"] = nlohmann::json::array();
  for (const Found& found : findings) {
    const Vector10d q = found.Q_C.coefficients();
    if (!q.allFinite()) continue;
    json["findings"].push_back(
        {{"q", std::vector<double>(q.data(), q.data() + 10)}, {"score", found.score}});
  }
  io::write_file(out_path, json.dump());
}

}  // namespace

Found found_plane(const Eigen::Vector3d& n, double d, double score) {
  Vector10d q = Vector10d::Zero();
  q.segment<3>(6) = 0.5 * n;
  q[9] = d;
  return {Quadric(q).normalized(), score};
}

Found found_sphere(const Eigen::Vector3d& centre, double radius, double score) {
  return {central(Eigen::Matrix3d::Identity(), centre, -radius * radius), score};
}

Found found_cylinder(const Eigen::Vector3d& p, const Eigen::Vector3d& axis, double radius,
                     double score) {
  const Eigen::Vector3d u = axis.normalized();
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - u * u.transpose();
  return {central(across, p, -radius * radius), score};
}

Found found_cone(const Eigen::Vector3d& apex, const Eigen::Vector3d& axis, double half_angle,
                 double score) {
  const Eigen::Vector3d u = axis.normalized();
  const double cosine = std::cos(half_angle);
  return {central(cosine * cosine * Eigen::Matrix3d::Identity() - u * u.transpose(), apex, 0.0),
          score};
}

int run_peer(int argc, char** argv, const Orientation& orientation, const Detect& detect) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: %s CLOUD.ply FAMILY OUT.json\n", argv[0]);
    return 2;
  }
  try {
    run(argv[1], argv[2], argv[3], orientation, detect);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 1;
  }
}

}  // namespace quadrille::bench
