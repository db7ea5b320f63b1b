#include "contacts/surface_points.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <tuple>
#include <utility>

#include "base/lanes.hpp"
#include "base/point_buckets.hpp"
#include "base/sorted_keys.hpp"

namespace quadrille {
namespace {

// Normals are taken over the points within so many cells; fewer points than the second number give
// none.
constexpr double kReachInCells = 3.2;
constexpr int kMinNeighbours = 6;

/// The mean of the points in each cell that one eye saw, and the number of that eye.
struct Thinned {
  std::vector<Eigen::Vector3d> points;
  std::vector<int> eyes;
};

/// Numbers the different eyes by their positions.
struct Eyes {
  /// In the order of their coordinates.
  std::vector<Eigen::Vector3d> positions_C;
  /// For each point, the number of its eye.
  std::vector<int> of_points;

  /// @param eyes_C  those of `count` points, or a single one that saw all
  Eyes(std::span<const Eigen::Vector3d> eyes_C, std::size_t count) {
    if (eyes_C.size() == 1) {
      positions_C.push_back(eyes_C.front());
      of_points.assign(count, 0);
      return;
    }
    for (const Eigen::Vector3d& eye_C : eyes_C) {
      // Most points follow one of their own eye.
      if (positions_C.empty() || (eye_C != positions_C.back() && number_of(eye_C) < 0)) {
        positions_C.push_back(eye_C);
      }
    }
    std::sort(positions_C.begin(), positions_C.end(), [](const auto& a, const auto& b) {
      return std::tuple(a.x(), a.y(), a.z()) < std::tuple(b.x(), b.y(), b.z());
    });
    of_points.reserve(eyes_C.size());
    for (const Eigen::Vector3d& eye_C : eyes_C) of_points.push_back(number_of(eye_C));
  }

 private:
  int number_of(const Eigen::Vector3d& eye_C) const {
    const auto found = std::find(positions_C.begin(), positions_C.end(), eye_C);
    return found == positions_C.end() ? -1 : static_cast<int>(found - positions_C.begin());
  }
};

/// Returns the cells of points in ascending order, with the points of each in the order of their
/// eyes, and those of an eye in the order in which they came.
std::vector<Keyed> sorted_cells(std::span<const Eigen::Vector3d> points,
                                std::span<const int> eye_of, int eyes, double cell) {
  std::vector<Keyed> cells;
  cells.reserve(points.size());
  for (int eye = 0; eye < eyes; ++eye) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      // Unlike spans, pointers do not check each access.
      if (eyes > 1 && eye_of.data()[i] != eye) continue;
      cells.push_back({PointBuckets::key_of(points.data()[i], cell), static_cast<int>(i)});
    }
  }
  sort_by_key(&cells);
  return cells;
}

Thinned thinned(std::span<const Eigen::Vector3d> points, std::span<const int> eye_of, int eyes,
                double cell) {
  const std::vector<Keyed> cells = sorted_cells(points, eye_of, eyes, cell);
  Thinned means;
  means.points.reserve(cells.size());
  means.eyes.reserve(cells.size());
  for (auto first = cells.begin(); first != cells.end();) {
    const int eye = eye_of.data()[first->index];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    auto last = first;
    for (; last != cells.end() && last->key == first->key && eye_of.data()[last->index] == eye;
         ++last) {
      sum += points.data()[last->index];
    }
    means.points.emplace_back(sum / static_cast<double>(last - first));
    means.eyes.push_back(eye);
    first = last;
  }
  return means;
}

/// The sums over the points near some points that their principal components need, each in the
/// lanes of these points.
struct Moments {
  /// Positions of these points, and the numbers of their eyes; NaN in lanes that are not used.
  alignas(32) std::array<double, kDoubleLanes> x, y, z;
  alignas(32) std::array<long long, kDoubleLanes> eye;
  /// Sums of x, y, z, xx, xy, xz, yy, yz and zz, and the numbers of points.
  std::array<std::array<double, kDoubleLanes>, 9> sums;
  std::array<long long, kDoubleLanes> counts;

  /// Returns the direction along which the points near one of these points spread least.
  Eigen::Vector3d normal(int lane) const {
    const auto s = [&](int n) { return sums[n][lane]; };
    const auto count = static_cast<double>(counts[lane]);
    Eigen::Matrix3d all;
    all << s(3), s(4), s(5), s(4), s(6), s(7), s(5), s(7), s(8);
    const Eigen::Vector3d mean = Eigen::Vector3d(s(0), s(1), s(2)) / count;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(all / count - mean * mean.transpose());
    return solver.eigenvectors().col(0);
  }
};

Moments gathered(const Eigen::Vector3d* points, const int* eye_of, std::span<const int> some) {
  Moments moments;
  moments.x.fill(std::numeric_limits<double>::quiet_NaN());
  moments.y = moments.z = moments.x;
  moments.eye.fill(-1);
  for (std::size_t k = 0; k < some.size(); ++k) {
    const Eigen::Vector3d& p = points[some[k]];
    moments.x[k] = p.x(), moments.y[k] = p.y(), moments.z[k] = p.z();
    moments.eye[k] = eye_of[some[k]];
  }
  return moments;
}

/// Sums over the points that lie within a distance, and that the same eye saw.
QUADRILLE_VECTOR_CLONES
void sum_near(const Eigen::Vector3d* points, const int* eye_of, const PointBuckets::Near& near,
              double reach, Moments* moments) {
  const auto px = reinterpret_cast<const DoubleLanes&>(moments->x);
  const auto py = reinterpret_cast<const DoubleLanes&>(moments->y);
  const auto pz = reinterpret_cast<const DoubleLanes&>(moments->z);
  const auto eye = reinterpret_cast<const DoubleMasks&>(moments->eye);
  const double most = reach * reach;
  DoubleLanes x = {}, y = {}, z = {}, xx = {}, xy = {}, xz = {}, yy = {}, yz = {}, zz = {};
  DoubleMasks count = {};
  for (const std::span<const int> row : near) {
    for (const int j : row) {
      DoubleLanes dx = points[j].x() - px, dy = points[j].y() - py, dz = points[j].z() - pz;
      const DoubleMasks in = (dx * dx + dy * dy + dz * dz <= most) & (eye == eye_of[j]);
      clear_outside(in, dx), clear_outside(in, dy), clear_outside(in, dz);
      x += dx, y += dy, z += dz;
      xx += dx * dx, xy += dx * dy, xz += dx * dz;
      yy += dy * dy, yz += dy * dz, zz += dz * dz;
      count -= in;
    }
  }
  const DoubleLanes sums[9] = {x, y, z, xx, xy, xz, yy, yz, zz};
  std::memcpy(moments->sums.data(), sums, sizeof(sums));
  std::memcpy(moments->counts.data(), &count, sizeof(count));
}

}  // namespace

PointSurface::PointSurface(std::span<const Eigen::Vector3d> points_C, double cell,
                           std::span<const Eigen::Vector3d> eyes_C)
    : reach_(kReachInCells * cell) {
  Eyes eyes(eyes_C, points_C.size());
  Thinned means =
      thinned(points_C, eyes.of_points, static_cast<int>(eyes.positions_C.size()), cell);
  points_C_ = std::move(means.points);
  eye_of_ = std::move(means.eyes);
  eyes_C_ = std::move(eyes.positions_C);
  buckets_ = PointBuckets(points_C_, reach_);
  near_ = buckets_.near_each();
  make_groups();
}

/// Divides the points into groups. The points of a cube have the same points near them.
void PointSurface::make_groups() {
  group_of_.resize(points_C_.size());
  for (std::size_t n = 0; n < near_.size(); ++n) {
    for (std::span<const int> rest = buckets_.members(n); !rest.empty();) {
      const std::span<const int> some =
          rest.first(std::min<std::size_t>(kDoubleLanes, rest.size()));
      rest = rest.subspan(some.size());
      for (const int i : some) group_of_[i] = groups_.size();
      groups_.push_back({n, some});
    }
  }
  normals_C_.resize(points_C_.size());
  states_ = std::vector<std::atomic<State>>(groups_.size());
}

/// Returns the normal of a point. If several threads ask for those of one group at once, each
/// computes them, and the first one keeps them.
Eigen::Vector3d PointSurface::normal(std::size_t point) const {
  const std::size_t number = group_of_.data()[point];
  std::atomic<State>& state = states_.data()[number];
  if (state.load(std::memory_order_acquire) == State::kReady) return normals_C_.data()[point];
  const Group& group = groups_[number];
  Moments moments = gathered(points_C_.data(), eye_of_.data(), group.points);
  sum_near(points_C_.data(), eye_of_.data(), near_[group.cube], reach_, &moments);
  State none = State::kNone;
  const bool keeps = state.compare_exchange_strong(none, State::kBusy);
  Eigen::Vector3d asked = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < group.points.size(); ++k) {
    const auto i = static_cast<std::size_t>(group.points[k]);
    Eigen::Vector3d n_C = Eigen::Vector3d::Zero();
    if (moments.counts[k] >= kMinNeighbours) {
      n_C = moments.normal(static_cast<int>(k));
      if (n_C.dot(eyes_C_[eye_of_[i]] - points_C_[i]) < 0.0) n_C = -n_C;
    }
    if (keeps) normals_C_[i] = n_C;
    if (i == point) asked = n_C;
  }
  if (keeps) state.store(State::kReady, std::memory_order_release);
  return asked;
}

SurfacePoints PointSurface::within(const Eigen::AlignedBox3d& box_C) const {
  SurfacePoints found;
  for (std::size_t i = 0; i < points_C_.size(); ++i) {
    const Eigen::Vector3d& p_C = points_C_.data()[i];
    if (!box_C.contains(p_C)) continue;
    found.p_C.push_back(p_C);
    found.n_C.push_back(normal(i));
  }
  return found;
}

SurfacePoints PointSurface::all() const {
  SurfacePoints found{points_C_, {}};
  for (std::size_t i = 0; i < points_C_.size(); ++i) found.n_C.push_back(normal(i));
  return found;
}

SurfacePoints surface_points(std::span<const Eigen::Vector3d> points_C, double cell,
                             std::span<const Eigen::Vector3d> eyes_C) {
  return PointSurface(points_C, cell, eyes_C).all();
}

}  // namespace quadrille
