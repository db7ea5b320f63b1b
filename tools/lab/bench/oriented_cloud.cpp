#include "lab/bench/oriented_cloud.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cstdint>
#include <nanoflann.hpp>
#include <tuple>
#include <utility>

namespace quadrille::bench {
namespace {

constexpr int kMinInVoxel = 2, kMinNeighbours = 6;

// nanoflann 1.5.0 renamed its search parameters and gave its results a type of their own; Debian 12
// still has 1.4.
#if NANOFLANN_VERSION >= 0x150
using SearchParameters = nanoflann::SearchParameters;
using Neighbour = nanoflann::ResultItem<std::uint32_t, float>;
#else
using SearchParameters = nanoflann::SearchParams;
using Neighbour = std::pair<std::uint32_t, float>;
#endif

struct Points {
  const std::vector<Eigen::Vector3f>& list;
  std::size_t kdtree_get_point_count() const { return list.size(); }
  float kdtree_get_pt(std::size_t i, std::size_t axis) const { return list[i][axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

/// Returns the centroids in the order of the voxels.
std::vector<Eigen::Vector3f> centroids(const std::vector<Eigen::Vector3f>& points, double voxel) {
  using Key = std::array<int, 3>;
  std::vector<std::pair<Key, std::size_t>> keys;
  keys.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f p = (points[i] / static_cast<float>(voxel)).array().floor();
    keys.emplace_back(
        Key{static_cast<int>(p.x()), static_cast<int>(p.y()), static_cast<int>(p.z())}, i);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<Eigen::Vector3f> result;
  for (std::size_t first = 0, last = 0; first < keys.size(); first = last) {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (; last < keys.size() && keys[last].first == keys[first].first; ++last) {
      sum += points[keys[last].second];
    }
    if (last - first >= kMinInVoxel) result.push_back(sum / static_cast<float>(last - first));
  }
  return result;
}

Eigen::Vector3f normal_of(const std::vector<Eigen::Vector3f>& points, const std::vector<int>& ball,
                          const Eigen::Vector3f& p) {
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  Eigen::Matrix3f moment = Eigen::Matrix3f::Zero();
  for (const int i : ball) {
    const Eigen::Vector3f d = points[i] - p;
    mean += d;
    moment += d * d.transpose();
  }
  const float count = static_cast<float>(ball.size());
  mean /= count;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(moment / count - mean * mean.transpose());
  const Eigen::Vector3f n = solver.eigenvectors().col(0);
  return n.dot(p) > 0.0f ? Eigen::Vector3f(-n) : n;
}

}  // namespace

struct NeighbourSearch::Tree {
  explicit Tree(const std::vector<Eigen::Vector3f>& list)
      : points{list}, index(3, points, nanoflann::KDTreeSingleIndexAdaptorParams(12)) {}
  Points points;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Points>, Points, 3,
                                      std::uint32_t>
      index;
};

NeighbourSearch::NeighbourSearch(const std::vector<Eigen::Vector3f>& points)
    : tree_(std::make_unique<Tree>(points)) {}

NeighbourSearch::~NeighbourSearch() = default;

std::vector<int> NeighbourSearch::within(const Eigen::Vector3f& p, double radius) const {
  std::vector<Neighbour> found;
  SearchParameters params;
  params.sorted = false;
  // Later releases forbid ignoring the returned count.
  std::ignore =
      tree_->index.radiusSearch(p.data(), static_cast<float>(radius * radius), found, params);
  std::vector<int> list;
  for (const auto& [i, distance] : found) list.push_back(static_cast<int>(i));
  std::sort(list.begin(), list.end());
  return list;
}

OrientedCloud orient(const std::vector<Eigen::Vector3f>& points,
                     const OrientationOptions& options) {
  const std::vector<Eigen::Vector3f> thinned = centroids(points, options.voxel);
  OrientedCloud cloud;
  if (thinned.empty()) return cloud;
  const NeighbourSearch search(thinned);
  for (const Eigen::Vector3f& p : thinned) {
    const std::vector<int> ball = search.within(p, options.normal_radius);
    if (static_cast<int>(ball.size()) < kMinNeighbours) continue;
    cloud.points.push_back(p);
    cloud.normals.push_back(normal_of(thinned, ball, p));
  }
  return cloud;
}

}  // namespace quadrille::bench
