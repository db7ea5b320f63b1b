#include "quadrille/detector/region.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace quadrille {
namespace {

/// The k-th of a golden-ratio sequence over 0 … n-1: even, and in step with no grid, where every
/// m-th element of a region could be the same few columns.
std::size_t golden_index(std::size_t k, std::size_t n) {
  const std::uint64_t fraction = (k + 1) * 0x9e3779b97f4a7c15u;
  return static_cast<std::size_t>((fraction >> 32) * n >> 32);
}

}  // namespace

std::vector<int> spread_evenly(std::span<const int> region, std::size_t most) {
  if (region.size() <= most) return {region.begin(), region.end()};
  std::vector<int> some(most);
  for (std::size_t k = 0; k < most; ++k) some[k] = region[golden_index(k, region.size())];
  return some;
}

Quadric Normalisation::to_frame(const Eigen::Matrix4d& Q_local) const {
  Eigen::Matrix4d S = Eigen::Matrix4d::Identity();
  S.topLeftCorner<3, 3>() /= scale;
  S.topRightCorner<3, 1>() = -centre / scale;
  return Quadric(Eigen::Matrix4d(S.transpose() * Q_local * S));
}

Eigen::Matrix4d Normalisation::to_local(const Quadric& Q) const {
  Eigen::Matrix4d S = Eigen::Matrix4d::Identity();
  S.topLeftCorner<3, 3>() *= scale;
  S.topRightCorner<3, 1>() = centre;
  return S.transpose() * Q.matrix() * S;
}

Normalisation normalisation_of(const SurfaceSamples& samples, std::span<const int> region) {
  Normalisation result;
  if (region.empty()) return result;
  for (const int i : region) result.centre += samples.raw[i].cast<double>();
  result.centre /= static_cast<double>(region.size());
  double square = 0;
  for (const int i : region)
    square += (samples.raw[i].cast<double>() - result.centre).squaredNorm();
  result.scale = std::max(1e-6, std::sqrt(square / static_cast<double>(region.size())));
  return result;
}

FitPoints fit_points(const SurfaceSamples& samples, std::span<const int> region,
                     const Normalisation& normalisation, int most) {
  const std::size_t size = std::min<std::size_t>(region.size(), most);
  FitPoints points(static_cast<Eigen::Index>(size));
  const Eigen::Vector3f centre = normalisation.centre.cast<float>();
  const float inverse = static_cast<float>(1.0 / normalisation.scale);
  for (std::size_t k = 0; k < size; ++k) {
    const int i = region[size == region.size() ? k : golden_index(k, region.size())];
    const Eigen::Vector3f x = (samples.raw[i] - centre) * inverse;
    points.x[k] = x.x(), points.y[k] = x.y(), points.z[k] = x.z();
    points.nx[k] = samples.n[i].x(), points.ny[k] = samples.n[i].y(),
    points.nz[k] = samples.n[i].z();
  }
  return points;
}

bool is_inlier(const SurfaceSamples& samples, int i, const Eigen::Matrix4f& Q,
               const InlierTest& test) {
  const Eigen::Vector4f x = samples.raw[i].homogeneous();
  const Eigen::Vector4f h = Q * x;
  const float f = x.dot(h);
  const Eigen::Vector3f g = h.head<3>();
  const float slope = g.norm();
  const float limit = static_cast<float>(test.sigmas) * samples.sigma[i] +
                      static_cast<float>(test.cells) * samples.cell[i];
  return std::abs(f) <= 2.0f * slope * limit &&
         std::abs(g.dot(samples.n[i])) >= static_cast<float>(test.least_cosine) * slope;
}

std::vector<int> connected_inliers(const SurfaceSamples& samples, std::span<const int> start,
                                   const Quadric& quadric, const InlierTest& test,
                                   const std::vector<char>& free) {
  const Eigen::Matrix4f Q = quadric.normalized().matrix().cast<float>();
  std::vector<char> seen(static_cast<std::size_t>(samples.size()), 0);
  std::vector<int> region;
  const auto visit = [&](int i) {
    if (seen[i]) return;
    seen[i] = 1;
    if (free[i] && is_inlier(samples, i, Q, test)) region.push_back(i);
  };
  for (const int i : start) visit(i);
  for (std::size_t k = 0; k < region.size(); ++k) {
    for (const int j : samples.neighbours_of(region[k])) visit(j);
  }
  return region;
}

double effective_share(const SurfaceSamples& samples, std::span<const int> region,
                       const Quadric& quadric) {
  const Eigen::Matrix4f Q = quadric.normalized().matrix().cast<float>();
  std::vector<float> residual(static_cast<std::size_t>(samples.size()), 0.0f);
  std::vector<char> inside(residual.size(), 0);
  double square = 0;
  for (const int i : region) {
    residual[i] = distance_to(Q, samples.raw[i]);
    inside[i] = 1;
    square += residual[i] * residual[i];
  }
  double product = 0;
  std::size_t pairs = 0;
  for (const int i : region) {
    for (const int j : samples.neighbours_of(i)) {
      if (!inside[j]) continue;
      product += residual[i] * residual[j];
      ++pairs;
    }
  }
  if (pairs == 0 || !(square > 0)) return 1.0;
  const double variance = square / static_cast<double>(region.size());
  const double rho = std::clamp(product / (static_cast<double>(pairs) * variance), 0.0, 0.98);
  const double ratio = (1 - rho) / (1 + rho);
  return ratio * ratio;
}

}  // namespace quadrille
