#include "lab/bench/plain_ransac.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/random.hpp"
#include "fits/compact_fit.hpp"
#include "fits/taubin_fit.hpp"

namespace quadrille::bench {
namespace {

Quadric plane_through(const Eigen::Vector3d& p, const Eigen::Vector3d& n) {
  Vector10d q = Vector10d::Zero();
  q.segment<3>(6) = 0.5 * n;
  q[9] = -n.dot(p);
  return Quadric(q);
}

class PlainRansac {
 public:
  PlainRansac(const OrientedCloud& cloud, const PlainOptions& options)
      : cloud_(cloud), options_(options), random_(options.seed, 0) {
    for (int i = 0; i < static_cast<int>(cloud.points.size()); ++i) open_.push_back(i);
    closed_.assign(cloud.points.size(), 0);
  }

  std::vector<Found> run() {
    constexpr int kPlanes = 4;
    for (int k = 0; k < kPlanes && take_plane(); ++k) {
    }
    if (cloud_.points.empty()) return found_;
    const NeighbourSearch search(cloud_.points);
    for (int round = 0; round < options_.rounds; ++round) {
      if (static_cast<int>(open_.size()) < options_.min_points || !take_quadric(search)) break;
    }
    return found_;
  }

 private:
  Eigen::Vector3d p(int i) const { return cloud_.points[i].cast<double>(); }
  Eigen::Vector3d n(int i) const { return cloud_.normals[i].cast<double>(); }
  int any_of(const std::vector<int>& list) {
    return list[static_cast<std::size_t>(random_.below(static_cast<int>(list.size())))];
  }

  std::vector<int> inliers(const Quadric& Q, const std::vector<int>& list, double epsilon) const {
    std::vector<int> result;
    for (const int i : list) {
      const Eigen::Vector3d g = Q.gradient(p(i));
      const double length = g.norm();
      if (std::abs(Q.value(p(i))) <= epsilon * length &&
          std::abs(g.dot(n(i))) >= options_.min_cosine * length && length > 0.0) {
        result.push_back(i);
      }
    }
    return result;
  }

  void take(const Quadric& Q, const std::vector<int>& points) {
    found_.push_back({Q, static_cast<double>(points.size())});
    for (const int i : points) closed_[i] = 1;
    std::erase_if(open_, [&](int i) { return closed_[i] != 0; });
  }

  bool take_plane() {
    constexpr int kTrials = 150, kStep = 8;
    std::vector<int> some;
    for (std::size_t i = 0; i < open_.size(); i += kStep) some.push_back(open_[i]);
    if (some.empty()) return false;
    Quadric best;
    std::size_t most = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
      const int i = any_of(open_);
      const Quadric Q = plane_through(p(i), n(i));
      const std::size_t count = inliers(Q, some, options_.plane_epsilon).size();
      if (count > most) best = Q, most = count;
    }
    std::vector<int> points = inliers(best, open_, options_.plane_epsilon);
    for (int round = 0; round < 2 && points.size() >= 3; ++round) {
      best = fit_plane(points);
      points = inliers(best, open_, options_.plane_epsilon);
    }
    const double least = options_.min_plane * static_cast<double>(cloud_.points.size());
    if (static_cast<double>(points.size()) < least) return false;
    take(best, points);
    return true;
  }

  Quadric fit_plane(const std::vector<int>& points) const {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
    for (const int i : points) {
      mean += p(i);
      moment += p(i) * p(i).transpose();
    }
    const double count = static_cast<double>(points.size());
    mean /= count;
    moment = moment / count - mean * mean.transpose();
    return plane_through(
        mean, Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moment).eigenvectors().col(0));
  }

  std::optional<Quadric> draw(int seed, const std::vector<int>& ball) {
    const bool nine = options_.basis == PlainBasis::kNinePoints;
    OrientedPointsd basis(nine ? 9 : 4);
    for (Eigen::Index k = 0; k < basis.size(); ++k) {
      const int i = k == 0 ? seed : any_of(ball);
      basis.points.col(k) = p(i);
      basis.normals.col(k) = n(i);
    }
    return nine ? fit_taubin(basis) : fit_compact(basis);
  }

  bool is_curved(const std::vector<int>& points) const {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const int i : points) mean += n(i);
    double cosines = 0.0;
    for (const int i : points) cosines += mean.normalized().dot(n(i));
    return cosines / static_cast<double>(points.size()) < std::cos(options_.min_spread);
  }

  std::vector<int> open_within(const NeighbourSearch& search, int seed, double radius) const {
    std::vector<int> list = search.within(cloud_.points[seed], radius);
    std::erase_if(list, [&](int i) { return closed_[i] != 0; });
    return list;
  }

  bool take_quadric(const NeighbourSearch& search) {
    std::optional<Quadric> best;
    std::size_t most = 0;
    std::vector<int> around;
    for (int trial = 0; trial < options_.trials; ++trial) {
      const int seed = any_of(open_);
      const std::vector<int> ball = open_within(search, seed, options_.reach);
      if (ball.size() < 40) continue;
      const auto Q = draw(seed, ball);
      if (!Q) continue;
      const std::vector<int> wide = open_within(search, seed, 2.0 * options_.reach);
      const std::vector<int> points = inliers(*Q, wide, options_.epsilon);
      if (points.size() > most && is_curved(points)) best = Q, most = points.size(), around = wide;
    }
    if (!best) return false;
    const std::vector<int> points = refine(around, &*best);
    if (static_cast<int>(points.size()) < options_.min_points) return false;
    take(*best, points);
    return true;
  }

  /// Alternates between a least-squares fit to the inliers and a new choice of inliers, a few
  /// times.
  std::vector<int> refine(const std::vector<int>& around, Quadric* Q) const {
    std::vector<int> points = inliers(*Q, around, options_.epsilon);
    for (int round = 0; round < 4; ++round) {
      OrientedPointsd data(static_cast<Eigen::Index>(points.size()));
      for (Eigen::Index k = 0; k < data.size(); ++k) {
        data.points.col(k) = p(points[static_cast<std::size_t>(k)]);
        data.normals.col(k) = n(points[static_cast<std::size_t>(k)]);
      }
      const auto fitted = fit_compact(data);
      if (!fitted) break;
      std::vector<int> next = inliers(*fitted, around, options_.epsilon);
      if (next.size() < points.size()) break;
      *Q = *fitted;
      points = std::move(next);
    }
    return points;
  }

  const OrientedCloud& cloud_;
  const PlainOptions& options_;
  RandomStream random_;
  std::vector<int> open_;
  std::vector<char> closed_;
  std::vector<Found> found_;
};

}  // namespace

std::vector<Found> plain_ransac(const std::vector<Eigen::Vector3f>& points,
                                const PlainOptions& options) {
  const OrientedCloud cloud = orient(points, options.orientation);
  return PlainRansac(cloud, options).run();
}

}  // namespace quadrille::bench
