#include "quadrille/detector/evidence.hpp"

#include <algorithm>
#include <cmath>

#include "quadrille/detector/region.hpp"
#include "quadrille/detector/two_planes.hpp"

namespace quadrille {
namespace {

/// Share of the border where the surface goes on smoothly. Windows of neighbouring normals overlap,
/// so that even a crease looks smooth from one sample to the next: the walk goes one sample
/// further before it compares the normals.
double smooth_border(const SurfaceSamples& samples, std::span<const int> region) {
  constexpr float kSmooth = 0.87f;  // 30°
  std::vector<char> inside(static_cast<std::size_t>(samples.size()), 0);
  for (const int i : region) inside[i] = 1;
  double border = 0, smooth = 0;
  for (const int i : region) {
    int within = 0;
    for (const int j : samples.neighbours_of(i)) {
      if (inside[j]) {
        ++within;
        continue;
      }
      const Eigen::Vector3f step = samples.raw[j] - samples.raw[i];
      int next = -1;
      float most = 0.5f * step.squaredNorm();
      for (const int k : samples.neighbours_of(j)) {
        const float along = (samples.raw[k] - samples.raw[j]).dot(step);
        if (along > most) most = along, next = k;
      }
      if (next >= 0 && !inside[next]) smooth += samples.n[next].dot(samples.n[i]) > kSmooth;
    }
    border += 8 - within;
  }
  return smooth / std::max(1.0, border);
}

}  // namespace

Evidence collect_evidence(const SurfaceSamples& samples, std::span<const int> region,
                          const Quadric& quadric) {
  Evidence e;
  const double n = static_cast<double>(region.size());
  e.log_count = std::log(n);
  double square = 1e-12 * n;
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  const Eigen::Matrix4f Q = quadric.normalized().matrix().cast<float>();
  for (const int i : region) {
    const float d = distance_to(Q, samples.raw[i]);
    square += static_cast<double>(d * d);
    mean += samples.n[i];
  }
  mean.normalize();
  std::vector<float> cosine;
  for (const int i : region) cosine.push_back(samples.n[i].dot(mean));
  const auto tenth = cosine.begin() + static_cast<std::ptrdiff_t>(cosine.size() / 10);
  std::nth_element(cosine.begin(), tenth, cosine.end());
  e.spread = std::acos(std::clamp(*tenth, -1.0f, 1.0f));
  e.smooth_border = smooth_border(samples, region);
  e.two_planes = std::log((two_planes_rss(samples, region) + 1e-12 * n) / square);
  return e;
}

double confidence(const Evidence& e, int dof) {
  const double z = -0.92 + 1.04 * e.log_count - 1.72 * e.spread - 13.9 * e.smooth_border +
                   1.69 * std::clamp(e.two_planes, -1.0, 5.0) - 0.656 * dof;
  return 1.0 / (1.0 + std::exp(-z));
}

}  // namespace quadrille
