#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "quadrille/detector/detector.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"

namespace quadrille::test {

inline constexpr double kBall = 0.06, kCan = 0.045, kCanLength = 0.16;

/// A table with a ball, a can and a box, seen from 1 m away, 40° from above.
struct TableScene {
  Eigen::Isometry3d X_CW = world_seen_from({0.0, -0.8, 0.65});
  Eigen::Vector3d p_CBall = X_CW * Eigen::Vector3d(-0.2, 0.0, kBall);
  Eigen::Isometry3d X_CCan = X_CW * translation(0.2, 0.0, 0.5 * kCanLength);
  Eigen::Isometry3d X_CBox = X_CW * translation(0.0, 0.1, 0.05) *
                             Eigen::Isometry3d(Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitZ()));
  Eigen::Vector3d box_size{0.14, 0.12, 0.1};

  std::vector<Patch> patches() const {
    std::vector<Patch> all = {rectangle(X_CW, 1.2, 0.9),
                              sphere(Eigen::Isometry3d(Eigen::Translation3d(p_CBall)), kBall)};
    for (const Patch& p : can(X_CCan, kCan, kCanLength)) all.push_back(p);
    for (const Patch& p : box(X_CBox, box_size)) all.push_back(p);
    return all;
  }
};

inline const PointCloud& table_cloud() {
  static const PointCloud cloud = [] {
    Camera camera;
    camera.noise = 0.001;
    return render(TableScene().patches(), camera);
  }();
  return cloud;
}

inline const DetectionResult& table_result() {
  static const DetectionResult result = detect(table_cloud());
  return result;
}

inline double dimension(const Detection& detection, const std::string& name) {
  for (const Dimension& d : detection.dimensions) {
    if (d.name == name) return d.value;
  }
  return NAN;
}

inline const Detection* find(const DetectionResult& result, QuadricType type) {
  for (const Detection& d : result.detections) {
    if (d.type == type) return &d;
  }
  return nullptr;
}

inline std::vector<const Detection*> curved(const DetectionResult& result) {
  std::vector<const Detection*> list;
  for (const Detection& d : result.detections) {
    if (!is_flat(d.type)) list.push_back(&d);
  }
  return list;
}

inline void check_sound(const DetectionResult& result) {
  int id = 0;
  double last = 1e300;
  for (const Detection& d : result.detections) {
    CHECK(d.id == ++id);
    CHECK(d.score <= last);
    last = d.score;
    CHECK(d.score >= 0.0);
    CHECK(d.score <= 1.0);
    CHECK(d.Q_C.coefficients().norm() == Approx(1.0));
    CHECK(d.X_CQ.matrix().allFinite());
    CHECK(d.X_CQ.linear().determinant() == Approx(1.0));
    CHECK(d.inliers > 0);
    CHECK(d.rms >= 0.0);
    CHECK(d.seen > 0.0);
    CHECK(d.seen <= 1.0);
    CHECK_FALSE(d.extent_Q.isEmpty());
    for (const Dimension& dimension : d.dimensions) {
      CHECK(std::isfinite(dimension.value));
      CHECK(std::isfinite(dimension.std));
      CHECK(dimension.value > 0.0);
    }
  }
  CHECK(result.points_used <= result.points_finite);
}

/// All numbers of a result but the times.
inline std::vector<double> numbers(const DetectionResult& result) {
  std::vector<double> list;
  const auto add = [&](const auto& matrix) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i) list.push_back(matrix.data()[i]);
  };
  for (const Detection& d : result.detections) {
    list.insert(list.end(), {static_cast<double>(d.id), static_cast<double>(d.type), d.score,
                             static_cast<double>(d.inliers), d.rms, d.seen});
    add(d.Q_C.matrix());
    add(d.X_CQ.matrix());
    add(d.extent_Q.min());
    add(d.extent_Q.max());
    for (const Dimension& dimension : d.dimensions) {
      list.push_back(dimension.value);
      list.push_back(dimension.std);
    }
  }
  list.push_back(static_cast<double>(result.points_used));
  return list;
}

inline PointCloud moved_cloud(PointCloud cloud, const Eigen::Isometry3d& X) {
  for (Eigen::Vector3f& p : cloud.points) p = (X * p.cast<double>()).cast<float>();
  cloud.viewpoint = X * cloud.viewpoint;
  return cloud;
}

inline bool warns(const DetectionResult& result, const std::string& text) {
  return std::any_of(result.warnings.begin(), result.warnings.end(),
                     [&](const std::string& w) { return w.find(text) != std::string::npos; });
}

}  // namespace quadrille::test
