#include "contacts/surface_points.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <compare>
#include <tuple>
#include <utility>

#include "base/point_buckets.hpp"

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

/// Numbers different eyes by their positions.
class Eyes {
 public:
  explicit Eyes(std::span<const Eigen::Vector3d> eyes_C) {
    for (const Eigen::Vector3d& eye_C : eyes_C) {
      if (positions_C_.empty() || number_of(eye_C) < 0) positions_C_.push_back(eye_C);
    }
    std::sort(positions_C_.begin(), positions_C_.end(), [](const auto& a, const auto& b) {
      return std::tuple(a.x(), a.y(), a.z()) < std::tuple(b.x(), b.y(), b.z());
    });
  }

  const Eigen::Vector3d& operator[](int number) const { return positions_C_[number]; }
  int number_of(const Eigen::Vector3d& eye_C) const {
    const auto found = std::find(positions_C_.begin(), positions_C_.end(), eye_C);
    return found == positions_C_.end() ? -1 : static_cast<int>(found - positions_C_.begin());
  }

 private:
  std::vector<Eigen::Vector3d> positions_C_;
};

Thinned thinned(std::span<const Eigen::Vector3d> points, std::span<const Eigen::Vector3d> eyes_C,
                const Eyes& eyes, double cell) {
  struct Keyed {
    PointBuckets::Key key;
    int eye, point;
    // clang-tidy takes the zero of a comparison for a pointer.
    auto operator<=>(const Keyed&) const = default;  // NOLINT(modernize-use-nullptr)
  };
  std::vector<Keyed> keyed;
  keyed.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    keyed.push_back(
        {PointBuckets::key_of(points[i], cell), eyes.number_of(eyes_C[i]), static_cast<int>(i)});
  }
  std::sort(keyed.begin(), keyed.end());
  Thinned means;
  for (auto first = keyed.begin(); first != keyed.end();) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    auto last = first;
    for (; last != keyed.end() && last->key == first->key && last->eye == first->eye; ++last) {
      sum += points[last->point];
    }
    means.points.emplace_back(sum / static_cast<double>(last - first));
    means.eyes.push_back(first->eye);
    first = last;
  }
  return means;
}

/// The sums over some points that their principal components need.
struct Moments {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  /// Sums of xx, xy, xz, yy, yz and zz.
  Eigen::Array<double, 6, 1> squares = Eigen::Array<double, 6, 1>::Zero();
  int count = 0;

  void add(const Eigen::Vector3d& d) {
    sum += d;
    squares += (Eigen::Array<double, 6, 1>() << d.x() * d.x(), d.x() * d.y(), d.x() * d.z(),
                d.y() * d.y(), d.y() * d.z(), d.z() * d.z())
                   .finished();
    ++count;
  }

  /// Returns the direction along which the points spread least.
  Eigen::Vector3d normal() const {
    const Eigen::Array<double, 6, 1>& s = squares;
    Eigen::Matrix3d all;
    all << s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5];
    const Eigen::Vector3d mean = sum / count;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(all / count - mean * mean.transpose());
    return solver.eigenvectors().col(0);
  }
};

}  // namespace

SurfacePoints surface_points(std::span<const Eigen::Vector3d> points_C, double cell,
                             std::span<const Eigen::Vector3d> eyes_C) {
  SurfacePoints surface;
  const Eyes eyes(eyes_C);
  Thinned means = thinned(points_C, eyes_C, eyes, cell);
  surface.p_C = std::move(means.points);
  surface.n_C.assign(surface.p_C.size(), Eigen::Vector3d::Zero());
  const double reach = kReachInCells * cell;
  const PointBuckets buckets(surface.p_C, reach);
  const std::vector<PointBuckets::Near> near = buckets.near_each();
  // Unlike vectors, these do not check each access.
  const Eigen::Vector3d* points = surface.p_C.data();
  const int* eye_of = means.eyes.data();
  for (std::size_t n = 0; n < near.size(); ++n) {
    for (const int i : buckets.members(n)) {
      const Eigen::Vector3d& p = points[i];
      const int eye = eye_of[i];
      Moments moments;
      for (const std::span<const int> row : near[n]) {
        for (const int j : row) {
          const Eigen::Vector3d d = points[j] - p;
          if (d.squaredNorm() <= reach * reach && eye == eye_of[j]) moments.add(d);
        }
      }
      if (moments.count < kMinNeighbours) continue;
      const Eigen::Vector3d n_C = moments.normal();
      const bool away = n_C.dot(eyes[eye] - p) < 0.0;
      surface.n_C[i] = away ? Eigen::Vector3d(-n_C) : n_C;
    }
  }
  return surface;
}

}  // namespace quadrille
