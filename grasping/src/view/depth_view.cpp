#include "view/depth_view.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "quadrille/detector/vector_clones.hpp"
#include "view/gaps.hpp"

namespace quadrille {

namespace {

// Limits the memory to about 100 MB. Only disordered points lead to more pixels than any camera
// has.
constexpr double kMaxPixels = 4e6;

}  // namespace

DepthView::DepthView(const PointCloud& cloud, double baseline, double thin)
    : p_CV_(cloud.viewpoint) {
  stray_.assign(cloud.points.size(), 0);
  if (!p_CV_.allFinite()) return;
  const std::optional<PinholeView> view = look_from_viewpoint(cloud);
  if (!view) return;
  place(*view, find_pixels(cloud, *view, kMaxPixels));
  keep_nearest(cloud);
  // Two passes fill holes that are three pixels wide.
  measured_ = fill_holes(fill_holes(measured_));
  // Only in the optical convention do the rows run along the sensor's baseline.
  const GapRules rules{R_VC_.isIdentity() ? baseline : 0.0, thin};
  image_ = fill_gaps(measured_, pitch_.matrix(), rules);
  bounds_ = DepthBounds(image_, measured_);
}

void DepthView::place(const PinholeView& view, const PinholeImage& image) {
  // Normalising makes it a rotation to the last bits of a double.
  R_VC_ = Eigen::Quaterniond(Eigen::Matrix3d(view.X_VC.linear().cast<double>()))
              .normalized()
              .toRotationMatrix();
  spread_ = R_VC_.cwiseAbs().rowwise().sum();
  pitch_ = image.pitch.cast<double>();
  pixels_ = pitch_.inverse();
  // The centre of the first pixel lies half a step from its corner.
  const Eigen::Array2d centre = -image.corner.cast<double>() / pitch_ - 0.5;
  cu_ = centre.x();
  cv_ = centre.y();
  measured_.width = image.width;
  measured_.height = image.height;
}

/// Some points, the depths at which the view sees them, and the indices of their pixels; −1 for
/// those that it does not see.
struct DepthView::Projected {
  // So few that all stay in the L1 cache.
  static constexpr std::size_t kMost = 64;
  std::array<double, kMost> x, y, z;
  std::array<float, kMost> depth;
  std::array<int, kMost> pixel;
};

/// Does for many points what to_view() and pixel() do for one, with the same bits.
/// @param points  with their positions from the viewpoint on, along the axes of C
QUADRILLE_VECTOR_CLONES
void DepthView::project(Projected& points) const {
  const Eigen::Matrix3d& R = R_VC_;
  const double xx = R(0, 0), xy = R(0, 1), xz = R(0, 2), yx = R(1, 0), yy = R(1, 1), yz = R(1, 2);
  const double zx = R(2, 0), zy = R(2, 1), zz = R(2, 2);
  const double du = pixels_.x(), dv = pixels_.y(), cu = cu_, cv = cv_;
  const double width = measured_.width, height = measured_.height;
  const int row = measured_.width;
  // Unlike arrays, these do not check each access.
  const double *px = points.x.data(), *py = points.y.data(), *pz = points.z.data();
  float* __restrict depth = points.depth.data();
  int* __restrict pixel = points.pixel.data();
  for (std::size_t n = 0; n < Projected::kMost; ++n) {
    // The order of these sums is that of Eigen's product.
    const double x = (xx * px[n] + xy * py[n]) + xz * pz[n];
    const double y = (yx * px[n] + yy * py[n]) + yz * pz[n];
    const double z = zx * px[n] + (zy * py[n] + zz * pz[n]), inverse = 1.0 / z;
    const double u = x * inverse * du + cu + 0.5, v = y * inverse * dv + cv + 0.5;
    // This is also false for points that are not finite.
    const bool seen = (z > kMinDepth) & (u >= 0.0) & (v >= 0.0) & (u < width) & (v < height);
    const int column = static_cast<int>(seen ? u : 0.0), line = static_cast<int>(seen ? v : 0.0);
    pixel[n] = seen ? line * row + column : -1;
    depth[n] = static_cast<float>(z);
  }
}

/// Keeps the nearest point of each pixel, unless it is a stray.
void DepthView::keep_nearest(const PointCloud& cloud) {
  measured_.depth.assign(static_cast<std::size_t>(measured_.width) * measured_.height, 0.0f);
  std::vector<std::uint32_t> nearest(measured_.depth.size(), 0);
  // Unlike vectors, these do not check each access.
  const Eigen::Vector3f* points = cloud.points.data();
  float* depths = measured_.depth.data();
  std::uint32_t* indices = nearest.data();
  Projected some{};
  for (std::size_t first = 0; first < cloud.points.size(); first += Projected::kMost) {
    const std::size_t count = std::min(Projected::kMost, cloud.points.size() - first);
    for (std::size_t n = 0; n < count; ++n) {
      const Eigen::Vector3f& p_C = points[first + n];
      some.x.data()[n] = static_cast<double>(p_C.x()) - p_CV_.x();
      some.y.data()[n] = static_cast<double>(p_C.y()) - p_CV_.y();
      some.z.data()[n] = static_cast<double>(p_C.z()) - p_CV_.z();
    }
    project(some);
    for (std::size_t n = 0; n < count; ++n) {
      const int at = some.pixel.data()[n];
      const float depth = some.depth.data()[n];
      if (at < 0 || (depths[at] > 0.0f && depths[at] <= depth)) continue;
      depths[at] = depth;
      indices[at] = static_cast<std::uint32_t>(first + n);
    }
  }
  for (const std::size_t at : find_strays(measured_)) {
    measured_.depth[at] = 0.0f;
    stray_[nearest[at]] = 1;
  }
}

}  // namespace quadrille
