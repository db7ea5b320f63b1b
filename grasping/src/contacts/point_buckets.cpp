#include "contacts/point_buckets.hpp"

namespace quadrille {
namespace {

// Cubes are shifted by this share of their edge. Many sensors measure whole millimetres: without
// the shift such points lie on the borders of cubes, where rounding decides to which one they
// belong.
constexpr double kShift = 0.37;

}  // namespace

PointBuckets::PointBuckets(std::span<const Eigen::Vector3d> points_C, double edge) {
  for (std::size_t i = 0; i < points_C.size(); ++i) {
    buckets_[key_of(points_C[i], edge)].push_back(static_cast<int>(i));
  }
}

PointBuckets::Key PointBuckets::key_of(const Eigen::Vector3d& p_C, double edge) {
  const Eigen::Vector3i key = ((p_C / edge).array() + kShift).floor().cast<int>();
  return {key.x(), key.y(), key.z()};
}

std::vector<int> PointBuckets::near(const Key& key) const {
  std::vector<int> points;
  for (int n = 0; n < 27; ++n) {
    const auto bucket =
        buckets_.find({key[0] + n % 3 - 1, key[1] + n / 3 % 3 - 1, key[2] + n / 9 - 1});
    if (bucket == buckets_.end()) continue;
    points.insert(points.end(), bucket->second.begin(), bucket->second.end());
  }
  return points;
}

}  // namespace quadrille
