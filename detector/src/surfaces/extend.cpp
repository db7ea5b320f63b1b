#include "surfaces/extend.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "samples/inliers.hpp"
#include "surfaces/surface_fit.hpp"

namespace quadrille {
namespace {

// Further samples are sought beyond each end by this share of the surface's extent.
constexpr float kMargin = 0.15f;
// A surface is refitted if more samples are added than its number of samples over this; two percent
// hardly change a fit.
constexpr std::size_t kRefitDivisor = 50;
// The residual of the fit to the larger region may exceed that of the smaller by this factor.
constexpr double kMaxRmsGrowth = 1.3;

}  // namespace

Extender::Extender(const SurfaceSamples& samples, const SampleBlocks& blocks,
                   const AggregateOptions& options, const InlierTest& inlier)
    : samples_(samples), options_(options), inlier_(inlier), blocks_(blocks) {
  inlier_.sigmas *= options.claim;
}

Surface Extender::extended(Surface surface, const Mask& free) const {
  const std::vector<int> more = further(surface, free);
  std::vector<int> all = surface.region;
  all.insert(all.end(), more.begin(), more.end());
  if (more.size() > surface.region.size() / kRefitDivisor) {
    std::optional<Surface> refit = fit_surface(samples_, all, options_);
    // The fit to a small region may follow its noise, so residuals within the noise are accepted
    // too.
    const double noise = mean_sigma(samples_, all);
    if (refit && refit->rms < std::max(kMaxRmsGrowth * surface.rms, noise)) {
      return std::move(*refit);
    }
  }
  surface.region = std::move(all);
  return surface;
}

std::vector<int> Extender::further(const Surface& surface, const Mask& free) const {
  const Eigen::Isometry3f Y = surface.fit.posed.X.inverse().cast<float>();
  const Eigen::Vector3f centre = surface.local.centre.cast<float>();
  const float scale = static_cast<float>(surface.local.scale);
  const auto posed = [&](int i) -> Eigen::Vector3f {
    return Y * Eigen::Vector3f((samples_.raw[i] - centre) / scale);
  };
  std::vector<char> inside(samples_.p.size(), 0);
  Eigen::AlignedBox3f box;
  float max_square = 0;
  for (const int i : surface.region) {
    inside[i] = 1;
    box.extend(posed(i));
    max_square = std::max(max_square, (samples_.raw[i] - centre).squaredNorm());
  }
  float reach = std::sqrt(max_square);
  // Other views may have seen the other side, all around the axis.
  if (!samples_.view.empty()) {
    const float around =
        box.min().head<2>().cwiseAbs().cwiseMax(box.max().head<2>().cwiseAbs()).maxCoeff();
    box.extend(Eigen::Vector3f(-around, -around, box.min().z()));
    box.extend(Eigen::Vector3f(around, around, box.max().z()));
    reach = std::max(reach, scale * box.diagonal().norm());
  }
  const Eigen::Vector3f margin = kMargin * box.sizes();
  box.extend(Eigen::Vector3f(box.min() - margin));
  box.extend(Eigen::Vector3f(box.max() + margin));
  // The corners of the box that lie far from all samples do not count.
  const float radius = reach + margin.norm() * scale;
  const Eigen::Matrix4f Q = surface.Q.matrix().cast<float>();
  std::vector<int> more;
  const Eigen::Affine3f X_BC =
      Y * Eigen::Affine3f(Eigen::Scaling(1.0f / scale)) * Eigen::Translation3f(-centre);
  for (const int i : blocks_.in_box(X_BC, box)) {
    if (!free[i] || inside[i] || (samples_.raw[i] - centre).squaredNorm() > radius * radius) {
      continue;
    }
    if (is_inlier(samples_, i, Q, inlier_) && box.contains(posed(i))) more.push_back(i);
  }
  std::sort(more.begin(), more.end());
  return more;
}

}  // namespace quadrille
