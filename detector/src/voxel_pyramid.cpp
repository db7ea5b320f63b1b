#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nanoflann.hpp>
#include <tuple>
#include <utility>

#include "quadrille/detector/cell_pyramid.hpp"
#include "quadrille/detector/parallel.hpp"

namespace quadrille {
namespace {

constexpr int kNeighbours = 8;
// Radii of normals and of neighbours, in cells.
constexpr float kNormalReach = 2.6f, kPlaneReach = 1.9f, kNextReach = 1.9f;
constexpr std::size_t kLeastPoints = 50;
// Voxel coordinates are packed into 21 bits each.
constexpr std::int64_t kMostVoxels = (1 << 20) - 1;

struct VoxelLevel {
  float edge = 0;
  std::vector<Eigen::Vector3f> mean;
  std::vector<int> count;
  /// Index at the next coarser level.
  std::vector<int> parent;
};

/// Voxels of some points: means, in the order of first appearance; of_point gets the voxel of each.
VoxelLevel voxels_of(const std::vector<Eigen::Vector3f>& points, const std::vector<int>& weight,
                     float edge, std::vector<int>* of_point) {
  std::size_t slots = 16;
  while (slots < 2 * points.size()) slots *= 2;
  std::vector<std::uint64_t> key(slots, ~std::uint64_t{0});
  std::vector<int> index(slots, -1);
  VoxelLevel level;
  level.edge = edge;
  std::vector<Eigen::Vector3d> sum;
  of_point->resize(points.size());
  const auto coordinate = [&](float x) {
    const double c = std::floor(static_cast<double>(x) / edge);
    return static_cast<std::uint64_t>(
        static_cast<std::int64_t>(std::clamp(c, -1.0 * kMostVoxels, 1.0 * kMostVoxels)) +
        kMostVoxels);
  };
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Eigen::Vector3f& p = points[k];
    const std::uint64_t packed =
        coordinate(p.x()) | coordinate(p.y()) << 21 | coordinate(p.z()) << 42;
    std::size_t slot = (packed * 0x9e3779b97f4a7c15u >> 20) & (slots - 1);
    while (key[slot] != packed && index[slot] >= 0) slot = (slot + 1) & (slots - 1);
    if (index[slot] < 0) {
      key[slot] = packed;
      index[slot] = static_cast<int>(sum.size());
      sum.push_back(Eigen::Vector3d::Zero());
      level.count.push_back(0);
    }
    const int v = index[slot];
    (*of_point)[k] = v;
    sum[v] += weight[k] * p.cast<double>();
    level.count[v] += weight[k];
  }
  for (std::size_t v = 0; v < sum.size(); ++v) {
    level.mean.push_back((sum[v] / level.count[v]).cast<float>());
  }
  return level;
}

// Release 1.5.0 of nanoflann renamed its search parameters and gave its results a type of their
// own; Debian 12 still has 1.4.
#if NANOFLANN_VERSION >= 0x150
using SearchParameters = nanoflann::SearchParameters;
using Neighbour = nanoflann::ResultItem<std::uint32_t, float>;
#else
using SearchParameters = nanoflann::SearchParams;
using Neighbour = std::pair<std::uint32_t, float>;
#endif

/// Neighbour search over positions.
class Neighbours {
 public:
  explicit Neighbours(const std::vector<Eigen::Vector3f>& points)
      : points_{points}, tree_(3, points_, nanoflann::KDTreeSingleIndexAdaptorParams(12)) {}

  /// Indices within the radius, nearest first; equal distances by index.
  std::vector<int> within(const Eigen::Vector3f& p, float radius) const {
    std::vector<Neighbour> found;
    SearchParameters params;
    params.sorted = false;
    // The count that it returns must not be ignored as of some later release.
    std::ignore = tree_.radiusSearch(p.data(), radius * radius, found, params);
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
      return a.second != b.second ? a.second < b.second : a.first < b.first;
    });
    std::vector<int> list;
    for (const auto& [i, distance] : found) list.push_back(static_cast<int>(i));
    return list;
  }

 private:
  struct Points {
    const std::vector<Eigen::Vector3f>& list;
    std::size_t kdtree_get_point_count() const { return list.size(); }
    float kdtree_get_pt(std::size_t i, std::size_t axis) const { return list[i][axis]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
      return false;
    }
  };
  Points points_;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Points>, Points, 3,
                                      std::uint32_t>
      tree_;
};

/// Plane through points by principal components: mean, and normal as the direction of least spread.
bool plane_of(const std::vector<Eigen::Vector3f>& points, const std::vector<int>& list,
              Eigen::Vector3f* mean, Eigen::Vector3f* normal) {
  if (list.size() < 4) return false;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int i : list) sum += points[i].cast<double>();
  const Eigen::Vector3d centre = sum / static_cast<double>(list.size());
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  for (const int i : list) {
    const Eigen::Vector3d d = points[i].cast<double>() - centre;
    S += d * d.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(S);
  // Points on a line have no normal.
  if (!(eigen.eigenvalues()[1] > 0.05 * eigen.eigenvalues()[2])) return false;
  *mean = centre.cast<float>();
  *normal = eigen.eigenvectors().col(0).cast<float>();
  return normal->allFinite();
}

/// Residual of a quadratic height over the plane of the neighbourhood; negative if it has too few.
float quadratic_residual(const std::vector<Eigen::Vector3f>& points, const std::vector<int>& list,
                         float radius) {
  Eigen::Vector3f mean, normal;
  if (list.size() < 18 || !plane_of(points, list, &mean, &normal)) return -1.0f;
  const Eigen::Vector3f e1 = normal.unitOrthogonal(), e2 = normal.cross(e1);
  Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> b = Eigen::Matrix<double, 6, 1>::Zero();
  double hh = 0;
  for (const int i : list) {
    const Eigen::Vector3f d = (points[i] - mean) / radius;
    const double s = d.dot(e1), t = d.dot(e2), h = d.dot(normal);
    Eigen::Matrix<double, 6, 1> row;
    row << 1, s, t, s * s, s * t, t * t;
    A += row * row.transpose();
    b += h * row;
    hh += h * h;
  }
  const Eigen::Matrix<double, 6, 1> a = A.ldlt().solve(b);
  const double rss = std::max(0.0, hh - a.dot(b));
  return radius * static_cast<float>(std::sqrt(rss / static_cast<double>(list.size() - 6)));
}

class VoxelPyramid : public CellPyramid {
 public:
  VoxelPyramid(const PointCloud& cloud, float edge, const NoiseOptions& noise)
      : eye_(cloud.viewpoint.cast<float>()) {
    std::vector<Eigen::Vector3f> points;
    for (const Eigen::Vector3f& p : cloud.points) {
      if (p.allFinite()) points.push_back(p);
    }
    std::vector<int> of_point;
    levels_[0] = voxels_of(points, std::vector<int>(points.size(), 1), edge, &of_point);
    for (int l = 1; l < kLevels; ++l) {
      VoxelLevel& finer = levels_[l - 1];
      levels_[l] = voxels_of(finer.mean, finer.count, 2 * finer.edge, &finer.parent);
    }
    measure(noise);
  }

  int size(int level) const override { return static_cast<int>(levels_[level].mean.size()); }
  const std::vector<int>& parents(int level) const override { return levels_[level].parent; }
  int count(int cell) const override { return levels_[0].count[cell]; }
  Eigen::Vector3f mean(int cell) const override { return levels_[0].mean[cell]; }
  float sigma(int) const override { return sigma_[0]; }

  SurfaceSamples coarse_samples() const override {
    return make(kLevels - 1, std::vector<char>(levels_[kLevels - 1].mean.size(), 1), kPlaneReach);
  }

  std::vector<SurfaceSamples> samples(const std::vector<char>& keep, int threads) const override {
    std::array<std::vector<char>, kLevels> kept;
    kept[0] = keep;
    for (int l = 1; l < kLevels; ++l) {
      // A coarse voxel stays where most of its points do.
      std::vector<int> balance(levels_[l].mean.size(), 0);
      for (std::size_t c = 0; c < kept[l - 1].size(); ++c) {
        const int n = levels_[l - 1].count[c];
        balance[levels_[l - 1].parent[c]] += kept[l - 1][c] ? n : -n;
      }
      for (const int b : balance) kept[l].push_back(b > 0);
    }
    std::vector<SurfaceSamples> result(kLevels);
    parallel_for(kLevels, threads, [&](int l) {
      result[l] = make(l, kept[l], kNormalReach);
      result[l].common_noise = common_share(sigma_.front(), sigma_.back());
    });
    return result;
  }

 private:
  void measure(const NoiseOptions& options) {
    sigma_.fill(1e-3f);
    for (int l = 0; l < kLevels; ++l) {
      const std::vector<Eigen::Vector3f>& points = levels_[l].mean;
      const Neighbours neighbours(points);
      const float radius = std::max(static_cast<float>(options.radius), 3.0f * levels_[l].edge);
      std::vector<float> residual;
      const std::size_t stride = std::max<std::size_t>(1, points.size() / options.patches);
      for (std::size_t i = 0; i < points.size(); i += stride) {
        const float r = quadratic_residual(points, neighbours.within(points[i], radius), radius);
        if (r >= 0) residual.push_back(r);
      }
      if (residual.size() < 8) continue;
      const auto at =
          residual.begin() +
          static_cast<std::ptrdiff_t>(options.quantile * static_cast<double>(residual.size() - 1));
      std::nth_element(residual.begin(), at, residual.end());
      sigma_[l] = std::max(1e-4f, *at);
    }
  }

  SurfaceSamples make(int l, const std::vector<char>& keep, float reach) const {
    const VoxelLevel& level = levels_[l];
    std::vector<Eigen::Vector3f> points;
    std::vector<int> cell;
    for (std::size_t c = 0; c < level.mean.size(); ++c) {
      if (!keep[c]) continue;
      points.push_back(level.mean[c]);
      cell.push_back(static_cast<int>(c));
    }
    SurfaceSamples samples;
    samples.first.push_back(0);
    if (points.empty()) return samples;
    const Neighbours neighbours(points);
    std::vector<int> sample_of(points.size(), -1);
    std::vector<std::vector<int>> next;
    for (std::size_t i = 0; i < points.size(); ++i) {
      std::vector<int> list = neighbours.within(points[i], reach * level.edge);
      Eigen::Vector3f mean, normal;
      if (!plane_of(points, list, &mean, &normal)) continue;
      if (normal.dot(eye_ - points[i]) < 0) normal = -normal;
      sample_of[i] = samples.size();
      samples.p.push_back(points[i] - normal * normal.dot(points[i] - mean));
      samples.n.push_back(normal);
      samples.raw.push_back(points[i]);
      samples.sigma.push_back(sigma_[l]);
      samples.cell.push_back(level.edge);
      samples.count.push_back(level.count[cell[i]]);
      samples.source.push_back(cell[i]);
      std::erase_if(list, [&](int j) {
        return j == static_cast<int>(i) || (points[j] - points[i]).norm() > kNextReach * level.edge;
      });
      if (list.size() > kNeighbours) list.resize(kNeighbours);
      next.push_back(std::move(list));
    }
    for (const std::vector<int>& list : next) {
      for (const int j : list) {
        if (sample_of[j] >= 0) samples.neighbours.push_back(sample_of[j]);
      }
      samples.first.push_back(static_cast<int>(samples.neighbours.size()));
    }
    return samples;
  }

  Eigen::Vector3f eye_;
  std::array<VoxelLevel, kLevels> levels_;
  std::array<float, kLevels> sigma_{};
};

}  // namespace

std::unique_ptr<CellPyramid> make_voxel_pyramid(const PointCloud& cloud,
                                                const SamplingOptions& options) {
  const auto finite = std::count_if(cloud.points.begin(), cloud.points.end(),
                                    [](const Eigen::Vector3f& p) { return p.allFinite(); });
  if (static_cast<std::size_t>(finite) < kLeastPoints) return nullptr;
  const float edge = static_cast<float>(options.cell);
  auto pyramid = std::make_unique<VoxelPyramid>(cloud, edge, options.noise);
  if (pyramid->sigma(0) > static_cast<float>(options.noisiest_cell) * edge) {
    pyramid = std::make_unique<VoxelPyramid>(cloud, 2 * edge, options.noise);
  }
  return pyramid;
}

std::unique_ptr<CellPyramid> make_pyramid(const PointCloud& cloud, const SamplingOptions& options) {
  if (auto pyramid = make_depth_pyramid(cloud, options)) return pyramid;
  return make_voxel_pyramid(cloud, options);
}

}  // namespace quadrille
