#include "tools/moved_scan.hpp"

#include <fmt/format.h>

#include <cstring>

#include "support/catch.hpp"
#include "tools/support_files.hpp"

namespace quadrille::test {
namespace {

using nlohmann::json;

Eigen::Vector3d vector_of(const json& list) {
  return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

Eigen::Isometry3d pose_of(const json& pose) {
  const json& q = pose["quaternion"];
  return Eigen::Translation3d(vector_of(pose["position"])) *
         Eigen::Quaterniond(q[0].get<double>(), q[1].get<double>(), q[2].get<double>(),
                            q[3].get<double>());
}

}  // namespace

Eigen::Isometry3d random_camera_pose(std::mt19937& random) {
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0 * 2.0 - 1.0; };
  Eigen::Quaterniond q(uniform(), uniform(), uniform(), uniform());
  return Eigen::Translation3d(2.0 * uniform(), 2.0 * uniform(), 2.0 * uniform()) * q.normalized();
}

std::string pose_option(const Eigen::Isometry3d& X_WK) {
  const Eigen::Vector3d p = X_WK.translation();
  const Eigen::Quaterniond q(X_WK.linear());
  return fmt::format("{},{},{},{},{},{},{}", p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z());
}

std::string moved_ply(const PointCloud& cloud_K, const Eigen::Affine3d& X_WK) {
  std::string text = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\n"
      "property double y\nproperty double z\nend_header\n",
      cloud_K.points.size());
  for (const Eigen::Vector3f& p_K : cloud_K.points) {
    const Eigen::Vector3d p_W = X_WK * p_K.cast<double>();
    for (const double value : {p_W.x(), p_W.y(), p_W.z()}) put(&text, value);
  }
  return text;
}

std::size_t check_same_grasps(const json& in_K, const json& in_W, const Eigen::Isometry3d& X_WK) {
  constexpr double kRounding = 1e-9;
  REQUIRE(in_W["grasps"].size() == in_K["grasps"].size());
  for (std::size_t n = 0; n < in_K["grasps"].size(); ++n) {
    const json &a = in_K["grasps"][n], &b = in_W["grasps"][n];
    const Eigen::Matrix4d wanted = (X_WK * pose_of(a["X_CG"])).matrix();
    CHECK((pose_of(b["X_CG"]).matrix() - wanted).norm() < kRounding);
    for (int c = 0; c < 2; ++c) {
      const Eigen::Vector3d contact = X_WK * vector_of(a["contacts"][c]);
      CHECK((vector_of(b["contacts"][c]) - contact).norm() < kRounding);
    }
    CHECK(b["target"] == a["target"]);
    for (const char* key : {"score", "width", "preshape", "clearance", "epsilon"}) {
      CHECK(b[key].get<double>() == Approx(a[key].get<double>()).margin(kRounding));
    }
  }
  // Rounding decides in which cell a point at a border is, and so changes a few of the holds
  // between points that are tried.
  constexpr double kShare = 0.02, kFew = 10.0;
  for (const auto& [reason, count] : in_K["rejected"].items()) {
    const double in_camera = count.get<double>();
    CHECK(in_W["rejected"].value(reason, 0.0) == Approx(in_camera).epsilon(kShare).margin(kFew));
  }
  return in_K["grasps"].size();
}

json plan(const std::string& arguments) {
  const Run run = run_quadrille("plan --json - " + arguments);
  INFO(arguments << "\n" << run.err);
  REQUIRE(run.code == 0);
  return json::parse(run.out);
}

}  // namespace quadrille::test
