#include "space/obstacle_points.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "base/point_buckets.hpp"
#include "quadrille/detector/vector_clones.hpp"

namespace quadrille {
namespace {

// Edge of the cubes that gather neighbouring points, and the radius of the ball around a cube, with
// a reserve for rounding [m].
constexpr double kEdge = 0.02, kRadius = 0.0175;
// Number of neighbouring cubes that one look at their bounds passes over. They are in the order of
// their places, so most of a run lies in one column.
constexpr Eigen::Index kRun = 8;
// Number of points, or of cubes, that are tested at once.
constexpr Eigen::Index kAtOnce = 64;
// Reserve of the bounds for the rounding of floats [m].
constexpr float kSlack = 1e-4f;

using Points = Eigen::Matrix<float, Eigen::Dynamic, 3>;
using Inside = std::array<int, kAtOnce>;

/// A box in single precision, which is tested against many points.
struct BoxTest {
  explicit BoxTest(const OrientedBox& box)
      : R_CB(box.R_CB.cast<float>()),
        middle_B((box.R_CB.transpose() * box.p_CB).cast<float>()),
        half(box.half.cast<float>()) {}

  Eigen::Matrix3f R_CB;
  Eigen::Vector3f middle_B, half;
};

/// Tells which of some points lie in a box.
/// @param count  number of the points, kAtOnce at most
/// @return how many do
QUADRILLE_VECTOR_CLONES
int find_inside(const Points& points_C, Eigen::Index first, Eigen::Index count, const BoxTest& box,
                Inside& inside) {
  const float* x = points_C.data() + first;
  const float *y = x + points_C.rows(), *z = y + points_C.rows();
  const Eigen::Matrix3f& R = box.R_CB;
  const float xu = R(0, 0), yu = R(1, 0), zu = R(2, 0), u = box.middle_B.x(), a = box.half.x();
  const float xv = R(0, 1), yv = R(1, 1), zv = R(2, 1), v = box.middle_B.y(), b = box.half.y();
  const float xw = R(0, 2), yw = R(1, 2), zw = R(2, 2), w = box.middle_B.z(), c = box.half.z();
  int* __restrict is_inside = inside.data();
  int all = 0;
  for (Eigen::Index n = 0; n < count; ++n) {
    is_inside[n] = static_cast<int>(std::abs(x[n] * xu + y[n] * yu + z[n] * zu - u) <= a) &
                   static_cast<int>(std::abs(x[n] * xv + y[n] * yv + z[n] * zv - v) <= b) &
                   static_cast<int>(std::abs(x[n] * xw + y[n] * yw + z[n] * zw - w) <= c);
    all += is_inside[n];
  }
  return all;
}

/// Returns true if one of a range of points lies in a box.
bool any_inside(const Points& points_C, Eigen::Index first, Eigen::Index end, const BoxTest& box) {
  Inside inside;
  for (; first < end; first += kAtOnce) {
    if (find_inside(points_C, first, std::min(kAtOnce, end - first), box, inside) > 0) return true;
  }
  return false;
}

}  // namespace

ObstaclePoints::ObstaclePoints(const std::vector<Eigen::Vector3d>& points_C)
    : points_C_(std::ssize(points_C), 3) {
  const PointBuckets cubes(points_C, kEdge);
  const Eigen::Index count = std::ssize(cubes.keys());
  centres_C_.resize(count, 3);
  first_.push_back(0);
  for (Eigen::Index n = 0; n < count; ++n) {
    Eigen::Index end = first_.back();
    Eigen::AlignedBox3d around;
    for (const int i : cubes.members(static_cast<std::size_t>(n))) {
      points_C_.row(end++) = points_C[i].cast<float>().transpose();
      around.extend(points_C[i]);
    }
    centres_C_.row(n) = around.center().cast<float>().transpose();
    const Eigen::Array3f low = around.min().cast<float>(), high = around.max().cast<float>();
    if (n % kRun == 0) {
      runs_.push_back({low, high});
    } else {
      runs_.back() = {runs_.back().low.min(low), runs_.back().high.max(high)};
    }
    first_.push_back(end);
  }
}

bool ObstaclePoints::meet(const OrientedBox& box) const {
  const BoxTest exact(box), grown(box.inflated(kRadius));
  const Eigen::Array3f middle_C = box.p_CB.cast<float>().array();
  const Eigen::Array3f reach = box.reach().cast<float>().array() + kSlack;
  const Eigen::Array3f low = middle_C - reach, high = middle_C + reach;
  Inside inside;
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    const Bounds& run = runs_[r];
    // One test after the other ends sooner than all of them at once.
    if (run.high.x() < low.x() || run.low.x() > high.x() || run.high.y() < low.y() ||
        run.low.y() > high.y() || run.high.z() < low.z() || run.low.z() > high.z()) {
      continue;
    }
    const Eigen::Index first = static_cast<Eigen::Index>(r) * kRun;
    const Eigen::Index count = std::min(kRun, centres_C_.rows() - first);
    if (find_inside(centres_C_, first, count, grown, inside) == 0) continue;
    for (Eigen::Index n = 0; n < count; ++n) {
      if (inside[n] != 0 &&
          any_inside(points_C_, first_[first + n], first_[first + n + 1], exact)) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace quadrille
