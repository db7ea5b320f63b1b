#include "surfaces/evidence.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "samples/inliers.hpp"
#include "samples/region.hpp"
#include "surfaces/smooth_parts.hpp"
#include "surfaces/two_planes.hpp"

namespace quadrille {
namespace {

// Real objects are quadrics up to this share of their size.
constexpr double kFlaw = 0.02;

/// The neighbour of j that lies farthest on in the direction of a step to it; -1 if none does.
int next_along(const SurfaceSamples& samples, int j, const Eigen::Vector3f& step) {
  int next = -1;
  float most = 0.5f * step.squaredNorm();
  for (const int k : samples.neighbours_of(j)) {
    const float along = (samples.raw[k] - samples.raw[j]).dot(step);
    if (along > most) most = along, next = k;
  }
  return next;
}

/// Angle between normals and their mean, 90th percentile [rad].
double spread_about(const SurfaceSamples& samples, std::span<const int> region,
                    const Eigen::Vector3f& mean) {
  std::vector<float> cosine;
  for (const int i : region) cosine.push_back(samples.n[i].dot(mean));
  const auto tenth = cosine.begin() + static_cast<std::ptrdiff_t>(cosine.size() / 10);
  std::nth_element(cosine.begin(), tenth, cosine.end());
  return std::acos(std::clamp(*tenth, -1.0f, 1.0f));
}

/// Distances of the region's samples in multiples of what noise and small flaws leave, per sample.
std::vector<float> residuals(const SurfaceSamples& samples, std::span<const int> region,
                             const std::vector<float>& distance, double scale) {
  const float flaw = static_cast<float>(kFlaw * scale);
  std::vector<float> residual(static_cast<std::size_t>(samples.size()), 0.0f);
  for (std::size_t k = 0; k < region.size(); ++k) {
    const float sigma = samples.sigma[region[k]];
    residual[region[k]] = distance[k] / std::sqrt(sigma * sigma + flaw * flaw);
  }
  return residual;
}

/// Fills in the evidence that lies in the neighbours, of the region's border and misfit. Windows of
/// neighbouring normals overlap, so that even a crease looks smooth from one sample to the next:
/// the walk goes one sample further before it compares the normals.
void walk_neighbours(const SurfaceSamples& samples, std::span<const int> region,
                     const std::vector<char>& inside, std::span<const char> beyond,
                     const std::vector<float>& residual, Evidence* e) {
  double border = 0, smooth = 0, open = 0, edge = 0, square = 0;
  for (const int i : region) {
    int within = 0;
    float sum = residual[i];
    const std::span<const int> neighbours = samples.neighbours_of(i);
    for (const int j : neighbours) {
      if (inside[j]) {
        ++within;
        sum += residual[j];
        continue;
      }
      const int next = next_along(samples, j, samples.raw[j] - samples.raw[i]);
      if (next >= 0 && !inside[next] && (beyond.empty() || !beyond[next])) {
        smooth += samples.n[next].dot(samples.n[i]) > kMinSmoothCosine;
      }
    }
    border += 8 - within;
    open += within < static_cast<int>(neighbours.size());
    edge += neighbours.size() < 8;
    const float mean = sum / static_cast<float>(within + 1);
    square += static_cast<double>(mean * mean);
  }
  const double n = static_cast<double>(region.size());
  e->smooth_border = smooth / std::max(1.0, border);
  e->open_border = open / n;
  e->depth_edge = edge / n;
  // What neighbours have in common of the noise does not average out.
  e->misfit = std::sqrt(square / n / (1.0 + 2.0 * samples.common_noise));
}

double thickness_of(const SurfaceSamples& samples, std::span<const int> region,
                    const Normalisation& local) {
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
  for (const int i : region) {
    const Eigen::Vector3d x = (samples.raw[i].cast<double>() - local.centre) / local.scale;
    square += x * x.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(square, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d v = eigen.eigenvalues();
  return std::sqrt(std::max(0.0, v[0]) / v[2]);
}

}  // namespace

Evidence collect_evidence(const SurfaceSamples& samples, std::span<const int> region,
                          const Quadric& quadric, std::span<const char> beyond) {
  Evidence e;
  const double n = static_cast<double>(region.size());
  double square = 1e-12 * n;
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  const Eigen::Matrix4f Q = quadric.normalized().matrix().cast<float>();
  std::vector<char> inside(static_cast<std::size_t>(samples.size()), 0);
  std::vector<float> distance(region.size());
  for (std::size_t k = 0; k < region.size(); ++k) {
    const int i = region[k];
    const float d = distance[k] = distance_to(Q, samples.raw[i]);
    square += static_cast<double>(d * d);
    mean += samples.n[i];
    inside[i] = 1;
  }
  mean.normalize();
  const Normalisation local = normalisation_of(samples, region);
  e.log_count = std::log(n);
  e.spread = spread_about(samples, region, mean);
  e.thickness = thickness_of(samples, region, local);
  e.two_planes = std::log((two_planes_rss(samples, region) + 1e-12 * n) / square);
  const std::vector<float> residual = residuals(samples, region, distance, local.scale);
  walk_neighbours(samples, region, inside, beyond, residual, &e);
  return e;
}

double confidence(const Evidence& e, int dof, double log_prior) {
  // A logistic regression over some 2800 surfaces, labelled by the truth of generated scenes, with
  // waves in their noise and without, and of real scans, whose surfaces count threefold. The scenes
  // hold no types that few objects have: the prior speaks for those.
  const double two_planes = std::clamp(e.two_planes, -2.0, 5.0);
  // What many samples explain hardly better than two planes do is a box edge.
  const double edge = std::max(0.0, e.log_count - 5.0) * std::max(0.0, 0.8 - two_planes);
  const double z = log_prior - 8.75 + 2.46 * std::min(e.log_count, 6.0) - 1.2 * e.spread -
                   12.8 * e.smooth_border - 0.906 * e.open_border - 6.22 * e.depth_edge -
                   1.83 * e.thickness + 0.645 * two_planes - 2.23 * edge - 0.66 * dof -
                   3.51 * std::log(std::clamp(e.misfit, 0.05, 6.0)) -
                   0.327 * std::log(0.05 + e.remainder);
  return 1.0 / (1.0 + std::exp(-z));
}

}  // namespace quadrille
