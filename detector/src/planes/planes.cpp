#include "planes/planes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "samples/height_fit.hpp"

namespace quadrille {
namespace {

constexpr double kCoplanarCosine = 0.99;

/// Running sums for a plane by total least squares.
struct PlaneSums {
  double n = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();

  void add(const Eigen::Vector3f& p) {
    const Eigen::Vector3d x = p.cast<double>();
    n += 1;
    sum += x;
    square += x * x.transpose();
  }
  Eigen::Vector4d plane(const Eigen::Vector3f& towards) const {
    const Eigen::Vector3d mean = sum / n;
    const Eigen::Matrix3d S = square / n - mean * mean.transpose();
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
    eigen.computeDirect(S);
    Eigen::Vector3d m = eigen.eigenvectors().col(0);
    if (m.dot(towards.cast<double>()) < 0) m = -m;
    return {m.x(), m.y(), m.z(), -m.dot(mean)};
  }
};

/// Samples to start from, the flattest first: those with whose normals their neighbours' agree
/// within the angle [rad].
std::vector<int> flat_seeds(const SurfaceSamples& samples, double angle,
                            const std::vector<char>& claimed) {
  const float min_cosine = static_cast<float>(std::cos(angle));
  std::vector<std::pair<float, int>> flat;
  for (int i = 0; i < samples.size(); ++i) {
    const auto around = samples.neighbours_of(i);
    if (around.size() < 5 || (!claimed.empty() && claimed[i])) continue;
    float sum = 0;
    for (const int j : around) sum += samples.n[i].dot(samples.n[j]);
    const float mean = sum / static_cast<float>(around.size());
    if (mean >= min_cosine) flat.emplace_back(-mean, i);
  }
  std::sort(flat.begin(), flat.end());
  std::vector<int> seeds;
  for (const auto& [key, i] : flat) seeds.push_back(i);
  return seeds;
}

/// Curvature of a quadratic fit over the plane where it bends most, and its standard deviation
/// [1/m].
std::pair<double, double> curvature_of(const SurfaceSamples& samples, const PlaneRegion& region) {
  const Eigen::Vector3d m = region.plane.head<3>();
  const Eigen::Vector3d e1 = m.unitOrthogonal(), e2 = m.cross(e1);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const int i : region.samples) mean += samples.raw[i].cast<double>();
  mean /= static_cast<double>(region.samples.size());
  HeightFit fit;
  for (const int i : region.samples) {
    const Eigen::Vector3d x = samples.raw[i].cast<double>() - mean;
    fit.add(x.dot(e1), x.dot(e2), x.dot(m));
  }
  const auto ldlt = fit.factor();
  const HeightFit::Vector6 a = ldlt.solve(fit.b);
  const double n = static_cast<double>(region.samples.size());
  const double variance = std::max(1e-12, fit.rss(a)) / std::max(1.0, n / 4 - 6);
  const HeightFit::Matrix6 covariance = variance * ldlt.solve(HeightFit::Matrix6::Identity());
  Eigen::Matrix2d H;
  H << 2 * a[3], a[4], a[4], 2 * a[5];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(H);
  const int k = std::abs(eigen.eigenvalues()[0]) > std::abs(eigen.eigenvalues()[1]) ? 0 : 1;
  const Eigen::Vector2d d = eigen.eigenvectors().col(k);
  HeightFit::Vector6 g;
  g << 0, 0, 0, 2 * d[0] * d[0], 2 * d[0] * d[1], 2 * d[1] * d[1];
  return {std::abs(eigen.eigenvalues()[k]), std::sqrt(g.dot(covariance * g))};
}

/// True unless the region is shown to be flat: it must not bend significantly, and what it may bend
/// within the noise must be little. Narrow strips of cylinders are not shown to be flat.
bool may_bend(const SurfaceSamples& samples, const PlaneRegion& region,
              const PlaneOptions& options) {
  const auto [curvature, std] = curvature_of(samples, region);
  return (curvature > 1.0 / options.min_radius && curvature > 3.0 * std) ||
         curvature + 2.0 * std > 1.0 / options.min_proven_radius;
}

/// Joins planes that noise or an object between had parted: nearly parallel, and the smaller one
/// within the noise of the larger.
std::vector<PlaneRegion> join_coplanar(const SurfaceSamples& samples,
                                       std::vector<PlaneRegion> planes,
                                       const PlaneOptions& options) {
  std::stable_sort(planes.begin(), planes.end(), [](const PlaneRegion& a, const PlaneRegion& b) {
    return a.samples.size() > b.samples.size();
  });
  const auto coplanar = [&](const PlaneRegion& large, const PlaneRegion& small) {
    // Seen from within the plane, the sides that its parts turn are chance.
    const double cosine = large.plane.head<3>().dot(small.plane.head<3>());
    if (std::abs(cosine) < kCoplanarCosine) return false;
    double distance = 0, limit = 0;
    for (const int i : small.samples) {
      distance += std::abs(large.plane.dot(samples.raw[i].cast<double>().homogeneous()));
      limit += options.sigmas * samples.sigma[i];
    }
    return distance < limit;
  };
  std::vector<PlaneRegion> joined;
  for (PlaneRegion& plane : planes) {
    const auto host = std::find_if(joined.begin(), joined.end(), [&](const PlaneRegion& large) {
      return coplanar(large, plane);
    });
    if (host == joined.end()) {
      joined.push_back(std::move(plane));
      continue;
    }
    host->samples.insert(host->samples.end(), plane.samples.begin(), plane.samples.end());
    PlaneSums sums;
    for (const int i : host->samples) sums.add(samples.raw[i]);
    host->plane = sums.plane(host->plane.head<3>().cast<float>());
  }
  return joined;
}

/// The plane through a seed and its free neighbours; nullopt if they are too few.
std::optional<Eigen::Vector4d> plane_at(const SurfaceSamples& samples, int seed,
                                        const std::vector<int>& taken) {
  PlaneSums sums;
  sums.add(samples.raw[seed]);
  for (const int j : samples.neighbours_of(seed)) {
    if (!taken[j]) sums.add(samples.raw[j]);
  }
  if (sums.n < 4) return std::nullopt;
  return sums.plane(samples.n[seed]);
}

/// Grows a plane over neighbours that are free, near it and parallel to it, and marks them with the
/// number of the attempt.
PlaneRegion grow_plane(const SurfaceSamples& samples, const PlaneOptions& options, int seed,
                       const Eigen::Vector4d& start, int attempt, std::vector<int>* taken) {
  const float min_cosine = static_cast<float>(std::cos(options.angle));
  const float sigmas = static_cast<float>(options.sigmas);
  PlaneRegion region{start, {seed}};
  PlaneSums sums;
  sums.add(samples.raw[seed]);
  Eigen::Vector4f P = start.cast<float>();
  std::size_t refit_at = 12;
  for (std::size_t k = 0; k < region.samples.size(); ++k) {
    for (const int j : samples.neighbours_of(region.samples[k])) {
      if ((*taken)[j]) continue;
      const float distance = P.dot(samples.raw[j].homogeneous());
      const float limit = sigmas * samples.sigma[j] + 0.05f * samples.cell[j];
      if (std::abs(distance) > limit || P.head<3>().dot(samples.n[j]) < min_cosine) continue;
      (*taken)[j] = attempt;
      region.samples.push_back(j);
      sums.add(samples.raw[j]);
    }
    if (region.samples.size() >= refit_at) {
      P = sums.plane(samples.n[seed]).cast<float>();
      refit_at = region.samples.size() * 2;
    }
  }
  if (sums.n >= 4) region.plane = sums.plane(samples.n[seed]);
  return region;
}

}  // namespace

std::vector<PlaneRegion> find_planes(const SurfaceSamples& samples, const PlaneOptions& options,
                                     const std::vector<char>& claimed) {
  std::vector<PlaneRegion> planes;
  // 0 free, 1 claimed, otherwise the number of the attempt that took it.
  std::vector<int> taken(claimed.begin(), claimed.end());
  taken.resize(static_cast<std::size_t>(samples.size()), 0);
  std::vector<char> bent(taken.size(), 0);
  int attempt = 1;
  for (const int seed : flat_seeds(samples, options.angle, claimed)) {
    if (taken[seed] || bent[seed]) continue;
    taken[seed] = ++attempt;
    const std::optional<Eigen::Vector4d> start = plane_at(samples, seed, taken);
    if (!start) continue;
    PlaneRegion region = grow_plane(samples, options, seed, *start, attempt, &taken);
    if (static_cast<int>(region.samples.size()) < options.min_samples) {
      for (const int i : region.samples) taken[i] = i == seed ? attempt : 0;
    } else if (may_bend(samples, region, options)) {
      // Smaller pieces of a bent surface would pass for planes: no seed among them.
      for (const int i : region.samples) {
        taken[i] = 0;
        bent[i] = 1;
      }
    } else {
      planes.push_back(std::move(region));
    }
  }
  return join_coplanar(samples, std::move(planes), options);
}

}  // namespace quadrille
