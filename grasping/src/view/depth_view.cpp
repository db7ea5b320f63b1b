#include "view/depth_view.hpp"

#include <optional>

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

/// Keeps the nearest point of each pixel, unless it is a stray.
void DepthView::keep_nearest(const PointCloud& cloud) {
  measured_.depth.assign(static_cast<std::size_t>(measured_.width) * measured_.height, 0.0f);
  std::vector<std::size_t> nearest(measured_.depth.size(), 0);
  // Unlike vectors, these do not check each access.
  const Eigen::Vector3f* points = cloud.points.data();
  float* depths = measured_.depth.data();
  for (std::size_t n = 0; n < cloud.points.size(); ++n) {
    const Eigen::Vector3d p_V = to_view(points[n].cast<double>());
    // This is also false for points that are not finite.
    if (!(p_V.z() > kMinDepth)) continue;
    const Eigen::Vector2i uv = pixel(p_V);
    if (!measured_.holds(uv.x(), uv.y())) continue;
    const std::size_t at = measured_.index(uv.x(), uv.y());
    const float depth = static_cast<float>(p_V.z());
    if (depths[at] > 0.0f && depths[at] <= depth) continue;
    depths[at] = depth;
    nearest[at] = n;
  }
  for (const std::size_t at : find_strays(measured_)) {
    measured_.depth[at] = 0.0f;
    stray_[nearest[at]] = 1;
  }
}

}  // namespace quadrille
