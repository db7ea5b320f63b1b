#include "views/outdated.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "base/mask.hpp"
#include "cloud/drop_points.hpp"
#include "views/seen_through.hpp"

namespace quadrille {
namespace {

// Something was put down where so many of nine neighbouring cells show it; fewer are noise.
constexpr int kMinCells = 6;
// Edge of the cubes of which each holds one place [m].
constexpr float kPlaceEdge = 0.04f;
// Whatever was put down reaches no farther from the side that is seen of it than this [m]: what a
// hand carries is seldom larger.
constexpr float kMaxReach = 0.1f;

/// Number of marked cells among a cell and its eight neighbours.
int count_about(const Mask& cells, const Sight& sight, int i, int j) {
  int count = 0;
  for (int y = std::max(j - 1, 0); y <= std::min(j + 1, sight.height - 1); ++y) {
    for (int x = std::max(i - 1, 0); x <= std::min(i + 1, sight.width - 1); ++x) {
      count += cells[static_cast<std::size_t>(y) * sight.width + x];
    }
  }
  return count;
}

/// True if the ray from the eye to a point, or the point, comes near to a place.
bool passes(const Eigen::Vector3f& eye, const Eigen::Vector3f& p, const Eigen::Vector3f& place) {
  const Eigen::Vector3f ray = (p - eye).normalized();
  const Eigen::Vector3f to = place - eye;
  const float along = std::clamp(to.dot(ray), 0.0f, (p - eye).norm());
  return (to - along * ray).squaredNorm() < kMaxReach * kMaxReach;
}

/// True if a part of the line between two places lies in the box; false if one is not finite.
bool passes_through(const Eigen::AlignedBox3f& box, const Eigen::Vector3f& from,
                    const Eigen::Vector3f& to) {
  const Eigen::Array3f way = (to - from).array();
  float enter = 0.0f, leave = 1.0f;
  for (int axis = 0; axis < 3; ++axis) {
    const float low = box.min()[axis] - from[axis], high = box.max()[axis] - from[axis];
    if (way[axis] == 0.0f) {
      if (low > 0.0f || high < 0.0f) return false;
      continue;
    }
    enter = std::max(enter, std::min(low / way[axis], high / way[axis]));
    leave = std::min(leave, std::max(low / way[axis], high / way[axis]));
  }
  return way.allFinite() && enter <= leave;
}

/// The places of things that a newer view shows where an older one saw through, some centimetres
/// apart, in the frame of both sights [m].
std::vector<Eigen::Vector3f> put_down(const Sight& newer, const Sight& older) {
  const Mask through = cells_seen_through(newer, older);
  std::vector<Eigen::Vector3f> places;
  std::set<std::tuple<int, int, int>> taken;
  for (int j = 0; j < newer.height; ++j) {
    for (int i = 0; i < newer.width; ++i) {
      if (!through[static_cast<std::size_t>(j) * newer.width + i]) continue;
      if (count_about(through, newer, i, j) < kMinCells) continue;
      const Eigen::Vector3f place = place_of_cell(newer, i, j);
      const Eigen::Array3i cube = (place.array() / kPlaceEdge).floor().cast<int>();
      if (taken.emplace(cube.x(), cube.y(), cube.z()).second) places.push_back(place);
    }
  }
  return places;
}

}  // namespace

void drop_outdated(const Sight& older, const Sight& newer, PointCloud* cloud) {
  const std::vector<Eigen::Vector3f> places = put_down(newer, older);
  const Eigen::Vector3f eye = cloud->viewpoint.cast<float>();
  Mask dropped = points_seen_through(*cloud, older, newer);
  for (std::size_t n = 0; n < dropped.size() && !places.empty(); ++n) {
    dropped[n] |= std::any_of(places.begin(), places.end(), [&](const Eigen::Vector3f& place) {
      return passes(eye, cloud->points[n], place);
    });
  }
  drop_points(dropped, cloud);
}

void drop_seen_in(const Eigen::AlignedBox3f& box_R, const Eigen::Isometry3f& X_RC,
                  PointCloud* cloud) {
  const Eigen::Vector3f eye_R = X_RC * cloud->viewpoint.cast<float>();
  Mask dropped;
  for (const Eigen::Vector3f& p_C : cloud->points) {
    dropped.push_back(passes_through(box_R, eye_R, X_RC * p_C));
  }
  drop_points(dropped, cloud);
}

}  // namespace quadrille
