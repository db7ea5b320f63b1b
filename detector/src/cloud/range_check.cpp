#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "base/vector_clones.hpp"
#include "cloud/some_points.hpp"
#include "quadrille/detector/cloud_checks.hpp"

namespace quadrille {
namespace {

constexpr float kSquaredRange = static_cast<float>(kMaxRange * kMaxRange);

/// This is false also for points that are not finite.
bool in_range(const Eigen::Vector3f& p, const Eigen::Vector3f& from) {
  return (p - from).squaredNorm() <= kSquaredRange;
}

/// Quick test of 16 points: true only if each coordinate of each is within half the range, so that
/// the points are in range.
QUADRILLE_VECTOR_CLONES
bool all_in_range(const float* points, const float* from) {
  int all = 1;
  for (int k = 0; k < 48; ++k) {
    const float d = points[k] - from[k];
    all &= static_cast<int>(d * d <= 0.25f * kSquaredRange);
  }
  return all != 0;
}

/// Counts those of 16 points that are in range, and the finite ones.
QUADRILLE_VECTOR_CLONES
void count_run(const float* points, const float* from, int* in_range, int* finite) {
  const float fx = from[0], fy = from[1], fz = from[2];
  int near = 0, whole = 0;
  for (std::ptrdiff_t k = 0; k < 16; ++k) {
    const float px = points[3 * k], py = points[3 * k + 1], pz = points[3 * k + 2];
    const float x = px - fx, y = py - fy, z = pz - fz;
    // The order of this sum is that of Eigen's squared norm, and x − x is zero unless x is infinite
    // or NaN.
    near += static_cast<int>(x * x + (y * y + z * z) <= kSquaredRange);
    whole += static_cast<int>((px - px) + (py - py) + (pz - pz) == 0.0f);
  }
  *in_range = near, *finite = whole;
}

RangeCheck count(std::span<const Eigen::Vector3f> points, const Eigen::Vector3f& from) {
  // Nearly all points are in range, so runs of them are tested at once.
  constexpr std::size_t kRun = 16;
  const Eigen::Matrix<float, 3 * kRun, 1> from_each = from.replicate<kRun, 1>();
  RangeCheck check;
  std::size_t i = 0;
  for (; i + kRun <= points.size(); i += kRun) {
    if (all_in_range(points[i].data(), from_each.data())) {
      check.near += kRun;
      continue;
    }
    int near = 0, finite = 0;
    count_run(points[i].data(), from.data(), &near, &finite);
    check.near += static_cast<std::size_t>(near);
    // Points in range are finite, so the other finite ones are too far away.
    check.far += static_cast<std::size_t>(finite - near);
  }
  for (; i < points.size(); ++i) {
    const bool near = in_range(points[i], from);
    check.near += near;
    check.far += !near && points[i].allFinite();
  }
  return check;
}

PointCloud without_far(const CloudView& cloud, const Eigen::Vector3f& from) {
  PointCloud rest;
  rest.points.assign(cloud.points.begin(), cloud.points.end());
  rest.width = cloud.width;
  rest.height = cloud.height;
  rest.viewpoint = cloud.viewpoint;
  const auto is_far = [&](const Eigen::Vector3f& p) { return p.allFinite() && !in_range(p, from); };
  if (cloud.organised()) {
    const Eigen::Vector3f missing =
        Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
    std::replace_if(rest.points.begin(), rest.points.end(), is_far, missing);
  } else {
    std::erase_if(rest.points, is_far);
  }
  return rest;
}

}  // namespace

RangeCheck check_range(const CloudView& cloud) {
  Eigen::Vector3f from = cloud.viewpoint.cast<float>();
  RangeCheck check = count(cloud.points, from);
  if (check.near < kMinPoints && check.far >= kMinPoints) {
    const std::vector<Eigen::Vector3d> some = some_of(cloud.points);
    if (!some.empty()) from = middle_of(some).cast<float>();
    check = count(cloud.points, from);
  }
  if (check.far > 0) check.rest = without_far(cloud, from);
  return check;
}

std::string RangeCheck::warning() const {
  if (far == 0) return "";
  return std::to_string(far) + (far == 1 ? " point" : " points") +
         " farther than 1 km from the viewpoint, as codes for missing ones are, " +
         (far == 1 ? "is" : "are") + " left out";
}

}  // namespace quadrille
