#include "planes/planes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/symmetric_eigen.hpp"
#include "samples/height_fit.hpp"
#include "samples/plane_sums.hpp"

namespace quadrille {
namespace {

// A seed needs this many neighbours to tell whether it lies in something flat.
constexpr std::size_t kMinSeedNeighbours = 5;
// A growing plane is refitted first at this many samples, then each time their number has doubled.
constexpr std::size_t kFirstRefit = 12;
// Distance from a plane that is allowed in addition to the noise, as a share of the cell size:
// cells at an edge average it off.
constexpr float kCellShare = 0.05f;
// A bend of up to this many standard deviations may hide in the noise.
constexpr double kHiddenSigmas = 2.0;
// Neighbouring samples share their noise, so that this many count as one independent measurement.
constexpr double kSamplesPerMeasurement = 4.0;
// Error of a distance by rounding, at the most [m].
constexpr double kRounding = 1e-9;

/// Fits the plane of the sums and turns its normal towards the given side.
Eigen::Vector4d plane_towards(const Eigen::Vector3f& side, const PlaneSums& sums) {
  const Eigen::Vector4d plane = sums.plane();
  return plane.head<3>().dot(side.cast<double>()) < 0 ? Eigen::Vector4d(-plane) : plane;
}

/// Seeds for planes, the flattest first: samples whose normal agrees with their neighbours' normals
/// within the angle [rad].
std::vector<int> flat_seeds(const SurfaceSamples& samples, double angle, const Mask& free) {
  const float min_cosine = static_cast<float>(std::cos(angle));
  const Eigen::Vector3f* const n = samples.n.data();
  std::vector<std::pair<float, int>> flat;
  for (int i = 0; i < samples.size(); ++i) {
    if (!free.empty() && !free[i]) continue;
    const auto around = samples.neighbours_of(i);
    if (around.size() < kMinSeedNeighbours) continue;
    float sum = 0;
    for (const int j : around) sum += n[i].dot(n[j]);
    const float mean = sum / static_cast<float>(around.size());
    if (mean >= min_cosine) flat.emplace_back(-mean, i);
  }
  std::sort(flat.begin(), flat.end());
  std::vector<int> seeds;
  seeds.reserve(flat.size());
  for (const auto& [key, i] : flat) seeds.push_back(i);
  return seeds;
}

/// Fits a quadratic height over the plane; returns the curvature in the direction of the largest
/// bend and its standard deviation [1/m].
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
  const double variance =
      std::max(1e-12, fit.rss(a)) / std::max(1.0, n / kSamplesPerMeasurement - 6);
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

/// Returns false only if the region is shown to be flat: it does not bend significantly, and any
/// bend hidden in the noise is small. Narrow strips of cylinders are not shown to be flat.
bool may_bend(const SurfaceSamples& samples, const PlaneRegion& region,
              const PlaneOptions& options) {
  const auto [curvature, std] = curvature_of(samples, region);
  return (curvature > 1.0 / options.min_radius && curvature > options.sigmas * std) ||
         curvature + kHiddenSigmas * std > 1.0 / options.min_proven_radius;
}

/// A plane with what its comparison with others needs.
struct PlanePart {
  PlaneRegion plane;
  PlaneSums sums;
  /// Mean noise of the samples that it was found on [m].
  double sigma = 0.0;

  PlanePart(const SurfaceSamples& samples, PlaneRegion region) : plane(std::move(region)) {
    const double n = static_cast<double>(plane.samples.size());
    for (const int i : plane.samples) {
      sums.add(samples.raw[i].cast<double>());
      sigma += samples.sigma[i] / n;
    }
  }

  Eigen::Vector3d middle() const { return sums.sum / sums.n; }

  /// Takes over the samples of another plane.
  void add(const SurfaceSamples& samples, const std::vector<int>& more) {
    plane.samples.insert(plane.samples.end(), more.begin(), more.end());
    for (const int i : more) sums.add(samples.raw[i].cast<double>());
    plane.plane = plane_towards(plane.plane.head<3>().cast<float>(), sums);
  }
};

/// True if two planes are nearly parallel and the smaller lies on the larger within the noise or
/// within the waviness allowed for their distance.
bool are_coplanar(const SurfaceSamples& samples, const PlanePart& large, const PlanePart& small,
                  double min_cosine, double sigmas) {
  // If the viewpoint lies nearly in the plane, its parts' normals point to either side by chance,
  // so signs are ignored.
  const Eigen::Vector4d& P = large.plane.plane;
  const double cosine = P.head<3>().dot(small.plane.plane.head<3>());
  if (std::abs(cosine) < min_cosine) return false;
  const Eigen::Vector3d middle = small.middle();
  const double apart = (large.middle() - middle).norm();
  const double limit = std::max(sigmas * small.sigma, kMaxWaviness * apart);
  // The samples' mean distance is no less than the distance of their mean, so most planes need no
  // look at their samples.
  if (std::abs(P.dot(middle.homogeneous())) > limit + kRounding) return false;
  const double n = static_cast<double>(small.plane.samples.size());
  double distance = 0.0;
  for (const int i : small.plane.samples) {
    distance += std::abs(P.dot(samples.raw[i].cast<double>().homogeneous())) / n;
  }
  return distance < limit;
}

/// Joins planes that noise or an object in between has split, each with the first coplanar one that
/// has more samples.
std::vector<PlaneRegion> join_coplanar(const SurfaceSamples& samples,
                                       std::vector<PlaneRegion> planes,
                                       const PlaneOptions& options) {
  std::stable_sort(planes.begin(), planes.end(), [](const PlaneRegion& a, const PlaneRegion& b) {
    return a.samples.size() > b.samples.size();
  });
  const double min_cosine = std::cos(options.angle);
  std::vector<PlanePart> parts;
  for (PlaneRegion& plane : planes) {
    PlanePart part(samples, std::move(plane));
    const auto host = std::find_if(parts.begin(), parts.end(), [&](const PlanePart& large) {
      return are_coplanar(samples, large, part, min_cosine, options.sigmas);
    });
    if (host == parts.end()) {
      parts.push_back(std::move(part));
    } else {
      host->add(samples, part.plane.samples);
    }
  }
  std::vector<PlaneRegion> joined;
  joined.reserve(parts.size());
  for (PlanePart& part : parts) joined.push_back(std::move(part.plane));
  return joined;
}

/// The plane through a seed and its free neighbours; nullopt if there are too few.
std::optional<Eigen::Vector4d> plane_at(const SurfaceSamples& samples, int seed,
                                        const std::vector<int>& taken) {
  PlaneSums sums;
  sums.add(samples.raw[seed].cast<double>());
  for (const int j : samples.neighbours_of(seed)) {
    if (!taken[j]) sums.add(samples.raw[j].cast<double>());
  }
  if (sums.n < 3) return std::nullopt;
  return plane_towards(samples.n[seed], sums);
}

/// Adds those samples of a region that are not in the sums yet.
void add_samples_to(PlaneSums* sums, const SurfaceSamples& samples,
                    const std::vector<int>& region) {
  for (auto k = static_cast<std::size_t>(sums->n); k < region.size(); ++k) {
    sums->add(samples.raw[region[k]].cast<double>());
  }
}

/// Grows a plane over free neighbours that are near it and parallel to it, and marks them with the
/// number of the attempt.
/// @param start  the first plane, which the region keeps
/// @param sums   receives the sums over the samples at the last refit; most attempts end before one
PlaneRegion grow_plane(const SurfaceSamples& samples, const PlaneOptions& options, int seed,
                       const Eigen::Vector4d& start, int attempt, std::vector<int>* taken,
                       PlaneSums* sums) {
  const float min_cosine = static_cast<float>(std::cos(options.angle));
  const float sigmas = static_cast<float>(options.sigmas);
  // Most time is spent here, so indices are not checked.
  const Eigen::Vector3f *const raw = samples.raw.data(), *const n = samples.n.data();
  const float *const sigma = samples.sigma.data(), *const cell = samples.cell.data();
  int* const taken_by = taken->data();
  PlaneRegion region{start, {seed}};
  Eigen::Vector4f P = start.cast<float>();
  std::size_t refit_at = kFirstRefit;
  for (std::size_t k = 0; k < region.samples.size(); ++k) {
    for (const int j : samples.neighbours_of(region.samples[k])) {
      if (taken_by[j]) continue;
      const float distance = P.dot(raw[j].homogeneous());
      const float limit = sigmas * sigma[j] + kCellShare * cell[j];
      if (std::abs(distance) > limit || P.head<3>().dot(n[j]) < min_cosine) continue;
      taken_by[j] = attempt;
      region.samples.push_back(j);
    }
    if (region.samples.size() >= refit_at) {
      add_samples_to(sums, samples, region.samples);
      P = plane_towards(n[seed], *sums).cast<float>();
      refit_at = region.samples.size() * 2;
    }
  }
  return region;
}

}  // namespace

Eigen::Vector3d middle_of(const SurfaceSamples& samples, const PlaneRegion& plane) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int i : plane.samples) sum += samples.raw[i].cast<double>();
  return sum / static_cast<double>(plane.samples.size());
}

std::vector<PlaneRegion> find_planes(const SurfaceSamples& samples, const PlaneOptions& options,
                                     const Mask& free) {
  std::vector<PlaneRegion> planes;
  // Per sample: 0 if free, otherwise the number of the attempt that took it; 1 if not to be used.
  std::vector<int> taken(static_cast<std::size_t>(samples.size()), 0);
  for (std::size_t i = 0; i < free.size(); ++i) taken[i] = !free[i];
  std::vector<char> bent(taken.size(), 0);
  int attempt = 1;
  for (const int seed : flat_seeds(samples, options.angle, free)) {
    if (taken[seed] || bent[seed]) continue;
    taken[seed] = ++attempt;
    const std::optional<Eigen::Vector4d> start = plane_at(samples, seed, taken);
    if (!start) continue;
    PlaneSums sums;
    PlaneRegion region = grow_plane(samples, options, seed, *start, attempt, &taken, &sums);
    if (static_cast<int>(region.samples.size()) < options.min_samples) {
      for (const int i : region.samples) taken[i] = i == seed ? attempt : 0;
      continue;
    }
    add_samples_to(&sums, samples, region.samples);
    if (sums.n >= 3) region.plane = plane_towards(samples.n[seed], sums);
    if (may_bend(samples, region, options)) {
      // Smaller pieces of a bent surface would pass for planes, so none of its samples becomes a
      // seed.
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

std::optional<Eigen::Vector3d> normal_of_largest(const std::vector<PlaneRegion>& planes) {
  const auto largest = std::max_element(planes.begin(), planes.end(),
                                        [](const PlaneRegion& a, const PlaneRegion& b) {
                                          return a.samples.size() < b.samples.size();
                                        });
  if (largest == planes.end()) return std::nullopt;
  return largest->plane.head<3>();
}

}  // namespace quadrille
