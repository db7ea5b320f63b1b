#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "quadrille/detector/detector.hpp"
#include "quadrille/detector/tracker.hpp"
#include "support/hostile_cloud.hpp"

namespace quadrille::test {

inline void demand(bool holds, const char* what) {
  if (!holds) throw std::logic_error(std::string("not so: ") + what);
}

inline void demand_sound(const DetectionResult& result) {
  demand(result.points_used <= result.points_finite, "used points are finite ones");
  for (const Detection& d : result.detections) {
    demand(d.score >= 0.0 && d.score <= 1.0, "a score lies between 0 and 1");
    demand(std::abs(d.Q_C.coefficients().norm() - 1.0) < 1e-6, "a quadric has unit norm");
    demand(d.X_CQ.matrix().allFinite(), "a pose is finite");
    demand(d.X_CQ.linear().isUnitary(1e-6), "a pose is rigid");
    demand(d.inliers > 0 && d.rms >= 0.0, "a surface has inliers and an rms");
    demand(d.seen > 0.0 && d.seen <= 1.0, "some of a surface was seen");
    demand(!d.extent_Q.isEmpty(), "a surface has an extent");
    for (const Dimension& dimension : d.dimensions) {
      demand(std::isfinite(dimension.value), "a dimension is finite");
      demand(dimension.std >= 0.0, "a standard deviation is none below zero");
    }
  }
  for (const Box& box : result.boxes) {
    demand(box.X_CB.matrix().allFinite() && box.size.allFinite(), "a box is finite");
  }
}

inline bool same(const DetectionResult& a, const DetectionResult& b) {
  if (a.detections.size() != b.detections.size() || a.boxes.size() != b.boxes.size()) return false;
  for (std::size_t k = 0; k < a.detections.size(); ++k) {
    const Detection &x = a.detections[k], &y = b.detections[k];
    if (x.id != y.id || x.type != y.type || x.score != y.score || x.rms != y.rms ||
        x.Q_C.coefficients() != y.Q_C.coefficients()) {
      return false;
    }
  }
  return a.points_used == b.points_used && a.warnings == b.warnings;
}

/// Whatever the cloud, the detector gives a sound result, with the same bits for any number of
/// threads, and the tracker takes it.
inline DetectionResult detect_hostile(Choices& choices) {
  DetectorOptions options;
  options.threads = 1;
  const auto seed = choices.below(3);
  if (choices.one_in(8)) options = sphere_preset();
  options.seed = seed;
  if (choices.one_in(8)) options.sampling.relative_cell = 0.01;
  const bool twice = choices.one_in(8);
  // The corpus counts on one more choice here.
  static_cast<void>(choices.one_in(8));
  const PointCloud cloud = hostile_cloud(choices);
  DetectionResult result = detect(cloud, options);
  demand_sound(result);
  if (twice) {
    options.threads = 2;
    demand(same(result, detect(cloud, options)), "the number of threads changes nothing");
  }
  Tracker tracker;
  for (const int utime : {0, 30000}) {
    tracker.update(utime, Eigen::Isometry3d::Identity(), &result.detections);
  }
  return result;
}

}  // namespace quadrille::test
