#include "views/outdated.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <tuple>

#include "base/mask.hpp"
#include "views/seen_through.hpp"
#include "views/seen_view.hpp"

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

}  // namespace

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

void drop_outdated(const Sight& older, const Sight& newer,
                   const std::vector<Eigen::Vector3f>& places, PointCloud* cloud) {
  const Mask gone = cells_seen_through(older, newer);
  const bool any_gone = std::find(gone.begin(), gone.end(), 1) != gone.end();
  if (!any_gone && places.empty()) return;
  const Eigen::Vector3f eye = cloud->viewpoint.cast<float>();
  const auto is_gone = [&](const Eigen::Vector3f& p) {
    const Eigen::Vector3f p_V = older.X_VC * p;
    const Eigen::Array2f at = (p_V.head<2>().array() / p_V.z() - older.corner) / older.step;
    const Eigen::Array2f size(static_cast<float>(older.width), static_cast<float>(older.height));
    if (!((at >= 0.0f).all() && (at < size).all())) return false;
    const std::size_t cell =
        static_cast<std::size_t>(at.y()) * older.width + static_cast<std::size_t>(at.x());
    return gone[cell] && sees_through(newer, p);
  };
  Mask dropped;
  dropped.reserve(cloud->points.size());
  for (const Eigen::Vector3f& p : cloud->points) {
    const bool hidden =
        std::any_of(places.begin(), places.end(),
                    [&](const Eigen::Vector3f& place) { return passes(eye, p, place); });
    dropped.push_back(hidden || (any_gone && is_gone(p)));
  }
  drop(dropped, cloud);
}

}  // namespace quadrille
